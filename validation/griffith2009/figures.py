#!/usr/bin/python3
"""Figures 2 to 7 of AIAA 2009-158 from a run, and the paper's statements compared with the run.

    figures.py RUN [-o FOLDER]

Writes FOLDER/figures/figure_2.png ... figure_7.png and FOLDER/README.md, a copy of the page next to this script with the
table of the run. Without -o it updates that page in place. Figure 4 needs markers in RUN/structure ([[markers]] of the case).
"""
import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "scripts"), str(HERE)]
import statements  # noqa: E402
from drawing import centre_line, closing, markers, midplane, style  # noqa: E402
from drawing.run_output import Fibers, Missing, leaflet_frames, wall_points  # noqa: E402
from drawing.scene import VIEWS, Scene, fit_annulus  # noqa: E402

ZOOMS = ((0.4, 0.5), (0.405, 0.41))  # s, the paper's


def figure_2(out, folder):
    """The valve at the start from above and from the side."""
    t, path = leaflet_frames(out)[0]
    fibers = Fibers(path)
    figure, axes = plt.subplots(1, 2, figsize=(style.PAGE_WIDTH, 3.2))
    for panel, view, letter in zip(axes, VIEWS, "ab"):
        scene = Scene(view, [fibers], wall_points(out))
        panel.imshow(np.asarray(scene.image(fibers, 900)), extent=scene.extent)
        panel.set_axis_off()
        style.letter(panel, letter)
        panel.text(0.07, 1.02, f"from the {'aorta' if view == 'above' else 'side'}", transform=panel.transAxes)
    figure.tight_layout(pad=0.4)
    style.save(figure, folder, "figure_2")


def figure_3(out, folder):
    """The root with inlet tube and ascending aorta, whole and with the near half removed."""
    wall, fibers = wall_points(out), Fibers(leaflet_frames(out)[0][1])
    if wall is None:
        raise Missing("no wall")
    centre = fit_annulus(fibers)[0]
    tilt = np.radians(18)  # seen slightly from the aorta
    up = np.array([0, np.sin(tilt), np.cos(tilt)])
    eye = np.array([0, -np.cos(tilt), np.sin(tilt)])
    figure, axes = plt.subplots(1, 2, figsize=(0.8 * style.PAGE_WIDTH, 7.0))
    for panel, is_cut, letter in zip(axes, (False, True), "ab"):
        shown = wall[wall[:, 1] > centre[1] - 0.05] if is_cut else wall
        shown = shown[np.argsort(shown @ eye)]
        outward = shown[:, :2] - centre[:2]
        outward /= np.linalg.norm(outward, axis=1, keepdims=True)
        # lit from the front left; the far side shows its inner face
        facing = np.where((outward[:, 1] < 0)[:, None], outward, -outward)
        light = 0.52 + 0.40 * np.clip(facing @ [-0.55, -0.83], 0, 1)
        panel.scatter(shown[:, 0], shown @ up, s=4.5, c=np.stack([light, light, 1.02 * light], axis=1), linewidths=0)
        for number, group in enumerate(fibers.groups_like("leaflet") if is_cut else []):
            ends = fibers.points[fibers.lines_of(group)]
            panel.plot(ends[:, :, 0].T, (ends @ up).T, color=style.LEAFLETS[number % 3], linewidth=0.4,
                       zorder=3 - 0.1 * ends[:, :, 1].mean())
        panel.set_aspect("equal")
        panel.set_axis_off()
        style.letter(panel, letter)
        panel.text(0.08, 1.02, "near half removed" if is_cut else "wall", transform=panel.transAxes)
    figure.tight_layout(pad=0.4)
    style.save(figure, folder, "figure_3")


def figure_4(out, folder):
    """Passive markers near the plane through the axis: just before and after opening, just before and after closing."""
    markers.draw(out, folder, "figure_4")


def figure_5(out, folder):
    """Pressure on the centre line at the four instants of the paper."""
    centre_line.draw_lines(out, statements.line_frames(out), folder, "figure_5")


def figure_6(out, folder):
    """Pressure on the mid-plane while the closed valve bears its load, without and with the grid."""
    planes, wall = midplane.read_planes(out, (5,))
    midplane.draw_planes(planes, wall, [("pressure", False), ("pressure", True)], folder, "figure_6")


def figure_7(out, folder):
    """Flow through the valve, and the two enlargements of the paper."""
    t, q = statements.valve_flow(out)
    closing.draw_zooms(t, q, ((t[0], t[-1]), *ZOOMS), "valve", folder, "figure_7")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=Path, help="output folder of a run of the paper's protocol")
    parser.add_argument("-o", "--out", type=Path, default=HERE, help="folder for README.md and figures/")
    arguments = parser.parse_args()
    folder = arguments.out / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    style.apply()
    plt.rcParams["savefig.dpi"] = 130
    drawn = {}
    for number, draw in enumerate((figure_2, figure_3, figure_4, figure_5, figure_6, figure_7), start=2):
        try:
            draw(arguments.run, folder)
            drawn[number] = draw.__doc__
            print(f"figure {number}: drawn")
        except Missing as reason:
            print(f"figure {number}: skipped, {reason}")
    try:
        statements.fill_page(HERE / "README.md", arguments.out / "README.md", arguments.run, drawn)
    except (Missing, OSError) as reason:
        print(f"figures: {arguments.run}: {reason}", file=sys.stderr)
        sys.exit(4)
    print(f"figures: {arguments.out / 'README.md'}")


if __name__ == "__main__":
    main()
