"""centre_line: pressure along the axis of the vessel at four instants: closed, opening, peak flow, closed again."""
import itertools

import h5py
import matplotlib.pyplot as plt
import numpy as np

from . import style
from .fields import boxes_of, middle_of, values
from .instants import choose_frames
from .midplane import structure_and_axis
from .run_output import Fibers, read_series
from .scene import fit_annulus

INSTANTS = (0, 1, 2, 5)
LINES = [("#2f6db3", "-"), ("#3a8f5c", "--"), ("#c8443c", "-"), ("#222222", (0, (1.5, 1.5)))]


def read_line(path, axis=None):
    """(z, pressure): the mean of the cells around the axis (x, y), from the finest level available."""
    z, p = np.zeros(0), np.zeros(0)
    with h5py.File(path, "r") as file:
        origin = file["VTKHDF"].attrs["Origin"]
        axis = middle_of(file) if axis is None else axis
        for _, boxes in itertools.groupby(boxes_of(file), key=lambda box: box.level):
            sums, counts = {}, {}
            for box in boxes:
                h, pressure = box.h, values(box, "pressure_mmHg")
                near = [[int(np.floor((axis[d] - origin[d]) / h + shift)) for shift in (-1e-6, 1e-6)] for d in (0, 1)]
                for i, j in {(i, j) for i in near[0] for j in near[1]}:
                    if box.lo[0] <= i <= box.hi[0] and box.lo[1] <= j <= box.hi[1]:
                        for k, value in enumerate(pressure[:, j - box.lo[1], i - box.lo[0]], start=box.lo[2]):
                            sums[k], counts[k] = sums.get(k, 0) + value, counts.get(k, 0) + 1
            here = np.array(sorted(sums), dtype=int)
            fine = origin[2] + (here + 0.5) * h
            left = np.array([np.all(np.abs(fine - q) > 1.01 * h) for q in z], dtype=bool)
            z = np.concatenate([z[left], fine])
            p = np.concatenate([p[left], [sums[k] / counts[k] for k in here]])
            z, p = z[np.argsort(z)], p[np.argsort(z)]
    return z, p


def draw(out, pictures):
    draw_lines(out, choose_frames(out, read_series(out / "fields"), INSTANTS), pictures, "centre_line")


def axis_of(out):
    """(x, y) of the axis of the vessel; None without leaflets."""
    structure, _ = structure_and_axis(out)
    return fit_annulus(Fibers(structure[0][1]))[0][:2] if structure else None


def draw_lines(out, chosen, pictures, name):
    """Draws one line per (what, time, path of the fields)."""
    axis = axis_of(out)
    figure, axes = plt.subplots(figsize=(style.COLUMN_WIDTH, 3.0))
    for (what, t, path), (color, line) in zip(chosen, LINES):
        axes.plot(*read_line(path, axis), color=color, linestyle=line, label=f"{t:.2f} s {what}".strip())
    axes.set_xlabel("z (cm)")
    axes.set_ylabel("pressure (mmHg)")
    axes.set_xlim(left=0)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.16, 1.0), ncol=2, borderaxespad=0,
                columnspacing=0.8, handlelength=1.5, fontsize=7)
    figure.tight_layout(pad=0.5)
    style.save(figure, pictures, name, "svg")
