#!/usr/bin/python3
"""Runs that scripts/run starts, ended from outside.

    launched.py VALSALVA ROOT terminated    SIGTERM to mpirun on a busy machine leaves a checkpoint to continue from
    launched.py VALSALVA ROOT interrupted   Ctrl-C ends the run at once; exit codes pass through; a rank that crashes ends all
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import h5py

program, root, scenario = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
BETWEEN_SIGNALS_S = 6  # of mpirun, here; scripts/run has more patience
found = []


def expect(holds, message):
    if not holds:
        found.append(message)


def start(case, out, *more):
    command = [str(root / "scripts" / "run"), str(root / "cases" / case), "-o", str(out)]
    for key in ["output.pictures=false", "checkpoint.every_wall_s=0", *more]:
        command += ["--set", key]
    environment = {"VALSALVA": program, "RANKS": "2", "OMPI_MCA_odls_base_sigkill_timeout": str(BETWEEN_SIGNALS_S)}
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            env=os.environ | environment, start_new_session=True)


def children(pid):
    return [int(child) for task in pathlib.Path(f"/proc/{pid}/task").iterdir()
            for child in (task / "children").read_text().split()]


def wait_for(path, process):
    for _ in range(600):
        if path.exists() or process.poll() is not None:
            return
        time.sleep(0.1)


def expect_stopped(process, out):
    said = "".join(process.communicate(timeout=100))
    expect(process.returncode == 0, f"exit code {process.returncode}\n{said}")
    outcome = json.loads((out / "run.json").read_text())["outcome"]
    expect(outcome == "stopped by a signal", f"run.json says {outcome}\n{said}")
    checkpoints = list((out / "checkpoints").iterdir())
    expect([path.suffix for path in checkpoints] == [".h5"], f"checkpoints: {checkpoints}")
    with h5py.File(checkpoints[0]) as file:
        expect(file["step"][()] > 0, "a checkpoint of no step")


def terminated(scratch):
    busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(max(2, os.cpu_count() or 2))]
    try:
        out = scratch / "out"
        process = start("aortic_root", out, "output.fields_every_s=0.001")
        wait_for(out / "fields" / "fields_0001.hdf", process)
        (mpirun,) = children(process.pid)
        os.kill(mpirun, signal.SIGTERM)
        expect_stopped(process, out)
    finally:
        for loop in busy:
            loop.kill()
            loop.wait()


def interrupted(scratch):
    out = scratch / "out"
    process = start("aortic_root", out, "grid.finest_cm=0.208333", "output.fields_every_s=0.001")
    wait_for(out / "fields" / "fields_0001.hdf", process)
    begun = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)
    expect_stopped(process, out)
    expect(time.monotonic() - begun < BETWEEN_SIGNALS_S, "Ctrl-C waited for mpirun")

    begun = time.monotonic()
    for case, more, code in [("lumped_heart", ["time.end_s=-1"], 2), ("lumped_heart", ["time.end_s=0.8"], 0)]:
        process = start(case, scratch / "heart", *more)
        said = "".join(process.communicate(timeout=100))
        expect(process.returncode == code, f"exit code {process.returncode}, expected {code}\n{said}")
    expect(time.monotonic() - begun < 2 * BETWEEN_SIGNALS_S, "a refused case waited for mpirun")

    out = scratch / "crashed"
    process = start("aortic_root", out, "grid.finest_cm=0.208333", "output.fields_every_s=0.001")
    wait_for(out / "fields" / "fields_0001.hdf", process)
    (mpirun,) = children(process.pid)
    (rank,) = children(children(mpirun)[1])
    os.kill(rank, signal.SIGSEGV)
    process.communicate(timeout=100)
    expect(process.returncode not in (0, None), "a rank crashed unnoticed")


with tempfile.TemporaryDirectory() as folder:
    {"terminated": terminated, "interrupted": interrupted}[scenario](pathlib.Path(folder))
print("\n".join(found))
sys.exit(1 if found else 0)
