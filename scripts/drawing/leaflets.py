"""leaflets_above, leaflets_side: the fibres of the leaflets at the instants of the beat, in parallel projection."""
import matplotlib.pyplot as plt
import numpy as np

from . import style
from .instants import choose_frames
from .run_output import Fibers, Missing, leaflet_frames, wall_points
from .scene import VIEWS, Scene

PIXELS = 680  # width of one panel


def draw(out, pictures):
    scenes, frames = _scenes(out)
    for view, scene in scenes.items():
        draw_panels(scene, frames, pictures, f"leaflets_{view}")


def draw_columns(out, pictures):
    """leaflets_above_column, leaflets_side_column: the same at the width of one column."""
    scenes, frames = _scenes(out)
    for view, scene in scenes.items():
        draw_panels(scene, frames, pictures, f"leaflets_{view}_column", 2, style.COLUMN_WIDTH)


def _scenes(out):
    """({view: Scene}, [(what, time, fibres)])"""
    frames = [(what, t, Fibers(path)) for what, t, path in choose_frames(out, leaflet_frames(out))]
    if not any(f.groups_like("leaflet") for _, _, f in frames):
        raise Missing("the files in structure/ have no group named leaflet")
    wall = wall_points(out)
    return {view: Scene(view, [f for _, _, f in frames], wall) for view in VIEWS}, frames


def draw_panels(scene, frames, pictures, name, most_columns=3, page_width=style.PAGE_WIDTH):
    """Draws one panel per (what, time, fibres)."""
    size = scene.size
    columns = min(most_columns, len(frames))
    rows = -(-len(frames) // columns)
    width = page_width / most_columns
    height = width * size[1] / size[0] + 0.3
    figure, axes = plt.subplots(rows, columns, squeeze=False, figsize=(width * columns, height * rows + 0.06))
    figure.subplots_adjust(left=0.01, right=0.99, top=1 - 0.3 / (height * rows), bottom=0.012, wspace=0.03,
                           hspace=0.3 / (height - 0.3))
    for panel in axes.flat:
        panel.set_axis_off()
    small = {"fontsize": 7} if page_width < style.PAGE_WIDTH else {}
    for panel, letter, (what, t, fibers) in zip(axes.flat, "abcdef", frames):
        panel.imshow(np.asarray(scene.image(fibers, PIXELS)), extent=scene.extent)
        style.letter(panel, letter, x=0.03)
        panel.text(0.10, 1.02, f"{t:.3f} s   {what}", transform=panel.transAxes, va="bottom", **small)
    _draw_scale(axes.flat[0], scene)
    style.save(figure, pictures, name)


def _draw_scale(panel, scene):
    """Draws a scale bar of one centimetre."""
    x, y = scene.low[0] + 0.08, scene.low[1] + 0.01
    panel.plot([x, x + 1], [y, y], color=style.INK, linewidth=1.4, solid_capstyle="butt")
    panel.text(x + 0.5, y + 0.02, "1 cm", ha="center", va="bottom", fontsize=7.5)
