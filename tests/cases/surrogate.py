#!/usr/bin/python3
"""A 3D case in 0D: `run --lumped`, `calibrate`, `time.start = "periodic"`, `compare`; errors give clear messages.

    surrogate.py VALSALVA ROOT
"""
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

program, root = sys.argv[1], pathlib.Path(sys.argv[2])
found = []
NO_PICTURES = ["--set", "output.pictures=false"]


def expect(code, words, *arguments):
    result = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    said = result.stdout + result.stderr
    if result.returncode != code or words not in said:
        found.append(f"{arguments}: exit code {result.returncode}, expected {code} and '{words}'\n{said}")


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def lumped_run_and_calibration(folder):
    """Calibration to the traces of a --lumped run, disguised as a 3D run, recovers the surrogate."""
    case, lumped, as_3d = root / "cases" / "aortic_root", folder / "lumped", folder / "root"
    truth = {"area_open_cm2": 2.5, "closing_1_mmHg_s": 4.0}
    expect(0, "results in", "run", case, "--lumped", "-o", lumped, *NO_PICTURES,
           *[word for key, value in truth.items() for word in ("--set", f"surrogate.{key}={value}")])
    beat = rows(lumped / "beats.csv")[0]
    if not 70 < float(beat["stroke_volume_ml"]) < 100 or not 1 < float(beat["closing_volume_ml"]) < 15:
        found.append(f"not a beat of an aortic root: {beat}")
    as_3d.mkdir()
    shutil.copy(lumped / "case.resolved.toml", as_3d)
    resolved = (as_3d / "case.resolved.toml").read_text()
    for key in truth:
        resolved = "\n".join(line for line in resolved.splitlines() if not line.startswith(key))
    (as_3d / "case.resolved.toml").write_text(resolved)
    (as_3d / "openings.csv").write_text((lumped / "openings.csv").read_text().replace("Q_aortic_root", "Q_outlet"))

    expect(0, "information matrix: rank 3 of 3", "calibrate", as_3d, "-o", folder / "calibrated")
    estimates = {e["name"]: e["value"] for e in json.loads((folder / "calibrated" / "fit.json").read_text())["estimates"]}
    for key, value in truth.items():  # the pressure is not linear between rows
        if not abs(estimates[f"aortic_root.{key}"] / value - 1) <= 1e-3:
            found.append(f"{key} is {estimates[f'aortic_root.{key}']}, expected {value}")
    if not (folder / "calibrated" / "fit.png").is_file():
        found.append("no fit.png")
    expect(0, "results in", "run", folder / "calibrated" / "surrogate.toml", "--lumped", "-o", folder / "again", *NO_PICTURES)
    again = rows(folder / "again" / "beats.csv")[0]
    if not abs(float(again["stroke_volume_ml"]) - float(beat["stroke_volume_ml"])) <= 0.02:
        found.append("surrogate.toml does not give the run that it was calibrated from")
    expect(0, "rms difference, flow", "compare", lumped, folder / "again", "-o", folder / "compared")

    expect(2, "--beat: is 3, but the run ends at t = 0.8 s", "calibrate", as_3d, "--beat", "3", "-o", folder / "no")
    expect(2, "is not empty", "calibrate", as_3d, "-o", folder / "calibrated")
    expect(4, "case.resolved.toml", "calibrate", folder / "compared", "-o", folder / "no")
    expect(2, "a 0D run takes seconds", "run", case, "--lumped", "-o", lumped, "--restart", "latest")


def periodic_start(folder):
    """From the periodic state all beats are equal."""
    out = folder / "periodic"
    expect(0, "from the periodic 0D state, found in", "run", root / "cases" / "lumped_heart", "-o", out, "--set",
           "time.start=periodic", "--set", "time.end_s=1.6", *NO_PICTURES)
    first, second = rows(out / "beats.csv")
    for column, value in first.items():
        shift = {"beat": 1.0, "start_s": 0.8, "opening_s": 0.8, "closing_s": 0.8}.get(column, 0.0)
        scale = float(first["source_work_mJ"]) if column.endswith("_mJ") else max(1.0, abs(float(value)))
        if not abs(float(value) + shift - float(second[column])) <= 1e-6 * scale:
            found.append(f"{column}: {value} in the first beat, {second[column]} in the second")
    expect(2, "time.period_s is 0; set it", "run", root / "cases" / "aortic_root", "--lumped", "-o", folder / "no", "--set",
           "time.start=periodic")
    expect(2, 'use beyond_table = "repeat"', "run", root / "cases" / "aortic_root", "-o", folder / "no", "--set",
           "time.start=periodic", "--set", "time.period_s=0.8")


with tempfile.TemporaryDirectory() as scratch:
    lumped_run_and_calibration(pathlib.Path(scratch))
    periodic_start(pathlib.Path(scratch))

print("\n".join(found))
sys.exit(1 if found else 0)
