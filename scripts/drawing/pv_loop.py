"""pv_loop: pressure over volume of the ejecting ventricle, if the network has one; earlier beats are paler."""
import matplotlib.pyplot as plt
import numpy as np

from . import style
from .run_output import Missing, columns_like, read_table


def ventricle(table):
    """(volume in ml, pressure in mmHg) of the chamber that ejects through the main valve."""
    volumes = columns_like(table, r"(.+)\.V_ml")
    pressures = columns_like(table, r"p_(.+)_mmHg")
    port = next((p for p in ("lv", "ventricle", "left_ventricle") if p in pressures), None)
    if not volumes or port is None:
        raise Missing("the network has no ventricle with a volume")
    named = [name for name in volumes if "ventricle" in name and "right" not in name or name == "lv"]
    return volumes[named[0] if named else next(iter(volumes))], pressures[port]


def draw(out, pictures):
    table = read_table(out / "openings.csv")
    volume, pressure = ventricle(table)
    t = table["t_s"]
    try:
        starts = read_table(out / "beats.csv")["start_s"]
    except Missing:
        starts = t[:1]
    figure, axes = plt.subplots(figsize=(style.COLUMN_WIDTH, 2.9))
    edges = np.append(starts, t[-1] + 1)[-4:]
    for age, (start, end) in enumerate(zip(edges[-2::-1], edges[:0:-1])):
        beat = (t >= start) & (t <= end)
        axes.plot(volume[beat], pressure[beat], color=style.VENTRICLE, alpha=(1, 0.35, 0.2)[age], zorder=3 - age)
    axes.set_xlabel("volume of the left ventricle (ml)")
    axes.set_ylabel("pressure (mmHg)")
    axes.set_ylim(bottom=min(0, axes.get_ylim()[0]))
    figure.tight_layout(pad=0.5)
    style.save(figure, pictures, "pv_loop", "svg")
