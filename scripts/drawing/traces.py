"""flow_and_pressure: pressures above, flow below, and the statistics of the last beat next to them."""
import itertools

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patheffects import withStroke

from . import style
from .instants import choose_frames, last_beat, main_flow
from .metrics import known, number
from .run_output import Missing, columns_like, leaflet_frames, read_table


def draw(out, pictures):
    table, beats = _read(out)
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(style.PAGE_WIDTH, 4.5),
                                          gridspec_kw={"height_ratios": [1, 1.25]})
    figure.subplots_adjust(left=0.09, right=0.74 if beats else 0.92, top=0.93, bottom=0.105, hspace=0.22)
    _fill(above, below, out, table, beats)
    if beats:
        _list_beat(figure, beats)
    style.save(figure, pictures, "flow_and_pressure", "svg")


def draw_column(out, pictures):
    """flow_and_pressure_column: the same without the statistics, at the width of one column."""
    table, beats = _read(out)
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(style.COLUMN_WIDTH, 4.2),
                                          gridspec_kw={"height_ratios": [1, 1.25]})
    figure.subplots_adjust(left=0.175, right=0.84, top=0.93, bottom=0.11, hspace=0.25)
    _fill(above, below, out, table, beats)
    style.save(figure, pictures, "flow_and_pressure_column")


def _read(out):
    """(openings.csv, cut to the last beats; beats.csv or None)."""
    try:
        beats = read_table(out / "beats.csv")
    except Missing:
        beats = None
    table = _last_beats(read_table(out / "openings.csv"), beats)
    if not columns_like(table, r"p_(.+)_mmHg") or not columns_like(table, r"Q_(.+)_ml_s"):
        raise Missing("openings.csv has no pressures or no flows")
    return table, beats


def _fill(above, below, out, table, beats):
    t = table["t_s"]
    _pressures(above, t, columns_like(table, r"p_(.+)_mmHg"))
    _flows(below, t, columns_like(table, r"Q_(.+)_ml_s"), main_flow(table)[0])
    _mark_instants(below, out, t, main_flow(table)[1])
    if beats:
        _shade_stroke(below, out, table)
    below.set_xlim(t[0], t[-1] if t[-1] > t[0] else t[0] + 1e-3)
    below.set_xlabel("time (s)")
    above.figure.align_ylabels([above, below])


def _last_beats(table, beats, most=4):
    """The rows of the last three beats, if there are more than `most`."""
    if not beats or len(beats["start_s"]) <= most:
        return table
    shown = table["t_s"] >= beats["start_s"][-3]
    return {name: values[shown] for name, values in table.items() if not isinstance(values, list)}


def _pressures(axes, t, pressures):
    others = itertools.cycle(style.OTHERS)
    for port, p in pressures.items():
        axes.plot(t, p, color=style.port_color(port, others), label=style.port_label(port))
    axes.set_ylabel("pressure (mmHg)")
    axes.set_ylim(bottom=min(0, axes.get_ylim()[0]))
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncol=4, borderaxespad=0, columnspacing=1.4)


def _flows(axes, t, flows, main):
    others = itertools.cycle(style.OTHERS)
    axes.axhline(0, color=style.GREY, linewidth=0.6)
    axes.plot(t, flows[main], color=style.FLOW, linewidth=1.6, label=style.port_label(main))
    for name, q in flows.items():
        if name != main:  # often the same curve: dashes leave both visible
            axes.plot(t, q, color=style.port_color(name, others), linewidth=0.9, dashes=(4, 3),
                      dash_capstyle="butt", label=style.port_label(name))
    axes.set_ylabel("flow (ml/s)")
    litres = axes.secondary_yaxis("right", functions=(lambda q: 0.06 * q, lambda q: q / 0.06))
    litres.set_ylabel("flow (l/min)")
    litres.spines["right"].set_visible(True)
    if len(flows) > 1:
        narrow = axes.figure.get_figwidth() < style.PAGE_WIDTH
        axes.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncol=3 if narrow else 5, borderaxespad=0,
                    columnspacing=1.2, fontsize=7 if narrow else 8)


def _shade_stroke(axes, out, table):
    """Shades the area under the last beat's flow, which is its stroke volume."""
    start, end = last_beat(out, table)
    inside = (table["t_s"] >= start) & (table["t_s"] <= end)
    axes.fill_between(table["t_s"][inside], 0, main_flow(table)[1][inside], color=style.FLOW, alpha=0.10, linewidth=0)


def _mark_instants(axes, out, t, q):
    """Draws dots with the letters of the leaflet pictures."""
    try:
        chosen = choose_frames(out, leaflet_frames(out))
    except Missing:
        return
    for letter, (_, time, _) in zip("abcdef", chosen):
        value, slope = np.interp(time, t, q), np.interp(time + 0.01, t, q) - np.interp(time - 0.01, t, q)
        steep = abs(slope) > 0.04 * np.ptp(q)
        place = (-6 if slope > 0 else 6, 1) if steep else (0, 5) if value > -0.05 * np.ptp(q) else (8, -4)
        axes.plot(time, value, "o", markersize=3.6, color="white", markeredgecolor=style.INK, markeredgewidth=0.9,
                  zorder=5, clip_on=False)
        note = axes.annotate(letter, (time, value), xytext=place, textcoords="offset points", ha="center",
                             fontweight="bold", zorder=6)
        note.set_path_effects([withStroke(linewidth=2, foreground="white")])
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.06 * (high - low))


def _list_beat(figure, beats):
    last = {name: values[-1] for name, values in beats.items()}
    top, step, left = 0.905, 0.0495, 0.825
    which = int(last.get("beat", len(next(iter(beats.values())))))
    figure.text(left, top, f"Beat {which}", fontweight="bold", va="top")
    for row, (metric, value) in enumerate(known(last)):
        y = top - (1.25 + 1.5 * row) * step
        figure.text(left, y, metric.label, va="top", fontsize=7.5, color=style.GREY)
        figure.text(left, y - 0.52 * step, f"{number(metric.form, value)} {metric.unit}", va="top", fontsize=8.5)
