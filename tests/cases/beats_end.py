#!/usr/bin/python3
"""Runs of several beats end when the beats repeat, and their balances of volume and energy close.

    beats_end.py VALSALVA ROOT repeating|continued|balanced
"""
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

program, root, scenario = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
TUBE_TOLERANCE = 0.01
COMPARED = ["stroke_volume_ml", "p_ao_mean_mmHg", "p_ao_systolic_mmHg", "p_ao_diastolic_mmHg"]
found = []

# The tube of the coupling tests on a coarse grid, with a Windkessel that fills within a few beats.
TUBE = {"time.end_s": 1.0, "time.period_s": 0.02, "time.stop_when_periodic_within": TUBE_TOLERANCE,
        "time.dt_fixed_s": 1e-3, "grid.finest_cm": 0.25, "checkpoint.every_wall_s": 1e-9, "checkpoint.keep": 1000,
        "output.fields_every_s": 0, "element.ventricle.pressure_mmHg": 1.0, "element.arteries.Rc_mmHg_s_ml": 0.2,
        "element.arteries.Rp_mmHg_s_ml": 0.5, "element.arteries.C_ml_mmHg": 0.1,
        "element.arteries.initial_pressure_mmHg": 0.0}


def expect(holds, message):
    if not holds:
        found.append(message)


def run(case, out, *arguments, changes=()):
    command = [program, "run", str(case), "-o", str(out), *arguments]
    for key, value in {"output.pictures": "false", "output.report": "false", **dict(changes)}.items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=100)
    expect(done.returncode == 0, f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    with open(out / "beats.csv") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def change(before, now):
    return np.max([abs(now[name] - before[name]) / max(abs(now[name]), abs(before[name])) for name in COMPARED])


def expect_stopped_at_the_first_small_change(out, beats, tolerance):
    changes = [change(a, b) for a, b in zip(beats, beats[1:])]
    expect(len(changes) > 1, f"only {len(beats)} beats")
    expect(changes[-1] < tolerance, f"stopped although the last beat changed by {changes[-1]}")
    expect(np.all(np.array(changes[:-1]) >= tolerance), f"continued after changes of {changes}")
    words = f"periodic after {len(beats)} beats"
    outcome = json.loads((out / "run.json").read_text())["outcome"]
    expect(outcome == words, f"run.json says {outcome}, not {words}")
    log = (out / "log.txt").read_text()
    expect(words in log.rstrip().splitlines()[-1], f"log.txt does not end with: {words}")
    expect(f"change from beat {len(beats) - 1}" in log, "log.txt does not report the change")


def repeating(scratch):
    """A 0D heart with a coarse and with a fine tolerance."""
    lengths = []
    for tolerance in [0.01, 0.0005]:
        out = scratch / str(tolerance)
        beats = run(root / "cases" / "lumped_heart", out,
                    changes={"time.end_s": 40, "time.stop_when_periodic_within": tolerance})
        expect_stopped_at_the_first_small_change(out, beats, tolerance)
        lengths.append(len(beats))
    expect(lengths[0] < lengths[1], f"a finer tolerance took no longer: {lengths} beats")


def continued(scratch):
    """A 3D run continued from within a beat stops after the same beat as an uninterrupted one."""
    case = root / "tests" / "coupling" / "tube.toml"
    whole, out = scratch / "whole", scratch / "out"
    beats = run(case, whole, changes=TUBE)
    expect_stopped_at_the_first_small_change(whole, beats, TUBE_TOLERANCE)
    shutil.copytree(whole, out)
    last = max(out.glob("checkpoints/*.h5"))
    step = int(last.stem.split("_")[1])
    for back in [5, 20, 33]:  # within the last beat, at its start, and within the previous one
        from_file = out / "checkpoints" / f"checkpoint_{step - back:08}.h5"
        expect(run(case, out, "--restart", str(from_file), changes=TUBE) == beats, f"{back} steps back: beats.csv differs")
        expect_stopped_at_the_first_small_change(out, beats, TUBE_TOLERANCE)
    expect(run(case, out, "--restart", "latest", changes=TUBE) == beats, "a run that had stopped continued")
    finer = run(case, out, "--restart", "latest",
                changes=TUBE | {"time.stop_when_periodic_within": TUBE_TOLERANCE / 4})
    expect(len(finer) > len(beats) and finer[:len(beats)] == beats, "a smaller tolerance did not continue from there")
    for beat in finer:
        expect(beat["root_loss_mJ"] > 0, f"beat {beat['beat']:.0f}: the 3D tube generates energy: {beat['root_loss_mJ']} mJ")
        expect(abs(beat["energy_residual_mJ"]) < 1e-3 * beat["network_loss_mJ"],
               f"residual {beat['energy_residual_mJ']} mJ with a loss of {beat['network_loss_mJ']} mJ")
        expect(abs(beat["volume_residual_ml"]) < 1e-6 * beat["stroke_volume_ml"], f"residual {beat['volume_residual_ml']} ml")


def balanced(scratch):
    """0D runs balance to the tolerance of the integrator in every beat."""
    for case in ["lumped_heart", "four_chamber_loop"]:
        for beat in run(root / "cases" / case, scratch / case):
            where = f"{case}, beat {beat['beat']:.0f}"
            work = beat["source_work_mJ"]
            expect(500 < work < 3000, f"{where}: {work} mJ of work")
            expect(abs(beat["energy_residual_mJ"]) < 1e-6 * work, f"{where}: residual {beat['energy_residual_mJ']} of {work} mJ")
            expect(abs(beat["volume_residual_ml"]) < 1e-6 * beat["stroke_volume_ml"], f"{where}: {beat['volume_residual_ml']} ml")
            stored = beat["network_energy_change_mJ"]
            expect(abs(work - beat["network_loss_mJ"] - stored) < 2e-6 * work, f"{where}: the columns do not add up")
        # A periodic beat stores nothing, and a loop without sources neither gains nor loses blood.
        expect(abs(stored) < 0.01 * work, f"{case}: the last beat stores {stored} of {work} mJ")
        if case == "four_chamber_loop":
            expect(beat["network_inflow_ml"] == 0, f"{case}: {beat['network_inflow_ml']} ml came in")


with tempfile.TemporaryDirectory() as folder:
    {"repeating": repeating, "continued": continued, "balanced": balanced}[scenario](pathlib.Path(folder))
print("\n".join(found))
sys.exit(1 if found else 0)
