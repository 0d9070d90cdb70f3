#!/usr/bin/python3
"""Runs a case and compares its beats.csv with its expected.toml. A file that expects nothing fails.

    expected_beats.py VALSALVA CASE_FOLDER                        every [beat_N] of a 0D case, to 0.1 %
    expected_beats.py VALSALVA CASE_FOLDER TABLE [KEY=VALUE ...]  the last beat of a 3D run on two ranks, to 3 %
    expected_beats.py VALSALVA CASE_FOLDER closed_leaflet         what `check` says of the closed leaflet, to 2 %
"""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

TOLERANCE_0D, TOLERANCE_3D = 1e-3, 0.03  # the latter allows for other compilers and processors
TOLERANCE_CHECK = 0.02
NEAR_ZERO = {"mean_leak_ml_s": 1.0}  # and so much more
ON_TWO_RANKS = ["mpirun", "-np", "2", "--bind-to", "none"]


def beats_of(launcher, program, folder, changes):
    with tempfile.TemporaryDirectory() as scratch:
        command = [*launcher, program, "run", folder, "-o", f"{scratch}/out"]
        for change in ["output.pictures=false", *changes]:
            command += ["--set", change]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        with open(f"{scratch}/out/beats.csv") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def closed_leaflet(program, folder):
    said = subprocess.run([program, "check", folder], check=True, capture_output=True, text=True).stdout
    nodes = re.search(r"(\d+) nodes", said)
    leaflet = re.search(r"strain ([\d.e+-]+) mean, ([\d.e+-]+) largest; tension ([\d.e+-]+) mean, ([\d.e+-]+) largest "
                        r"dyn/cm; coaptation ([\d.e+-]+) cm", said)
    names = ["nodes", "circumferential_strain_mean", "circumferential_strain_max", "tension_mean_dyn_cm",
             "tension_max_dyn_cm", "coaptation_height_cm"]
    return dict(zip(names, map(float, [nodes[1], *leaflet.groups()])))


def offences(found, expected, tolerance):
    return [f"{name} is {found[name]}, expected {number}" for name, number in expected.items()
            if not abs(found[name] - number) <= tolerance * abs(number) + NEAR_ZERO.get(name, 0)]


def compare(program, folder, table=None, *changes):
    """Returns the differences and how many numbers were compared."""
    expected = tomllib.loads((folder / "expected.toml").read_text())
    if table is None:
        beats = {f"beat_{beat['beat']:.0f}": beat for beat in beats_of([], program, folder, [])}
        wrong = [f"{beat}: {line}" for beat, numbers in expected.items()
                 for line in offences(beats[beat], numbers, TOLERANCE_0D)]
        return wrong, sum(map(len, expected.values()))
    for name in table.split("."):
        expected = expected[name]
    if table == "closed_leaflet":
        return offences(closed_leaflet(program, folder), expected, TOLERANCE_CHECK), len(expected)
    return offences(beats_of(ON_TWO_RANKS, program, folder, changes)[-1], expected, TOLERANCE_3D), len(expected)


def main(program, folder, *more):
    wrong, compared = compare(program, pathlib.Path(folder), *more)
    print(f"{compared} numbers compared", *wrong, sep="\n")
    return 1 if wrong or compared == 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
