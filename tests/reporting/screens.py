#!/usr/bin/python3
"""A report in a browser at 1280 and 400 px: no overflow, every picture loads, the movie works.

    screens.py VALSALVA ROOT [PAGE SCREENSHOT_FOLDER]

With PAGE it also saves screenshots. Exit code 77 (skipped) without Chromium.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

program, root = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(root / "tests" / "reporting"))
import browser  # noqa: E402
import example_run  # noqa: E402

if not browser.executable():
    print("no chromium: skipped")
    sys.exit(77)

found = []
with tempfile.TemporaryDirectory() as scratch:
    if len(sys.argv) > 3:
        pages = [Path(sys.argv[3])]
    else:
        runs = [Path(scratch, name) for name in ("first", "second")]
        for run, scale in zip(runs, (1.0, 1.2)):
            example_run.write(run, scale)
            subprocess.run([program, "report", run], check=True, capture_output=True)
        subprocess.run([program, "compare", *runs, "-o", f"{scratch}/both", "--html"], check=True, capture_output=True)
        pages = [runs[0] / "report.html", Path(scratch, "both", "compare.html")]
    for page in pages:
        for width in (1280, 400):
            shot = Path(sys.argv[4], f"{page.stem}_{width}.png") if len(sys.argv) > 4 else None
            seen = browser.look(page, width, scratch, shot)
            print(page.name, width, seen)
            if not seen or seen["pictures"] < 2:
                found.append(f"{page.name} at {width} px does not show its pictures: {seen}")
            elif seen["wide"] > width:
                found.append(f"{page.name} is {seen['wide']} px wide in a window of {width} px")
            elif seen["broken"]:
                found.append(f"{page.name} at {width} px: {seen['broken']} pictures did not load")
            elif page.stem == "report" and not seen["time"].endswith(" s"):
                found.append("the movie does not show its time")

print("\n".join(found))
sys.exit(1 if found else 0)
