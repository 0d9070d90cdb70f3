#!/usr/bin/python3
"""Comparisons of synthetic beats with known statistics.

    comparison.py VALSALVA ROOT
"""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

program, root = sys.argv[1], Path(sys.argv[2])
sys.path[:0] = [str(root / "scripts"), str(root / "tests" / "reporting")]
import example_run as example  # noqa: E402
from drawing.metrics import beat_of_trace  # noqa: E402

found = []


def expect_near(value, exact, tolerance, what):
    if not abs(value - exact) <= tolerance:
        found.append(f"{what}: {value}, expected {exact}")


# The statistics of a trace match the closed form.
t = np.linspace(0, 0.8, 8001)
beat = beat_of_trace(t, example.flow(t), p_ao=80 + 10 * t, p_lv=84 + 10 * t)
for column, exact, tolerance in [
        ("forward_volume_ml", example.FORWARD_ML, 1e-4), ("closing_volume_ml", example.CLOSING_ML, 1e-4),
        ("leak_volume_ml", 0, 1e-9), ("ejection_time_s", 0.3, 1e-4), ("opening_s", 0.1, 1e-4), 
        ("closing_s", 0.45, 2e-4), ("peak_flow_ml_s", example.PEAK, 1e-3), ("least_flow_ml_s", -example.BACK, 1e-3),
        ("mean_gradient_mmHg", 4, 1e-9),
        ("p_ao_mean_mmHg", 84, 1e-9), ("stroke_volume_ml", example.FORWARD_ML - example.CLOSING_ML, 1e-4)]:
    expect_near(beat[column], exact, tolerance, column)

with tempfile.TemporaryDirectory() as scratch:
    one, two, data, out = (Path(scratch, name) for name in ("one", "two", "late.csv", "both"))
    example.write(one)
    example.write(two, scale=1.2)
    # The beat of the first run, measured 0.25 s later in its period: it begins and ends during diastole.
    late = example.flow(t - 0.25)
    example.write_csv(data, {"t_s": t, "Q_ao_ml_s": late, "p_ao_mmHg": 80 + 0.05 * late})
    run = subprocess.run([program, "compare", one, two, "--data", data, "-o", out, "--html"], capture_output=True,
                         text=True)
    if run.returncode != 0:
        found.append(f"exit code {run.returncode}: {run.stdout}{run.stderr}")
    with open(out / "metrics.csv", newline="") as file:
        rows = {row["quantity"]: row for row in csv.DictReader(file)}
    stroke = example.FORWARD_ML - example.CLOSING_ML
    expect_near(float(rows["stroke volume"]["two"]), 1.2 * stroke, 1e-6, "scaled run")
    expect_near(float(rows["stroke volume"]["late"]), stroke, 0.01, "data")
    expect_near(float(rows["shift in time"]["late"]), -0.25, 2e-3, "shift of the data")
    # Once aligned, the delayed beat does not differ; the scaled one differs by a fifth of the rms flow.
    square = 0.5 * (example.PEAK ** 2 * 0.3 + example.BACK ** 2 * 0.05) / 0.8
    expect_near(float(rows["rms difference, flow"]["two"]), 0.2 * np.sqrt(square), 0.1, "rms difference of scaled flow")
    expect_near(float(rows["rms difference, flow"]["late"]), 0, 2, "rms difference of the delayed flow")
    if "+20 %" not in run.stdout:
        found.append("the table does not say +20 %")
    for name in ("metrics.txt", "metrics.md", "traces.png", "traces.svg", "compare.html"):
        if not (out / name).is_file():
            found.append(f"{name} is missing")

print("\n".join(found))
sys.exit(1 if found else 0)
