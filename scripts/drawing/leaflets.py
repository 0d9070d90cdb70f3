"""leaflets_above, leaflets_side: the leaflets' fibres at the instants of the beat, in parallel projection.

Near fibres hide far ones: each depth's fibres are drawn as broad pale strokes, which make a surface, and a little
later as thin lines, from far to near.
"""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb

from . import style
from .instants import choose_frames
from .run_output import Fibers, Missing, leaflet_frames, wall_points

DEPTHS = 48      # layers of the painter
MARGIN = 0.18    # cm around the drawing

VIEWS = {  # name: right, up, towards the eye; cm by which surfaces lie behind their lines (more for steep ones)
    "above": ((1, 0, 0), (0, 1, 0), (0, 0, 1), 0.18),
    "side": ((1, 0, 0), (0, 0, 1), (0, -1, 0), 0.09),
}


def draw(out, pictures):
    frames = [(what, t, Fibers(path)) for what, t, path in choose_frames(out, leaflet_frames(out))]
    if not any(f.groups_like("leaflet") for _, _, f in frames):
        raise Missing("the files in structure/ have no group named leaflet")
    annulus = fit_annulus(frames[0][2])
    wall = wall_points(out)
    for view in VIEWS:
        _draw_view(view, frames, annulus, wall, pictures)


def fit_annulus(fibers):
    """(centre (3), radius) of the circle through the attachment: the leaflets' outline as seen along the axis."""
    points = fibers.points[np.isin(fibers.group, fibers.groups_like("leaflet"))]
    middle = points[:, :2].mean(axis=0)
    angle = np.arctan2(*(points[:, :2] - middle).T[::-1])
    reach = np.linalg.norm(points[:, :2] - middle, axis=1)
    sector = np.digitize(angle, np.linspace(-np.pi, np.pi, 73))
    outline = np.array([points[sector == s][np.argmax(reach[sector == s]), :2] for s in np.unique(sector)])
    # x^2 + y^2 = 2 a x + 2 b y + c is linear in centre (a, b) and c = R^2 - a^2 - b^2
    a, b, c = np.linalg.lstsq(np.c_[2 * outline, np.ones(len(outline))], (outline ** 2).sum(axis=1), rcond=None)[0]
    return np.array([a, b, points[:, 2].min()]), float(np.sqrt(c + a * a + b * b))


def _draw_view(view, frames, annulus, wall, pictures):
    centre, radius = annulus
    right, up, eye = (np.array(v, float) for v in VIEWS[view][:3])
    moving = np.concatenate([f.points[np.isin(f.group, f.groups_like("leaflet"))] for _, _, f in frames])
    depth = (moving @ eye).min(), (moving @ eye).max()
    section = np.zeros((0, 3))
    if view == "side" and wall is not None:
        at_valve = (wall[:, 2] > moving[:, 2].min() - MARGIN) & (wall[:, 2] < moving[:, 2].max() + 2 * MARGIN)
        section = wall[at_valve & (np.abs((wall - centre) @ eye) < 0.05)]
    reach = np.concatenate([moving, section, centre + radius * np.array([[-1, -1, 0], [1, 1, 0]])])
    low, high = (np.array([f(reach @ axis) for axis in (right, up)]) for f in (np.min, np.max))
    low, high = low - [MARGIN, 2 * MARGIN], high + MARGIN

    size = high - low
    columns, rows = min(3, len(frames)), -(-len(frames) // 3)
    width = style.PAGE_WIDTH / 3
    height = width * size[1] / size[0] + 0.3
    figure, axes = plt.subplots(rows, columns, squeeze=False, figsize=(width * columns, height * rows + 0.06))
    figure.subplots_adjust(left=0.01, right=0.99, top=1 - 0.3 / (height * rows), bottom=0.012, wspace=0.03,
                           hspace=0.3 / (height - 0.3))
    for panel in axes.flat:
        panel.set_axis_off()
        panel.set_aspect("equal")
        panel.set_xlim(low[0], high[0])
        panel.set_ylim(low[1], high[1])
    for panel, letter, (what, t, fibers) in zip(axes.flat, "abcdef", frames):
        panel.plot(section @ right, section @ up, ".", color="#a8a8a8", markersize=1.8, markeredgewidth=0, zorder=0)
        _draw_annulus(panel, annulus, right, up, eye)
        _draw_leaflets(panel, fibers, right, up, eye, depth, VIEWS[view][3])
        style.letter(panel, letter, x=0.03)
        panel.text(0.10, 1.02, f"{t:.3f} s   {what}", transform=panel.transAxes, va="bottom")
    _draw_scale(axes.flat[0], low[0] + 0.08 if view == "above" else centre[0] - 0.5)
    style.save(figure, pictures, f"leaflets_{view}")


def _draw_annulus(panel, annulus, right, up, eye):
    centre, radius = annulus
    angle = np.linspace(0, 2 * np.pi, 181)
    ring = centre + radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    panel.plot(ring @ right, ring @ up, color=style.GREY, linewidth=0.9, zorder=0.5)


def _draw_leaflets(panel, fibers, right, up, eye, depth, delay):
    segments, colors, depths, lengths = [], [], [], []
    for number, group in enumerate(fibers.groups_like("leaflet")):
        ends = fibers.points[fibers.lines_of(group)]
        segments.append(np.stack([ends @ right, ends @ up], axis=2))
        depths.append((ends @ eye).mean(axis=1))
        lengths.extend(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))
        colors.append(np.tile(to_rgb(style.LEAFLETS[number % 3]), (len(ends), 1)))
    segments, depths, colors = (np.concatenate(part) for part in (segments, depths, colors))
    nearness = np.clip((depths - depth[0]) / max(depth[1] - depth[0], 1e-9), 0, 1)[:, None]
    lines = 1 - (1 - colors) * (0.45 + 0.55 * nearness)
    faces = 1 - (1 - colors) * (0.10 + 0.16 * nearness)

    surface = 1.1 * np.median(lengths) * points_per_cm(panel)
    step = max(depth[1] - depth[0], 1e-9) / DEPTHS
    layer = np.floor((depths - depth[0]) / step).astype(int)
    late = int(np.ceil(delay / step))
    for now in range(DEPTHS + late + 2):
        _stroke(panel, segments, faces, layer == now, surface, now)
        _stroke(panel, segments, lines, layer == now - late, 0.38, now + 0.5)


def points_per_cm(panel):
    """Typographic points per cm of the structure in a panel with equal axes."""
    box = panel.get_position()
    inches = np.array([box.width, box.height]) * panel.figure.get_size_inches()
    return 72 * np.min(inches / [np.ptp(panel.get_xlim()), np.ptp(panel.get_ylim())])


def _stroke(panel, segments, colors, mine, width, order):
    if np.any(mine):
        panel.add_collection(LineCollection(segments[mine], colors=colors[mine], linewidths=width, capstyle="round",
                                            zorder=1 + 0.01 * order))


def _draw_scale(panel, x):
    """One centimetre."""
    y = panel.get_ylim()[0] + 0.01
    panel.plot([x, x + 1], [y, y], color=style.INK, linewidth=1.4, solid_capstyle="butt")
    panel.text(x + 0.5, y + 0.02, "1 cm", ha="center", va="bottom", fontsize=7.5)
