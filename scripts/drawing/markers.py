"""markers: passive markers near the plane through the axis, just before and after the valve opens and closes."""
import h5py
import matplotlib.pyplot as plt
import numpy as np

from . import midplane, style
from .instants import main_flow
from .metrics import ejection, last_beat_of_run
from .run_output import Missing, nearest, read_series, read_table

SLICE = 0.3           # cm on either side of the plane
AFTER_OPENING = 0.04  # s


class Markers:
    """The markers of one file: points (n, 3) in cm and the group of each."""

    def __init__(self, path):
        with h5py.File(path, "r") as file:
            self.points = file["VTKHDF/Points"][:].reshape(-1, 3).astype(float)
            self.group = file["VTKHDF/PointData/group"][:]
            names = file.attrs.get("group_names", b"")
            self.names = (names.decode() if isinstance(names, bytes) else str(names)).split("\n")

    def kinds(self):
        """{group name up to a comma: numbers of its groups}"""
        kinds = {}
        for number, name in enumerate(self.names):
            kinds.setdefault(name.partition(",")[0], []).append(number)
        return kinds


def instants(out):
    """[(what, time)]: just before and after opening, just before and after closing."""
    table = read_table(out / "openings.csv")
    t, q = table["t_s"], main_flow(table)[1]
    start, end = ejection(t, q)
    beat = last_beat_of_run(out) or {}
    wanted = [("just before opening", start), ("just after opening", start + AFTER_OPENING)]
    if end < t[-1]:
        wanted += [("just before closing", end), ("just after closing", beat.get("closing_s", end + 0.05))]
    else:
        wanted.append(("latest", end))
    return [(what, when) for what, when in wanted if when <= t[-1]]


def draw(out, pictures, name="markers", page_width=style.PAGE_WIDTH):
    frames = read_series(out / "structure", "markers")
    structure, y = midplane.structure_and_axis(out)
    wall = midplane.wall_near(out, y) if structure else None
    shown = []
    for what, wanted in instants(out):
        t, path = nearest(frames, wanted)
        markers = Markers(path)
        y = float(np.mean(markers.points[:, 1])) if y is None and len(markers.points) else y
        shown.append((what, t, markers, midplane.cut_at(structure, t, y)))
    if not any(len(markers.points) for _, _, markers, _ in shown):
        raise Missing("no markers in the files in structure/")
    place = np.concatenate([m.points for _, _, m, _ in shown] + ([] if wall is None else [wall]))
    (x0, x1), (z0, z1) = ((place[:, d].min() - 0.1, place[:, d].max() + 0.1) for d in (0, 2))
    height = (page_width - 0.6) * (x1 - x0) / (z1 - z0)
    total = len(shown) * (height + 0.26) + 0.5
    figure, axes = plt.subplots(len(shown), 1, sharex=True, squeeze=False, figsize=(page_width, total))
    figure.subplots_adjust(left=0.48 / page_width, right=1 - 0.1 / page_width, top=1 - 0.24 / total,
                           bottom=0.42 / total, hspace=0.26 / height)
    for panel, (what, t, markers, cut) in zip(axes[:, 0], shown):
        _draw_panel(panel, markers, cut, wall, y, 0.3 * page_width)
        panel.set(xlim=(z0, z1), ylim=(x0, x1), aspect="equal", ylabel="x (cm)")
        panel.text(0, 1.03, f"{t:.3f} s   {what}", transform=panel.transAxes)
    axes[-1, 0].set_xlabel("z (cm)")
    _name_kinds(axes[0, 0], shown[0][2])
    style.save(figure, pictures, name)


def draw_column(out, pictures):
    draw(out, pictures, "markers_column", style.COLUMN_WIDTH)


def _colors(markers):
    known = {"ventricle": style.VENTRICLE, "aorta": style.AORTA}
    others = iter(2 * style.OTHERS + [style.GREY] * len(markers.names))
    return {kind: known.get(kind) or next(others) for kind in markers.kinds()}


def _draw_panel(panel, markers, cut, wall, y, size):
    if wall is not None:
        panel.plot(wall[:, 2], wall[:, 0], ".", color="#9a9a9a", markersize=0.6 * size, markeredgewidth=0)
    near = np.abs(markers.points[:, 1] - y) < SLICE
    colors = _colors(markers)
    for kind, groups in markers.kinds().items():
        points = markers.points[near & np.isin(markers.group, groups)]
        panel.plot(points[:, 2], points[:, 0], ".", color=colors[kind], markersize=0.9 * size, markeredgewidth=0)
    panel.plot(cut[:, 2], cut[:, 0], ".", color="black", markersize=1.1 * size, markeredgewidth=0)


def _name_kinds(panel, markers):
    """Writes the names of the kinds in their colours above the panel, right-aligned."""
    at = 1.0
    for kind, color in reversed(_colors(markers).items()):
        words = panel.text(at, 1.03, kind, transform=panel.transAxes, color=color, ha="right")
        box = words.get_window_extent(panel.figure.canvas.get_renderer())
        at -= (box.width + 8) / panel.get_window_extent().width
