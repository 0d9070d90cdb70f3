#!/usr/bin/python3
"""Writes the gallery of cases from their output folders: draw_gallery.py OUT [OUT ...] [--docs DIR].

Draws DIR/pictures/gallery/<name of the folder>.png for every run and writes DIR/gallery.md with the statistics of their
last beats. The others are compared with the first run:

    for c in healthy_adult hypertension stiff_aorta exercise aortic_stenosis aortic_regurgitation; do
      scripts/run cases/$c
    done
    scripts/draw_gallery.py out/{healthy_adult,hypertension,stiff_aorta,exercise,aortic_stenosis,aortic_regurgitation}
"""
import argparse
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
from drawing import style  # noqa: E402
from drawing.run_output import Missing  # noqa: E402
from reporting import gallery  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", type=Path, help="output folders, named after their cases")
    parser.add_argument("--docs", type=Path, default=ROOT / "docs", help="folder of gallery.md")
    arguments = parser.parse_args()
    style.apply()
    try:
        gallery.write(arguments.runs, arguments.docs / "gallery.md",
                      arguments.docs / "pictures" / "gallery")
    except (Missing, OSError) as error:
        print(f"draw_gallery: {error}", file=sys.stderr)
        sys.exit(4)
    print(f"gallery: {arguments.docs / 'gallery.md'}")


if __name__ == "__main__":
    main()
