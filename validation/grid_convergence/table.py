#!/usr/bin/python3
"""Prints the table of the README from run folders, coarsest first: table.py out/h64 out/h96 out/h128"""
import json
import re
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from drawing.metrics import last_beat_of_run  # noqa: E402
from drawing.run_output import phase_times, read_table  # noqa: E402


def describe(folder):
    """({row: text}, {row: number}) for one run."""
    record, beat = json.loads((folder / "run.json").read_text()), last_beat_of_run(folder)
    levels = re.findall(r"^grid +(\d+) cells of ([\d.]+) cm", (folder / "log.txt").read_text(), re.M)
    table = read_table(folder / "step.csv")
    begun = table["step"] > 0
    steps = {name: np.array(values)[begun] for name, values in table.items()}
    bounds, counts = np.unique(steps["dt_bound"], return_counts=True)
    shares = sorted(((100 * n / len(steps["step"]), b) for b, n in zip(bounds, counts)), reverse=True)
    openings = read_table(folder / "openings.csv")
    per_step = {name: 1e3 * seconds / len(steps["step"]) for name, seconds, _ in phase_times(folder)
                if name not in ("checkpoint", "circulation")}
    text = {
        "h, cm": f"{float(levels[-1][1]):.4g}",
        "cells per level": " + ".join(n for n, _ in levels),
        "nodes": str(record["nodes"]),
        "steps": str(record["steps"]),
        "dt, s: median (minimum)": f"{np.median(steps['dt_s']):.2g} ({steps['dt_s'].min():.2g})",
        "active bound": ", ".join(f"{b} {share:.0f} %" for share, b in shares if share > 2),
        "pressure iterations per step, mean": f"{steps['iterations'].mean():.2f}",
        "ms per step, median": f"{1e3 * np.median(steps['wall_s']):.0f}",
        "mean by phase: " + ", ".join(per_step): ", ".join(f"{v:.1f}" for v in per_step.values()),
        "wall-clock time": f"{record['wall_s'] / 60:.1f} min",
        "memory, all ranks, MB": f"{record['peak_memory_mb']:.0f}",
    }
    numbers = {
        "stroke volume (net), ml": beat["stroke_volume_ml"],
        "forward volume, ml": beat["forward_volume_ml"],
        "peak flow, ml/s": beat["peak_flow_ml_s"],
        "minimum flow, ml/s": beat["least_flow_ml_s"],
        "maximum orifice area, cm^2": beat["max_orifice_area_cm2"],
        "mean gradient, mmHg": beat["mean_gradient_mmHg"],
        "closing volume, ml": beat["closing_volume_ml"],
        "mean leak after closure, ml/s": beat["mean_leak_ml_s"],
        "flow 0.6-0.8 s, ml/s": openings["Q_outlet_ml_s"][openings["t_s"] > 0.6].mean(),
    }
    return text, numbers


def main(folders):
    folders = [Path(f) for f in folders]
    described = [describe(f) for f in folders]
    print("| | " + " | ".join(f.name for f in folders) + " | " +
          " | ".join(f"{b.name} - {a.name}" for a, b in zip(folders, folders[1:])) + " |")
    print("|---" * (2 * len(folders)) + "|")
    for name in described[0][0]:
        print(f"| {name} | " + " | ".join(t.get(name, "") for t, _ in described) + " |" + " |" * (len(folders) - 1))
    for name in described[0][1]:
        values = [n[name] for _, n in described]
        steps = [f"{b - a:+.1f}" for a, b in zip(values, values[1:])]
        print(f"| {name} | " + " | ".join(f"{v:.1f}" for v in values) + " | " + " | ".join(steps) + " |")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1:])
