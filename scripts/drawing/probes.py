"""probes: pressure on the centre line, orifice area and maximum strains over time."""
import matplotlib.pyplot as plt
import numpy as np

from . import style
from .run_output import Missing, columns_like, read_table


def draw(out, pictures, width=style.PAGE_WIDTH, title="probes"):
    table = read_table(out / "probes.csv")
    t = table["t_s"]
    pressures = columns_like(table, r"p_z(.+)_mmHg")
    strains = columns_like(table, r"(.*strain.*)")
    rows = [part for part, there in
            (("pressure", pressures), ("area", "area_cm2" in table), ("strain", strains)) if there]
    if not rows:
        raise Missing("probes.csv has none of the known columns")
    figure, axes = plt.subplots(len(rows), 1, sharex=True, squeeze=False,
                                figsize=(width, 1.65 * len(rows) + 0.7))
    axes = dict(zip(rows, axes[:, 0]))
    if pressures:
        colors = plt.get_cmap("viridis")(np.linspace(0.0, 0.92, len(pressures)))
        for (z, p), color in zip(pressures.items(), colors):
            axes["pressure"].plot(t, p, color=color, linewidth=1.0, label=f"z = {z} cm")
        axes["pressure"].set_ylabel("pressure (mmHg)")
        axes["pressure"].legend(loc="lower left", bbox_to_anchor=(0, 1.0), borderaxespad=0, columnspacing=1.0,
                                handlelength=1.2, ncol=6 if width > style.COLUMN_WIDTH else 3,
                                fontsize=8 if width > style.COLUMN_WIDTH else 7)
    if "area" in axes:
        axes["area"].plot(t, table["area_cm2"], color=style.INK)
        axes["area"].set_ylabel("orifice area (cm²)")
        axes["area"].set_ylim(bottom=0)
    if strains:
        for (name, strain), color in zip(strains.items(), [style.LEAFLETS[0], style.GREY] + style.OTHERS):
            axes["strain"].plot(t, 100 * strain, color=color, linewidth=1.0, label=_strain_label(name))
        axes["strain"].set_ylabel("maximum strain (%)")
        axes["strain"].legend(loc="upper right")
    last = axes[rows[-1]]
    last.set_xlabel("time (s)")
    last.set_xlim(t[0], max(t[-1], t[0] + 1e-6))
    figure.align_ylabels(list(axes.values()))
    figure.tight_layout(pad=0.6)
    style.save(figure, pictures, title)


def _strain_label(name):
    return name.removesuffix("_max").replace("_", " ")
