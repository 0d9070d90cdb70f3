"""midplane: pressure and speed on the plane through the axis (y = the axis'), with the leaflets and the wall cut."""
import h5py
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from . import style
from .instants import choose_frames
from .leaflets import fit_annulus
from .run_output import Fibers, Missing, leaflet_frames, read_series, wall_points

INSTANTS = (0, 2, 4, 5)  # of the story: closed, peak flow, closing, closed


def read_plane(path, y=None):
    """([(z range, x range, pressure[x, z], speed[x, z])], y), coarse to fine, on the cells that hold y.

    Without y the middle of the domain.
    """
    patches = []
    with h5py.File(path, "r") as file:
        root = file["VTKHDF"]
        origin = root.attrs["Origin"]
        for name in sorted((k for k in root if k.startswith("Level")), key=lambda k: int(k[5:])):
            level = root[name]
            h = level.attrs["Spacing"][0]
            boxes = level["AMRBox"][:].reshape(-1, 3, 2)
            if y is None:
                y = origin[1] + 0.5 * h * (boxes[:, 1, 1].max() + 1)
            row = int(np.floor((y - origin[1]) / h - 1e-9))
            first = 0
            for box in boxes:
                n = box[:, 1] - box[:, 0] + 1
                last = first + int(np.prod(n))
                if box[1, 0] <= row <= box[1, 1]:
                    shape, j = (n[2], n[1], n[0]), row - box[1, 0]
                    p = level["CellData/pressure_mmHg"][first:last].reshape(shape)[:, j]
                    u = level["CellData/velocity_cm_s"][first:last].reshape(*shape, 3)[:, j]
                    x, z = (origin[d] + h * np.array([box[d, 0], box[d, 1] + 1]) for d in (0, 2))
                    patches.append((z, x, p.T, np.linalg.norm(u, axis=2).T))
                first = last
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
    chosen = choose_frames(out, read_series(out / "fields"), INSTANTS)
    try:
        structure = leaflet_frames(out)
        y = fit_annulus(Fibers(structure[0][1]))[0][1]
    except Missing:
        structure, y = [], None
    planes = []
    for what, t, path in chosen:
        patches, y = read_plane(path, y)
        planes.append((what, t, patches, _cut_at(structure, t, y)))
    wall = wall_points(out) if structure else None
    if wall is not None:
        wall = wall[np.abs(wall[:, 1] - y) < 0.04]

    rows = len(planes)
    (z0, z1), (x0, x1) = planes[0][2][0][0], planes[0][2][0][1]
    for patch in planes[0][2]:
        z0, z1, x0, x1 = min(z0, patch[0][0]), max(z1, patch[0][1]), min(x0, patch[1][0]), max(x1, patch[1][1])
    width = 0.425 * style.PAGE_WIDTH
    height = width * (x1 - x0) / (z1 - z0)
    total = rows * (height + 0.24) + 1.0
    figure, axes = plt.subplots(rows, 2, sharex=True, sharey=True, squeeze=False, figsize=(style.PAGE_WIDTH, total))
    figure.subplots_adjust(left=0.065, right=0.985, top=1 - 0.24 / total, bottom=0.93 / total, wspace=0.165,
                           hspace=0.24 / height)
    fields = [[patch[field] for plane in planes for patch in plane[2]] for field in (2, 3)]
    ranges = [_range(fields[0]), (0, _range(fields[1])[1])]
    looks = [("viridis", "pressure (mmHg)"), (style.SPEED, "speed (cm/s)")]
    for row, (what, t, patches, cut) in zip(axes, planes):
        for field, panel in enumerate(row):
            for z, x, *values in patches:
                panel.imshow(values[field], extent=(*z, *x), origin="lower", cmap=looks[field][0], aspect="equal",
                             vmin=ranges[field][0], vmax=ranges[field][1], interpolation="nearest")
            if wall is not None:
                panel.plot(wall[:, 2], wall[:, 0], ".", color="#9a9a9a", markersize=1.0, markeredgewidth=0)
            for color, size in (("white", 3.0), ("black", 1.7)):
                panel.plot(cut[:, 2], cut[:, 0], ".", color=color, markersize=size, markeredgewidth=0)
            panel.set_xlim(z0, z1)
            panel.set_ylim(x0, x1)
            panel.xaxis.set_major_locator(MaxNLocator(3, steps=[1, 5, 10]))
            panel.yaxis.set_major_locator(MaxNLocator(4, integer=True))
            for spine in panel.spines.values():
                spine.set_visible(True)
        row[0].text(0, 1.03, f"{t:.3f} s   {what}", transform=row[0].transAxes, va="bottom")
        row[0].set_ylabel("x (cm)")
    for field, (panel, (_, label)) in enumerate(zip(axes[-1], looks)):
        panel.set_xlabel("z (cm)")
        place = panel.get_position()
        bar = figure.add_axes([place.x0 + 0.12 * place.width, 0.42 / total, 0.76 * place.width, 0.09 / total])
        figure.colorbar(panel.images[0], cax=bar, orientation="horizontal", label=label,
                        extend="both" if field == 0 else "max")
    style.save(figure, pictures, "midplane")


def _cut_at(structure, t, y):
    if not structure:
        return np.zeros((0, 3))
    return cut_of_leaflets(Fibers(min(structure, key=lambda f: abs(f[0] - t))[1]), y)


def _range(arrays):
    """Round limits that hold all but the outermost thousandth of the values."""
    values = np.concatenate([a.ravel() for a in arrays])
    low, high = np.percentile(values, [0.1, 99.9])
    if high - low < 1e-6:
        return low - 0.5, high + 0.5
    ticks = MaxNLocator(8).tick_values(low, high)
    return ticks[0], ticks[-1]
