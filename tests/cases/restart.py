#!/usr/bin/python3
"""Runs that are interrupted and continued match the uninterrupted run bit for bit.

    restart.py VALSALVA ROOT killed|stopped|extended|refused
"""
import json
import pathlib
import random
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

program, root, scenario = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
END_S = 0.02
KILLS = 10
found = []


def expect(holds, message):
    if not holds:
        found.append(message)


def start(out, *more, end_s=END_S):
    """The coarse aortic root with a pressure that rises immediately, and a checkpoint after every step."""
    command = [program, "run", str(root / "cases" / "aortic_root"), "-o", str(out)]
    for key in ["grid.finest_cm=0.208333", "output.pictures=false", "output.fields_every_s=0.004", "time.period_s=0.8",
                "output.structure_every_s=0.004", "checkpoint.every_wall_s=1e-9",
                "element.ventricle.time_s=[0.0, 0.002, 0.15]", "element.ventricle.pressure_mmHg=[0.0, 20.0, 120.0]",
                "element.arteries.pressurise_s=0.0", "element.arteries.initial_pressure_mmHg=0.0", f"time.end_s={end_s}"]:
        command += ["--set", key]
    return subprocess.Popen(command + list(more), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def end(process, code=0):
    said = process.communicate(timeout=100)
    expect(process.returncode == code, f"exit code {process.returncode}, expected {code}\n{said[0]}{said[1]}")
    return said[0] + said[1]


def checkpoints(out, ending=".h5"):
    """{step: file} of the complete checkpoints, or with ".h5.part" of those being written."""
    return {int(path.name.split("_")[1].split(".")[0]): path for path in out.glob(f"checkpoints/*{ending}")}


def wait_until(holds, process):
    while process.poll() is None and not holds():
        time.sleep(0.0005)


def arrays(path):
    values = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: values.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    return values


def expect_same_arrays(a, b, but=()):
    one, other = arrays(a), arrays(b)
    expect(one.keys() == other.keys(), f"{b.name} has other arrays than the uninterrupted run")
    for name in one.keys() - set(but):
        expect(numpy.array_equal(one[name], other.get(name)), f"{b.name}: {name} differs from the uninterrupted run")


def rows(path):
    """The rows of a CSV without the wall-clock time."""
    cells = [line.split(",") for line in path.read_text().splitlines()]
    return [[value for name, value in zip(cells[0], row) if name != "wall_s"] for row in cells]


def expect_same_end(whole, out):
    for name in ["step.csv", "openings.csv", "probes.csv", "beats.csv"]:
        expect(rows(whole / name) == rows(out / name), f"{name} differs from the uninterrupted run")
    expect(abs(float(rows(out / "openings.csv")[-1][0]) - END_S) < 1e-9, "openings.csv does not reach the end time")
    for name in ["fields/fields.hdf.series", "structure/leaflets.hdf.series"]:
        expect((whole / name).read_text() == (out / name).read_text(), f"{name} differs")
        for entry in json.loads((out / name).read_text())["files"]:
            path = pathlib.Path(name).parent / entry["name"]
            expect_same_arrays(whole / path, out / path)
    last = max(checkpoints(whole))
    expect(max(checkpoints(out)) == last, f"the last checkpoint is {max(checkpoints(out))}, not {last}")
    expect_same_arrays(checkpoints(whole)[last], checkpoints(out)[last], but=["wall_s", "case", "traces/step_bytes"])
    expect(len(checkpoints(out)) <= 2, f"more than two checkpoints were kept: {sorted(checkpoints(out))}")
    record = json.loads((out / "run.json").read_text())
    expect(record["outcome"] == "finished" and record["steps"] == last, f"run.json: {record}")


def killed(whole, out):
    """SIGKILL at random moments, half of them while a checkpoint is being written, one while the run starts."""
    end(start(whole))
    moments = random.Random(5)
    steps = sorted(moments.sample(range(1, max(checkpoints(whole)) - 20), KILLS - 1))
    torn = 0
    for number, step in enumerate([0] + steps):
        process = start(out, "--restart", "latest", "--force")
        if number == 0:
            time.sleep(moments.uniform(0.0, 0.2))
        elif number % 2:
            wait_until(lambda: max(checkpoints(out, ".h5.part"), default=0) >= step, process)
        else:
            wait_until(lambda: max(checkpoints(out), default=0) >= step, process)
            time.sleep(moments.uniform(0.0, 0.02))
        expect(process.poll() is None, f"the run ended before it could be killed in step {step}")
        process.kill()
        process.wait()
        torn += bool(checkpoints(out, ".h5.part"))
    print(f"{torn} of {KILLS} kills left an incomplete checkpoint")
    expect(torn > 0, "no kill hit a checkpoint that was being written")
    end(start(out, "--restart", "latest", "--force"))
    expect_same_end(whole, out)
    expect(not checkpoints(out, ".h5.part"), "incomplete checkpoints were left behind")


def stopped(whole, out):
    """SIGTERM writes a checkpoint and prints the command that continues the run; this command works."""
    end(start(whole))
    process = start(out, "--set", "checkpoint.every_wall_s=0")
    wait_until(lambda: (out / "fields" / "fields_0001.hdf").exists(), process)
    process.send_signal(signal.SIGTERM)
    said = end(process)
    t = rows(out / "step.csv")[-1][1]
    expect(float(t) < END_S, f"the run was not stopped: it is at {t} s")
    expect(len(checkpoints(out)) == 1, f"checkpoints: {sorted(checkpoints(out))}")
    told = [line for line in said.splitlines() if line.startswith("to continue: valsalva ")]
    expect(len(told) == 1 and str(*checkpoints(out).values()) in said, f"no command to continue:\n{said}")
    wall_before = json.loads((out / "run.json").read_text())["wall_s"]
    again = [program] + shlex.split(told[0])[3:]
    expect("continued  from" in end(subprocess.Popen(again, stdout=-1, stderr=-1, text=True)), "the continuation is not reported")
    expect_same_end(whole, out)
    expect(json.loads((out / "run.json").read_text())["wall_s"] > wall_before, "the wall time of the first part is lost")
    log = (out / "log.txt").read_text()
    expect("stopped at" in log and "continued  from" in log, "log.txt does not contain both parts")


def extended(whole, out):
    """A finished run that is extended matches one with the later end from the start."""
    end(start(whole))
    end(start(out, end_s=0.008))
    expect(rows(out / "beats.csv")[-1][0] == "1", "no row for the last, incomplete beat")
    end(start(out, "--restart", "latest"))
    expect_same_end(whole, out)
    end(start(out, "--restart", "latest"))  # nothing left to do
    expect_same_end(whole, out)


def refused(whole, out):
    """Restarts of another case and from unreadable checkpoints are refused."""
    end(start(whole))
    before = rows(whole / "step.csv")
    said = end(start(whole, "--restart", "latest", "--set", "fluid.viscosity_g_cm_s=0.05"), 2)
    expect("fluid.viscosity_g_cm_s: is 0.05 now, was 0.04" in said, said)
    said = end(start(whole, "--restart", "latest", "--set", "time.period_s=0.7"), 2)
    expect("time.period_s" in said and "set time.period_s = 0.8" in said, said)
    expect("time.end_s: lies before" in end(start(whole, "--restart", "latest", end_s=0.01), 2), "an end in the past")
    end(start(whole, "--restart", str(whole / "checkpoints" / "missing.h5")), 4)
    expect(rows(whole / "step.csv") == before, "a refused restart has changed step.csv")

    shutil.copytree(whole, out)
    older, newest = sorted(checkpoints(out).values())
    newest.write_bytes(newest.read_bytes()[:100000])
    said = end(start(out, "--restart", "latest"))
    expect("skipped" in said and f"continued  from {older}" in said, said)
    expect_same_end(whole, out)
    (out / "probes.csv").write_text((out / "probes.csv").read_text()[:1000])
    expect("rows that were there at the checkpoint are missing" in end(start(out, "--restart", "latest"), 4), "lost rows")
    for path in checkpoints(out).values():
        path.write_bytes(b"nothing")
    expect("no checkpoint" in end(start(out, "--restart", "latest", "--force"), 4), "all checkpoints were unreadable")
    shutil.rmtree(out / "checkpoints")
    expect("add --force to start again" in end(start(out, "--restart", "latest"), 2), "a run without checkpoints")


with tempfile.TemporaryDirectory() as scratch:
    scenarios = {"killed": killed, "stopped": stopped, "extended": extended, "refused": refused}
    scenarios[scenario](pathlib.Path(scratch, "whole"), pathlib.Path(scratch, "out"))
print("\n".join(found))
sys.exit(1 if found else 0)
