"""closure: the flow as the valve closes, and an enlargement of the ten milliseconds around its minimum.

A smooth curve in the second panel is resolved in time; a numerical oscillation shows as a sawtooth of single steps.
"""
import matplotlib.pyplot as plt
import numpy as np

from . import style
from .instants import last_beat, main_flow
from .run_output import Missing, read_table

NEAR, NEARER = 0.1, 0.01  # s


def windows(t, q):
    """((start, end), (start, end)): after the end of ejection, and around the minimum of the flow in it."""
    peak = int(np.argmax(q))
    below = np.nonzero(q[peak:] < 0)[0]
    if q[peak] <= 0 or not len(below):
        raise Missing("the flow has not reversed yet")
    start = t[peak + below[0]]
    near = (t >= start) & (t <= start + NEAR)
    if near.sum() < 4:
        raise Missing("the flow has only just reversed")
    least = t[near][int(np.argmin(q[near]))]
    return (start - 0.01, start + NEAR - 0.01), (least - 0.3 * NEARER, least + 0.7 * NEARER)


def draw(out, pictures):
    table = read_table(out / "openings.csv")
    name, q = main_flow(table)
    t = table["t_s"]
    beat = (t >= last_beat(out, table)[0]) & (t <= last_beat(out, table)[1])
    draw_zooms(t, q, windows(t[beat], q[beat]), style.port_label(name), pictures, "closure")


def draw_zooms(t, q, spans, label, pictures, name):
    """Plots the flow over every (start, end) of `spans`, each inside the previous one."""
    figure, axes = plt.subplots(len(spans), 1, figsize=(style.COLUMN_WIDTH, 1.9 * len(spans) + 0.2))
    for panel, (start, end) in zip(axes, spans):
        shown = (t >= start) & (t <= end)
        dots = {"marker": ".", "markersize": 3.5, "markeredgewidth": 0} if end - start < 2 * NEARER else {}
        panel.axhline(0, color=style.GREY, linewidth=0.6)
        panel.plot(1e3 * t[shown], q[shown], color=style.FLOW, linewidth=1.0, **dots)
        panel.set_xlim(1e3 * start, 1e3 * end)
        panel.set_ylabel(f"flow, {label} (ml/s)")
    axes[-1].set_xlabel("time (ms)")
    for panel, (start, end) in zip(axes, spans[1:]):
        panel.axvspan(1e3 * start, 1e3 * end, color=style.AORTA, alpha=0.15, linewidth=0)
    axes[-1].text(0.99, 0.9, "one dot per step", transform=axes[-1].transAxes, ha="right", color=style.GREY)
    figure.align_ylabels(axes)
    figure.tight_layout(pad=0.5)
    style.save(figure, pictures, name, "svg")
