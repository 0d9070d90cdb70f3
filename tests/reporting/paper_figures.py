#!/usr/bin/python3
"""The figures of the paper are drawn from a synthetic run, and the table has the numbers of that run.

    paper_figures.py VALSALVA ROOT
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

root = Path(sys.argv[2])
sys.path[:0] = [str(root / folder) for folder in ("scripts", "tests/reporting", "validation/griffith2009")]
import example_run as example  # noqa: E402
import statements  # noqa: E402

found = []

# A damped sine has the frequency and the decay rate that it was built with.
t = np.linspace(0.4, 0.8, 4001)
frequency, decay = statements.ringing(t, 300 * np.exp(-12 * (t - 0.4)) * np.sin(2 * np.pi * 36 * (t - 0.4)), 0.4)
if abs(frequency - 36) > 0.3 or abs(decay - 12) > 0.3:
    found.append(f"ringing: {frequency} Hz, {decay} 1/s; expected 36 Hz, 12 1/s")

# A sawtooth of single steps on a smooth flow is rough; the flow alone is not.
smooth = -100 * np.cos(20 * (t - 0.5))
saw = smooth + 0.5 * (-1) ** np.arange(len(t))
if not statements.roughness(t, smooth) <= 1e-3 or not statements.roughness(t, saw) >= 0.1:
    found.append(f"roughness: {statements.roughness(t, smooth)} smooth, {statements.roughness(t, saw)} with a sawtooth")

with tempfile.TemporaryDirectory() as scratch:
    run, out = Path(scratch, "run"), Path(scratch, "out")
    example.write(run)
    result = subprocess.run([root / "validation/griffith2009/figures.py", run, "-o", out], capture_output=True,
                            text=True)
    if result.returncode != 0:
        found.append(f"exit code {result.returncode}: {result.stdout}{result.stderr}")
    page = (out / "README.md").read_text() if (out / "README.md").is_file() else ""
    for words in (f"{example.FORWARD_ML:.1f} ml forward", f"{0.06 * example.PEAK:.1f} l/min",
                  "0 nodes outside the finest in 41 frames", "10.2514/6.2009-158", "What differs"):
        if words not in page:
            found.append(f"the page does not say '{words}'\n{result.stdout}")
    for number in (2, 4, 5, 6, 7):
        if not (out / "figures" / f"figure_{number}.png").is_file():
            found.append(f"figure {number} is missing\n{result.stdout}")

print("\n".join(found))
sys.exit(1 if found else 0)
