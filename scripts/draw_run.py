#!/usr/bin/python3
"""Draws the pictures of a run: draw_run.py OUT [OUT ...] writes OUT/pictures/*.png.

flow_and_pressure, probes, leaflets_above, leaflets_side, midplane, markers, step, centre_line, closure, pv_loop; some also
as .svg. Needs no display and also works during a run. A picture whose input is missing is skipped with a message.
"""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from drawing import (balances, centre_line, closing, leaflets, markers, midplane, probes, pv_loop, steps,  # noqa: E402
                     style, traces)
from drawing.run_output import Missing  # noqa: E402

PICTURES = [
    ("flow_and_pressure", traces.draw),
    ("probes", probes.draw),
    ("leaflets_above, leaflets_side", leaflets.draw),
    ("midplane", midplane.draw),
    ("markers", markers.draw),
    ("step", steps.draw),
    ("centre_line", centre_line.draw),
    ("closure", closing.draw),
    ("pv_loop", pv_loop.draw),
]
COLUMNS = [  # for the report: at the width of one column
    ("flow_and_pressure_column", traces.draw_column),
    ("probes_column", lambda out, pictures: probes.draw(out, pictures, style.COLUMN_WIDTH, "probes_column")),
    ("leaflets_above_column, leaflets_side_column", leaflets.draw_columns),
    ("midplane_pressure, midplane_speed", midplane.draw_columns),
    ("markers_column", markers.draw_column),
    ("step_column", lambda out, pictures: steps.draw(out, pictures, style.COLUMN_WIDTH, "step_column")),
    ("balances", balances.draw),
]


def draw_all(out, pictures, wanted, quiet=False):
    """Draws those of the `wanted` pictures of the run in `out` whose input exists. Returns the number of failures.
    `quiet`: reports only failures."""
    pictures.mkdir(exist_ok=True)
    failed = 0
    drawn, skipped = [], []
    for name, draw in wanted:
        try:
            draw(out, pictures)
            drawn.append(name)
        except Missing as missing:
            skipped.append(f"{name} ({missing})")
        except (OSError, KeyError, ValueError, IndexError) as error:
            failed += 1
            print(f"{name}: failed, {type(error).__name__}: {error}", file=sys.stderr)
    if not quiet:
        print(f"pictures: {', '.join(drawn)} in {pictures}")
        if skipped:
            print(f"skipped: {'; '.join(skipped)}")
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="+", type=Path, help="output folder of a run")
    folders = parser.parse_args().out
    for out in folders:
        if not out.is_dir():
            parser.error(f"{out} is not a folder")
    style.apply()
    sys.exit(4 if sum(draw_all(out, out / "pictures", PICTURES) for out in folders) else 0)


if __name__ == "__main__":
    main()
