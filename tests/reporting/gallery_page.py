"""The page of scripts/draw_gallery.py for two synthetic runs.

    gallery_page.py VALSALVA ROOT
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import example_run

root = Path(sys.argv[2])
offences = []


def expect(holds, message):
    if not holds:
        offences.append(message)


def draw(*arguments):
    return subprocess.run(["/usr/bin/python3", str(root / "scripts" / "draw_gallery.py"), *map(str, arguments)],
                          capture_output=True, text=True)


with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    example_run.write(folder / "healthy")
    example_run.write(folder / "weak", scale=0.5)
    docs = folder / "docs"
    said = draw(folder / "healthy", folder / "weak", "--docs", docs)
    expect(said.returncode == 0, f"exit code {said.returncode}: {said.stderr}")
    page = (docs / "gallery.md").read_text()
    stroke, back = example_run.FORWARD_ML - example_run.CLOSING_ML, example_run.CLOSING_ML
    for name, scale in (("healthy", 1.0), ("weak", 0.5)):
        row = next((line for line in page.splitlines() if line.startswith(f"| [{name}]")), "")
        cells = [cell.strip() for cell in row.split("|")[2:-1]]
        expected = ["1", f"{scale * stroke:.0f}", f"{0.06 * scale * stroke / 0.8:.1f}", f"{scale * example_run.PEAK:.0f}",
                    "4", f"{3.5 * scale:.2f}", f"{scale * back:.0f}"]
        expect(cells[:7] == expected, f"{name}: {cells[:7]} instead of {expected}")
        expect(f"](pictures/gallery/{name}.png)" in page, f"{name}: no picture on the page")
        expect((docs / "pictures" / "gallery" / f"{name}.png").stat().st_size > 10_000, f"{name}: no picture")
    for leaflets in (folder / "weak" / "structure").glob("*"):
        leaflets.unlink()
    said = draw(folder / "healthy", folder / "weak", "--docs", docs)
    expect(said.returncode == 4 and "draw_gallery: " in said.stderr, f"no leaflets: {said.returncode} {said.stderr}")

print("\n".join(offences))
sys.exit(1 if offences else 0)
