"""step: time step, CFL number, iterations, divergence and time per step, from step.csv."""
import matplotlib.pyplot as plt
import numpy as np

from . import style
from .run_output import Missing, read_table

BOUND_COLORS = {"cfl": style.VENTRICLE, "elastic": style.AORTA, "growth": style.INK, "output": style.GREY}
PANELS = [  # column, label, factor
    ("cfl", "CFL number", 1.0),
    ("iterations", "iterations", 1.0),
    ("max_divergence_1_s", "maximum\ndivergence (1/s)", 1.0),
    ("wall_s", "wall time\nper step (ms)", 1e3),
]


def draw(out, pictures, width=style.PAGE_WIDTH, title="step"):
    table = read_table(out / "step.csv")
    if "t_s" not in table or "dt_s" not in table:
        raise Missing("step.csv has no columns t_s and dt_s")
    t = table["t_s"]
    panels = [p for p in PANELS if p[0] in table and not isinstance(table[p[0]], list)]
    figure, axes = plt.subplots(1 + len(panels), 1, sharex=True, squeeze=False,
                                figsize=(width, 1.15 * (1 + len(panels)) + 0.5))
    axes = axes[:, 0]
    _time_step(axes[0], t, table)
    for panel, (name, label, factor) in zip(axes[1:], panels):
        panel.plot(t, factor * table[name], ".", markersize=1.6, color=style.INK, markeredgewidth=0, rasterized=True)
        panel.set_ylabel(label)
        if name == "max_divergence_1_s" and table[name].max() > 0:
            panel.set_yscale("log")
        elif name == "wall_s":  # single steps wait for the disk
            panel.set_ylim(0, 1.5 * np.percentile(factor * table[name], 99))
        else:
            panel.set_ylim(bottom=0)
    axes[-1].set_xlabel("time (s)")
    axes[-1].set_xlim(t[0], max(t[-1], t[0] + 1e-6))
    figure.align_ylabels(axes)
    figure.tight_layout(pad=0.6, h_pad=0.7)
    style.save(figure, pictures, title)


def _time_step(axes, t, table):
    dt = 1e6 * table["dt_s"]
    bound = table.get("dt_bound")
    if isinstance(bound, list):
        for name in sorted(set(bound)):
            mine = [b == name for b in bound]
            axes.plot(t[mine], dt[mine], ".", markersize=2.2, markeredgewidth=0, rasterized=True,
                      color=BOUND_COLORS.get(name, style.INK), label=name or "none")
        axes.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncol=6, borderaxespad=0, markerscale=4,
                    handlelength=0.6, columnspacing=0.8, handletextpad=0.3, fontsize=7)
    else:
        axes.plot(t, dt, ".", markersize=2.2, markeredgewidth=0, color=style.INK)
    axes.set_ylabel("time step (µs)")
    axes.set_ylim(bottom=0)
