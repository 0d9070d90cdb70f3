#!/usr/bin/python3
"""The cases of the gallery differ from the healthy adult as expected of their diseases.

    gallery.py VALSALVA ROOT circulation    heart and arteries: hypertension, stiff aorta, exercise in 0D
    gallery.py VALSALVA ROOT stenosis       the valve opens less, in a short 3D run on a very coarse grid
    gallery.py VALSALVA ROOT regurgitation  the closed valve leaks under load, in a short 3D run on the coarse grid
    gallery.py VALSALVA ROOT whole          every case in 3D, compared with its expected.toml (minutes each)
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import numpy as np

TOLERANCE = 0.03  # relative to expected.toml; allows for other compilers and processors
CASES = ["healthy_adult", "hypertension", "stiff_aorta", "exercise", "aortic_stenosis", "aortic_regurgitation"]

program, root, what = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
offences = []


def expect(holds, message):
    if not holds:
        offences.append(message)


def rows(path):
    with open(path) as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def run(case, out, overrides, *options):
    command = [program, "run", str(root / "cases" / case), "-o", str(out), *options]
    for override in [*overrides, "output.pictures=false", "output.fields_every_s=0", "output.structure_every_s=0"]:
        command += ["--set", override]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return out


def beat_of(out):
    """The last beat, with derived quantities."""
    beat = rows(out / "beats.csv")[-1]
    return beat | {"pulse_pressure_mmHg": beat["p_ao_systolic_mmHg"] - beat["p_ao_diastolic_mmHg"],
                   "backflow_ml": beat["closing_volume_ml"] + beat["leak_volume_ml"],
                   "output_l_min": 0.06 * beat["stroke_volume_ml"] / beat["period_s"]}


def compare_circulations(beats):
    """Checks the effect of changes of heart or arteries on pressures and output."""
    healthy, hypertension = beats["healthy_adult"], beats["hypertension"]
    for name in ("p_ao_systolic_mmHg", "p_ao_diastolic_mmHg", "p_ao_mean_mmHg"):
        expect(hypertension[name] > healthy[name] + 15, f"hypertension: {name} {hypertension[name]}, "
                                                        f"healthy {healthy[name]}")
    expect(beats["stiff_aorta"]["pulse_pressure_mmHg"] > 1.3 * healthy["pulse_pressure_mmHg"],
           f"stiff aorta: pulse pressure {beats['stiff_aorta']['pulse_pressure_mmHg']}, "
           f"healthy {healthy['pulse_pressure_mmHg']}")
    expect(beats["exercise"]["output_l_min"] > 1.6 * healthy["output_l_min"],
           f"exercise: {beats['exercise']['output_l_min']} l/min, healthy {healthy['output_l_min']}")


def circulation(scratch):
    compare_circulations({case: beat_of(run(case, scratch / case, ["time.end_s=8"], "--lumped"))
                          for case in CASES[:4]})


def leaflets_of(case):
    """The [leaflets] of a case as overrides."""
    leaflets = tomllib.loads((root / "cases" / case / "case.toml").read_text()).get("leaflets", {})
    return [f"leaflets.{key}={json.dumps(value)}" for key, value in leaflets.items()]


def stenosis(scratch):
    """In cases/aortic_root the ventricular pressure is prescribed, so the valve alone differs."""
    flow, area = {}, {}
    for case in ("healthy_adult", "aortic_stenosis"):
        out = run("aortic_root", scratch / case, leaflets_of(case) + ["grid.finest_cm=0.25", "time.end_s=0.2"])
        flow[case] = np.max([row["Q_outlet_ml_s"] for row in rows(out / "openings.csv")])
        area[case] = np.max([row["area_cm2"] for row in rows(out / "probes.csv")])
    expect(flow["aortic_stenosis"] < 0.85 * flow["healthy_adult"], f"stenosis: peak flow in ml/s {flow}")
    expect(area["aortic_stenosis"] < 0.75 * area["healthy_adult"], f"stenosis: largest orifice in cm^2 {area}")


def regurgitation(scratch):
    """The closed valve under the aortic pressure alone. On coarser grids the smeared leaflets seal the gap."""
    leak = {}
    for case in ("healthy_adult", "aortic_regurgitation"):
        out = run("aortic_root", scratch / case,
                  leaflets_of(case) + ["grid.finest_cm=0.15625", "time.end_s=0.11",
                                       "element.ventricle.pressure_mmHg=[0, 0, 0, 0, 0, 0]"])
        late = [row["Q_inlet_ml_s"] for row in rows(out / "openings.csv") if row["t_s"] > 0.07]
        leak[case] = -sum(late) / len(late)
    expect(leak["aortic_regurgitation"] > leak["healthy_adult"] + 15, f"regurgitation: leak in ml/s {leak}")
    expect(abs(leak["healthy_adult"]) < 15, f"healthy: leak in ml/s {leak}")


def whole(scratch):
    beats = {}
    for case in CASES:
        end = ["time.end_s=0.8"] if case == "healthy_adult" else []
        beats[case] = beat_of(run(case, scratch / case, end))
        if case == "healthy_adult":  # its expected.toml is for the periodic beat, not the first
            continue
        expected = tomllib.loads((root / "cases" / case / "expected.toml").read_text())
        for column, number in expected[f"beat_{beats[case]['beat']:.0f}"].items():
            expect(abs(beats[case][column] - number) <= TOLERANCE * abs(number),
                   f"{case}: {column} is {beats[case][column]}, expected {number}")
    compare_circulations(beats)
    healthy, narrow, leaking = (beats[c] for c in ("healthy_adult", "aortic_stenosis", "aortic_regurgitation"))
    expect(narrow["mean_gradient_mmHg"] > 1.5 * healthy["mean_gradient_mmHg"], f"stenosis: {narrow}")
    expect(narrow["max_orifice_area_cm2"] < 0.75 * healthy["max_orifice_area_cm2"], f"stenosis: {narrow}")
    expect(leaking["backflow_ml"] > 2 * healthy["backflow_ml"], f"regurgitation: {leaking}")


with tempfile.TemporaryDirectory() as scratch:
    {"circulation": circulation, "stenosis": stenosis, "regurgitation": regurgitation, "whole": whole}[what](pathlib.Path(scratch))
print("\n".join(offences))
sys.exit(1 if offences else 0)
