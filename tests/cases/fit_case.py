#!/usr/bin/python3
"""`valsalva fit`: a fit to the pressure trace of a run recovers the parameters of that run; errors give clear messages.

    fit_case.py VALSALVA ROOT
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

program, root = sys.argv[1], pathlib.Path(sys.argv[2])
found = []

FIT = """
extends = "case.toml"
[fit]
data = "beat.csv"
[[fit_parameter]]
name = "Rp"
parameter = "arteries.Rp_mmHg_s_ml"
[[fit_parameter]]
name = "C"
parameter = "arteries.C_ml_mmHg"
[[fit_signal]]
name = "p_ao_mmHg"
observable = "p_ao_mmHg"
"""


def valsalva(*arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)


def expect(result, code, words):
    if result.returncode != code or words not in result.stdout + result.stderr:
        found.append(f"exit code {result.returncode}, expected {code} and '{words}'\n{result.stdout}{result.stderr}")


def last_beat(traces, period):
    """Time from the start of the beat and aortic pressure of the last whole beat, every tenth row."""
    with open(traces, newline="") as file:
        rows = list(csv.DictReader(file))
    begin = float(rows[-1]["t_s"]) - period
    beat = [(float(r["t_s"]) - begin, r["p_ao_mmHg"]) for r in rows if float(r["t_s"]) >= begin - 1e-9]
    return beat[:-1:10]


with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(scratch)
    (folder / "case.toml").write_text((root / "cases" / "lumped_heart" / "case.toml").read_text())
    (folder / "fit.toml").write_text(FIT)
    expect(valsalva("run", folder / "case.toml", "-o", folder / "run", "--set", "time.end_s=24",
                    "--set", "output.pictures=false"), 0, "results")
    with open(folder / "beat.csv", "w") as file:
        file.write("t_s,p_ao_mmHg\n" + "".join(f"{max(t, 0):.6f},{p}\n" for t, p in last_beat(folder / "run/openings.csv", 0.8)))
    away = ["--set", "element.arteries.Rp_mmHg_s_ml=1.1", "--set", "element.arteries.C_ml_mmHg=1.3"]
    expect(valsalva("fit", folder / "fit.toml", "-o", folder / "fit", *away), 0, "information matrix: rank 2 of 2")
    result = json.loads((folder / "fit/fit.json").read_text())
    for estimate, exact in zip(result["estimates"], (0.79, 1.75)):
        if not abs(estimate["value"] / exact - 1) <= 1e-5:
            found.append(f"{estimate['name']} is {estimate['value']}, expected {exact}")
    for name in ("fit.txt", "fit.csv", "fit.png", "case.resolved.toml"):
        if not (folder / "fit" / name).is_file():
            found.append(f"no {name}")
    expect(valsalva("fit", folder / "fit.toml", "-o", folder / "fit"), 2, "is not empty")
    text = FIT.replace("arteries.C_ml_mmHg", "arteries.C_ml_mmH")
    (folder / "fit.toml").write_text(text)
    expect(valsalva("fit", folder / "fit.toml", "-o", folder / "bad"), 2, "did you mean 'arteries.C_ml_mmHg'?")
    (folder / "fit.toml").write_text(FIT.replace('observable = "p_ao', 'observable = "p_aorta'))
    expect(valsalva("fit", folder / "fit.toml", "-o", folder / "bad", "--force"), 2, "is not in the network")
    expect(valsalva("fit", folder / "fit.toml", "--data", "/no/beat.csv", "-o", folder / "bad", "--force"), 4, "/no/beat.csv")
    expect(valsalva("fit", root / "cases" / "aortic_root", "-o", folder / "bad"), 2, "makes this a 3D case")

print("\n".join(found))
sys.exit(1 if found else 0)
