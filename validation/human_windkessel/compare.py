#!/usr/bin/python3
"""Fits Windkessels of three and four elements to the human type-A beat and compares them with the published parameters.

    compare.py [VALSALVA] [DATA]      writes result.md and the pictures next to this file; exit code 1 outside the tolerance

Without the data file the script does nothing (exit code 0).
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
TOLERANCE = 0.05
# Stergiopulos, Westerhof & Westerhof 1999, the three-element set as quoted by Griffith et al. 2009.
PUBLISHED = {
    "case.toml": {"Rc_mmHg_s_ml": 0.033, "Rp_mmHg_s_ml": 0.79, "C_ml_mmHg": 1.75},
    "four_elements.toml": {"Rc_mmHg_s_ml": 0.056, "C_ml_mmHg": 1.22, "L_mmHg_s2_ml": 0.0051},
}


def fit(program, data, case, out):
    subprocess.run([program, "fit", HERE / case, "--data", data, "-o", out], check=True, stdout=subprocess.DEVNULL)
    if (out / "fit.png").is_file():
        shutil.copy(out / "fit.png", HERE / f"{pathlib.Path(case).stem}.png")
    return json.loads((out / "fit.json").read_text())


def table(case, result):
    """Markdown rows and the maximum relative deviation from the published parameters."""
    rows, worst = [], 0.0
    for estimate in result["estimates"]:
        key = estimate["name"].split(".")[1]
        published = PUBLISHED[case].get(key)
        deviation = None if published is None else estimate["value"] / published - 1
        worst = max(worst, abs(deviation or 0.0))
        low, high = estimate["interval_95"]
        rows.append(f"| `{key}` | {estimate['value']:.4g} | {estimate['sd']:.2g} | {low:.4g} to {high:.4g} | "
                    + ("| |" if published is None else f"{published:g} | {100 * deviation:+.1f} % |"))
    return rows, worst


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "release" / "valsalva"
    data = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ROOT.parent / "shared" / "data" / "human_type_a_beat.csv")
    if not data.is_file():
        print(f"skipped: no measured beat at {data}")
        return 0
    lines, worst = ["# Result", "", "Written by `compare.py`."], 0.0
    with tempfile.TemporaryDirectory() as scratch:
        for case in PUBLISHED:
            result = fit(program, data, case, pathlib.Path(scratch, case))
            rows, deviation = table(case, result)
            worst = max(worst, deviation)
            lines += ["", f"## {case}", "", "| parameter | estimate | sd | 95 % interval | published | deviation |",
                      "|---|---|---|---|---|---|", *rows, "", f"Residual rms {result['residuals'][0]['rms']:.3g} mmHg, "
                      f"condition of the information matrix {result['condition']:.2g}.", ""]
            lines += [f"> {flag}" for flag in result["flags"]]
    (HERE / "result.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    if worst > TOLERANCE:
        print(f"a parameter deviates from the published one by {100 * worst:.1f} %; {100 * TOLERANCE:.0f} % is allowed")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
