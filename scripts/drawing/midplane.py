"""midplane: pressure and speed on the plane of constant y through the axis, with sections of the leaflets and the wall.

Optionally with the outlines of the boxes of every refined level.
"""
from collections import namedtuple

import h5py
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator

from . import style
from .fields import boxes_of, middle_of, values
from .instants import choose_frames
from .scene import fit_annulus
from .run_output import Fibers, Missing, leaflet_frames, nearest, read_series, wall_points

INSTANTS = (0, 2, 4, 5)  # of instants.story: closed, peak flow, closing, closed
Patch = namedtuple("Patch", "level h z x pressure speed")  # cm; z and x as (low, high); values as [x, z]
Plane = namedtuple("Plane", "what t patches cut")
LABELS = {"pressure": "pressure (mmHg)", "speed": "speed (cm/s)"}
COLORS = {"pressure": "viridis", "speed": style.SPEED}
GRID_COLORS = ["#ffffff", "#ffd23f", "#ff4f79", "#ffffff"]


def read_plane(path, y=None):
    """([Patch], y), coarse to fine, on the cells that contain y; by default y is the centre of the domain."""
    patches = []
    with h5py.File(path, "r") as file:
        origin = file["VTKHDF"].attrs["Origin"]
        y = middle_of(file)[1] if y is None else y
        for box in boxes_of(file):
            row = int(np.floor((y - origin[1]) / box.h - 1e-9))
            if box.lo[1] <= row <= box.hi[1]:
                p, u = (values(box, name)[:, row - box.lo[1]] for name in ("pressure_mmHg", "velocity_cm_s"))
                x, z = (origin[d] + box.h * np.array([box.lo[d], box.hi[d] + 1]) for d in (0, 2))
                patches.append(Patch(box.level, box.h, z, x, p.T, np.linalg.norm(u, axis=2).T))
    return patches, y


def cut_of_leaflets(fibers, y):
    """Points (n, 3) where the leaflets' fibres cross the plane."""
    ends = np.concatenate([fibers.points[fibers.lines_of(g)] for g in fibers.groups_like("leaflet")] or
                          [np.zeros((0, 2, 3))])
    side = ends[:, :, 1] - y
    crossing = side[:, 0] * side[:, 1] <= 0
    ends, side = ends[crossing], side[crossing]
    share = side[:, :1] / np.where(side[:, :1] == side[:, 1:], 1, side[:, :1] - side[:, 1:])
    return ends[:, 0] + share * (ends[:, 1] - ends[:, 0])


def draw(out, pictures):
    planes, wall = read_planes(out, INSTANTS)
    draw_planes(planes, wall, [("pressure", False), ("speed", False)], pictures, "midplane")


def draw_columns(out, pictures):
    """midplane_pressure with the grid and midplane_speed, each at the width of one column."""
    planes, wall = read_planes(out, INSTANTS)
    draw_planes(planes, wall, [("pressure", True)], pictures, "midplane_pressure", style.COLUMN_WIDTH)
    draw_planes(planes, wall, [("speed", False)], pictures, "midplane_speed", style.COLUMN_WIDTH)


def read_planes(out, instants):
    """([Plane] at the given instants of `story`, the wall points near the plane or None)."""
    chosen = choose_frames(out, read_series(out / "fields"), instants)
    structure, y = structure_and_axis(out)
    planes = []
    for what, t, path in chosen:
        patches, y = read_plane(path, y)
        planes.append(Plane(what, t, patches, cut_at(structure, t, y)))
    return planes, wall_near(out, y) if structure else None


def structure_and_axis(out):
    """(frames of the leaflets, y of the axis): ([], None) without leaflets."""
    try:
        structure = leaflet_frames(out)
        return structure, fit_annulus(Fibers(structure[0][1]))[0][1]
    except Missing:
        return [], None


def wall_near(out, y):
    wall = wall_points(out)
    return None if wall is None else wall[np.abs(wall[:, 1] - y) < 0.04]


def draw_planes(planes, wall, columns, pictures, name, page_width=style.PAGE_WIDTH):
    """Draws one row per plane and one column per (field, whether the grid is drawn)."""
    rows, first = len(planes), planes[0].patches
    z0, z1 = min(p.z[0] for p in first), max(p.z[1] for p in first)
    x0, x1 = min(p.x[0] for p in first), max(p.x[1] for p in first)
    margin = 0.46 / page_width
    width = (page_width * (1 - margin) - 0.11) / (len(columns) + 0.165 * (len(columns) - 1))
    height = width * (x1 - x0) / (z1 - z0)
    total = rows * (height + 0.24) + 1.0
    figure, axes = plt.subplots(rows, len(columns), sharex=True, sharey=True, squeeze=False,
                                figsize=(page_width, total))
    figure.subplots_adjust(left=margin, right=1 - 0.11 / page_width, top=1 - 0.24 / total, bottom=0.93 / total,
                           wspace=0.165, hspace=0.24 / height)
    for (field, with_grid), column in zip(columns, axes.T):
        low, high = _range([getattr(patch, field) for plane in planes for patch in plane.patches])
        low = 0 if field == "speed" else low
        for plane, panel in zip(planes, column):
            for patch in plane.patches:
                panel.imshow(getattr(patch, field), extent=(*patch.z, *patch.x), origin="lower", cmap=COLORS[field],
                             aspect="equal", vmin=low, vmax=high, interpolation="nearest")
            if with_grid:
                _draw_grid(panel, plane.patches)
            _draw_structure(panel, wall, plane.cut)
            _dress(panel, (z0, z1), (x0, x1))
        _draw_bar(figure, column[-1], field, total)
    for plane, panel in zip(planes, axes[:, 0]):
        panel.text(0, 1.03, f"{plane.t:.3f} s   {plane.what}", transform=panel.transAxes, va="bottom")
        panel.set_ylabel("x (cm)")
    style.save(figure, pictures, name)


def _draw_structure(panel, wall, cut):
    if wall is not None:
        panel.plot(wall[:, 2], wall[:, 0], ".", color="#9a9a9a", markersize=1.0, markeredgewidth=0)
    for color, size in (("white", 3.0), ("black", 1.7)):
        panel.plot(cut[:, 2], cut[:, 0], ".", color=color, markersize=size, markeredgewidth=0)


def _draw_grid(panel, patches):
    """Draws the outlines of the boxes of every level but the coarsest."""
    for patch in patches:
        if patch.level > 0:
            panel.add_patch(Rectangle((patch.z[0], patch.x[0]), np.ptp(patch.z), np.ptp(patch.x), fill=False,
                                      edgecolor=GRID_COLORS[(patch.level - 1) % 4], linewidth=0.7))


def _dress(panel, z, x):
    panel.set_xlim(*z)
    panel.set_ylim(*x)
    panel.xaxis.set_major_locator(MaxNLocator(3, steps=[1, 5, 10]))
    panel.yaxis.set_major_locator(MaxNLocator(4, integer=True))
    for spine in panel.spines.values():
        spine.set_visible(True)


def _draw_bar(figure, panel, field, total):
    panel.set_xlabel("z (cm)")
    place = panel.get_position()
    bar = figure.add_axes([place.x0 + 0.12 * place.width, 0.42 / total, 0.76 * place.width, 0.09 / total])
    figure.colorbar(panel.images[0], cax=bar, orientation="horizontal", label=LABELS[field],
                    extend="max" if field == "speed" else "both")


def cut_at(structure, t, y):
    """Where the leaflets of the frame nearest to t cross the plane."""
    if not structure:
        return np.zeros((0, 3))
    return cut_of_leaflets(Fibers(nearest(structure, t)[1]), y)


def _range(arrays):
    """Round limits that contain all but the outermost thousandth of the values."""
    values = np.concatenate([a.ravel() for a in arrays])
    low, high = np.percentile(values, [0.1, 99.9])
    if high - low < 1e-6:
        return low - 0.5, high + 0.5
    ticks = MaxNLocator(8).tick_values(low, high)
    return ticks[0], ticks[-1]
