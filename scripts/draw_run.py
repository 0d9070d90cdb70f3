#!/usr/bin/python3
"""Draws the pictures of a run: draw_run.py OUT [OUT ...] writes OUT/pictures/*.png.

flow_and_pressure (also .svg), probes, leaflets_above, leaflets_side, midplane, step. Needs no display and can be
called while the run goes on. A picture whose input is not there is left out, with one line that says why.
"""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from drawing import leaflets, midplane, probes, steps, style, traces  # noqa: E402
from drawing.run_output import Missing  # noqa: E402

PICTURES = [
    ("flow_and_pressure", traces.draw),
    ("probes", probes.draw),
    ("leaflets_above, leaflets_side", leaflets.draw),
    ("midplane", midplane.draw),
    ("step", steps.draw),
]


def draw_run(out):
    """Draws what can be drawn of the run in `out`; returns the number of pictures that failed."""
    pictures = out / "pictures"
    pictures.mkdir(exist_ok=True)
    failed = 0
    for name, draw in PICTURES:
        try:
            draw(out, pictures)
            print(f"{name}: drawn")
        except Missing as missing:
            print(f"{name}: left out, {missing}")
        except (OSError, KeyError, ValueError, IndexError) as error:
            failed += 1
            print(f"{name}: failed, {type(error).__name__}: {error}", file=sys.stderr)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="+", type=Path, help="output folder of a run")
    folders = parser.parse_args().out
    for out in folders:
        if not out.is_dir():
            parser.error(f"{out} is not a folder")
    style.apply()
    sys.exit(4 if sum(draw_run(out) for out in folders) else 0)


if __name__ == "__main__":
    main()
