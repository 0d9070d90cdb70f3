#!/usr/bin/python3
"""Runs a 0D case and compares its beats.csv with its expected.toml, to 0.1 %.

    expected_beats.py VALSALVA CASE_FOLDER
"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import tomllib

TOLERANCE = 1e-3


def main(program, folder):
    expected = tomllib.loads((folder / "expected.toml").read_text())
    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run([program, "run", folder, "-o", f"{scratch}/out", "--set", "output.pictures=false"], check=True)
        with open(f"{scratch}/out/beats.csv") as file:
            beats = {row["beat"]: row for row in csv.DictReader(file)}
    offences = []
    for beat, numbers in expected.items():
        for column, number in numbers.items():
            found = float(beats[beat.removeprefix("beat_")][column])
            if abs(found - number) > TOLERANCE * abs(number):
                offences.append(f"{beat}: {column} is {found}, expected {number}")
    print("\n".join(offences))
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2])))
