#!/usr/bin/python3
"""The table of the README from run folders, coarsest first: table.py out/h64 out/h96 out/h128"""
import csv
import json
import pathlib
import re
import statistics
import sys


def rows(path):
    with open(path) as f:
        return list(csv.DictReader(f))


def phases(log):
    """{phase: ms per step} from the table at the end of log.txt."""
    found = re.findall(r"^(\S[a-z ]+?) {2,}([\d.]+) +[\d.]+ +(\d+) +[\d.]+$", log, re.M)
    return {name: float(seconds) for name, seconds, _ in found}


def describe(folder):
    folder = pathlib.Path(folder)
    record = json.loads((folder / "run.json").read_text())
    beat = {k: float(v) for k, v in rows(folder / "beats.csv")[-1].items()}
    steps = [r for r in rows(folder / "step.csv") if float(r["step"]) > 0]
    log = (folder / "log.txt").read_text()
    levels = re.findall(r"^grid +(\d+) cells of ([\d.]+) cm", log, re.M)
    dt = [float(r["dt_s"]) for r in steps]
    bounds = [r["dt_bound"] for r in steps]
    share = {b: bounds.count(b) / len(bounds) for b in sorted(set(bounds), key=bounds.count, reverse=True)}
    late = [float(r["Q_outlet_ml_s"]) for r in rows(folder / "openings.csv") if float(r["t_s"]) > 0.6]
    per_step = {name: 1e3 * seconds / len(steps) for name, seconds in phases(log).items()}
    table = {
        "h, cm": f"{float(levels[-1][1]):.4g}",
        "cells per level": " + ".join(n for n, _ in levels),
        "nodes": str(record["nodes"]),
        "steps": str(record["steps"]),
        "dt, s: median (least)": f"{statistics.median(dt):.2g} ({min(dt):.2g})",
        "bounded by": ", ".join(f"{b} {100 * s:.0f} %" for b, s in share.items() if s > 0.02),
        "pressure iterations per step, mean": f"{statistics.mean(float(r['iterations']) for r in steps):.2f}",
        "ms per step, median": f"{1e3 * statistics.median(float(r['wall_s']) for r in steps):.0f}",
        "of it, mean: " + ", ".join(n for n in per_step if n not in ("wall", "checkpoint", "circulation")):
            ", ".join(f"{v:.1f}" for n, v in per_step.items() if n not in ("wall", "checkpoint", "circulation")),
        "wall-clock time": f"{record['wall_s'] / 60:.1f} min",
        "memory, all ranks, MB": f"{record['peak_memory_mb']:.0f}",
    }
    numbers = {
        "stroke volume (net), ml": beat["stroke_volume_ml"],
        "forward volume, ml": beat["forward_volume_ml"],
        "peak flow, ml/s": beat["peak_flow_ml_s"],
        "least flow, ml/s": beat["least_flow_ml_s"],
        "largest orifice, cm^2": beat["max_orifice_area_cm2"],
        "mean gradient, mmHg": beat["mean_gradient_mmHg"],
        "closing volume, ml": beat["closing_volume_ml"],
        "mean leak after closure, ml/s": beat["mean_leak_ml_s"],
        "flow 0.6-0.8 s, ml/s": statistics.mean(late),
    }
    return table, numbers


def main(folders):
    described = [describe(f) for f in folders]
    print("| | " + " | ".join(pathlib.Path(f).name for f in folders) + " | " +
          " | ".join(f"{pathlib.Path(b).name} - {pathlib.Path(a).name}" for a, b in zip(folders, folders[1:])) + " |")
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
