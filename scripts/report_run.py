#!/usr/bin/python3
"""Writes the report of a run: report_run.py OUT writes OUT/report.html and its pictures into OUT/pictures.

The page is self-contained: it opens from the file system and prints. Also writes pictures/valve.gif. Works during a run.
Sections that a run cannot fill are omitted (a 0D run has no leaflets).
"""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import draw_run  # noqa: E402
from drawing import style  # noqa: E402
from drawing.run_output import Missing  # noqa: E402
from reporting import contents, page  # noqa: E402


def report(out):
    """Draws, writes out/report.html and returns its path."""
    style.apply()
    pictures = out / "pictures"
    draw_run.draw_all(out, pictures, draw_run.PICTURES)
    draw_run.draw_all(out, pictures, draw_run.COLUMNS, quiet=True)
    run = contents.read_run(out)
    path = out / "report.html"
    page.write(path, page.page(run.title, contents.body(run)))
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path, help="output folder of a run")
    out = parser.parse_args().out
    try:
        print(f"report: {report(out)}")
    except (Missing, OSError) as error:
        print(f"report: {out}: {error}", file=sys.stderr)
        sys.exit(4)


if __name__ == "__main__":
    main()
