#!/usr/bin/python3
"""Compares a 0D run with the independent integration in reference/: all states at every millisecond, the switching times
of the valves, the stroke volume and, in a closed loop, the total volume.

    lumped_reference.py VALSALVA ROOT left_heart|resistive_valves|prescribed_pressure|four_chambers
"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "reference"))
from hybrid import integrate  # noqa: E402
from models import FourChambers, LeftHeart  # noqa: E402

TOLERANCE = 1e-6  # of a state's range, and in seconds and ml

PRESCRIBED = """
title = "Prescribed ventricular pressure"
[time]
end_s = 0.8
period_s = 0.8
[[element]]
name = "ventricle"
type = "pressure_source"
node = "lv"
time_s = [0.0, 0.05, 0.15, 0.35, 0.45, 0.8]
pressure_mmHg = [0.0, 0.0, 120.0, 120.0, 0.0, 0.0]
[[element]]
name = "aortic"
type = "valve"
from = "lv"
to = "ao"
R_mmHg_s_ml = 0.005
L_mmHg_s2_ml = 0.0006
B_mmHg_s2_ml2 = 2e-5
[[element]]
name = "arteries"
type = "windkessel3"
node = "ao"
Rc_mmHg_s_ml = 0.033
Rp_mmHg_s_ml = 0.79
C_ml_mmHg = 1.75
initial_pressure_mmHg = 85.0
"""


def case_of(name, root):
    """TOML of the case, its model and the end of the run."""
    heart = (root / "cases" / "lumped_heart" / "case.toml").read_text()
    if name == "prescribed_pressure":
        return PRESCRIBED, LeftHeart, 0.8
    if name == "left_heart":
        return heart, LeftHeart, 2.4
    if name == "resistive_valves":
        lines = [line for line in heart.splitlines() if not line.startswith("L_mmHg_s2_ml")]
        return "\n".join(lines), LeftHeart, 2.4
    return (root / "cases" / "four_chamber_loop" / "case.toml").read_text(), FourChambers, 2.4


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return rows


def main(program, root, name):
    text, model_type, end = case_of(name, pathlib.Path(root))
    case = tomllib.loads(text)
    model = model_type({e["name"]: e for e in case["element"]}, case["time"]["period_s"])
    with tempfile.TemporaryDirectory() as scratch:
        path = pathlib.Path(scratch, "case.toml")
        path.write_text(text)
        subprocess.run([program, "run", path, "-o", f"{scratch}/out", "--set", f"time.end_s={end}", "--set",
                        "output.pictures=false"], check=True, stdout=subprocess.DEVNULL)
        rows, switches = read(f"{scratch}/out/openings.csv"), read(f"{scratch}/out/valves.csv")
    times = [float(row["t_s"]) for row in rows]
    reference, events = integrate(model, model.start(), times)
    offences = []

    def compare(what, found, expected, scale):
        difference = np.max(np.abs(np.asarray(found) - np.asarray(expected))) / scale
        print(f"{what:<28}{difference:.1e}")
        if not difference <= TOLERANCE:
            offences.append(what)

    for k, state in enumerate(model.names):
        if state in rows[0]:
            compare(state, [float(row[state]) for row in rows], reference[:, k], max(np.ptp(reference[:, k]), 1.0))
    switches = [row for row in switches if float(row["t_s"]) > 0]
    found = [(row["valve"], row["open"]) for row in switches]
    expected = [(model.valves[v], "1" if opens else "0") for _, v, opens in events]
    if found != expected:
        offences.append(f"switching order: {found} instead of {expected}")
    else:
        compare("event times (s)", [float(row["t_s"]) for row in switches], [t for t, _, _ in events], 1.0)
    if name == "four_chambers":
        C = [model.e[n]["C_ml_mmHg"] for n in model.compliances]
        total = [sum(float(row[s]) for s in model.names[:4])
                 + sum(c * float(row[s]) for c, s in zip(C, model.names[7:])) for row in rows]
        compare("total volume x 100", 1e2 * np.array(total) / total[0], 1e2, 1.0)  # nine digits per column
    print("\n".join(offences))
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
