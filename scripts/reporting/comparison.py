"""Runs and measured beats compared: one beat of each, aligned at the opening of the valve."""
import csv
import io
from dataclasses import dataclass, field

import matplotlib.pyplot as plt
import numpy as np

from drawing import style
from drawing.instants import last_beat, main_flow
from drawing.metrics import FURTHER, METRICS, beat_of_trace, ejection, known, last_beat_of_run, number
from drawing.run_output import Missing, columns_like, read_table

COLORS = ["#222222", "#c8443c", "#2f6db3", "#3a8f5c", "#c98a1b", "#8e5aa8", "#4fb0c6"]
TRACES = [  # name, label, unit
    ("p_ao", "aortic pressure", "mmHg"),
    ("p_lv", "ventricular pressure", "mmHg"),
    ("flow", "flow", "ml/s"),
    ("area", "orifice area", "cm²"),
]
# where a difference in per cent is meaningful
RELATIVE = {m.label for m in METRICS} - {"closing volume", "leak volume", "mean gradient"}


@dataclass
class Beat:
    """A beat: its statistics and its traces over the time since its start; `shift` aligns its opening with the first's."""
    name: str
    numbers: dict
    t: np.ndarray
    traces: dict = field(default_factory=dict)
    shift: float = 0.0


def beat_of_run(out, name):
    """The last beat of a run, 3D or 0D."""
    table = read_table(out / "openings.csv")
    start, end = last_beat(out, table)
    inside = (table["t_s"] >= start) & (table["t_s"] <= end)
    beat = _beat(name, {c: v[inside] for c, v in table.items() if not isinstance(v, list)})
    beat.numbers |= last_beat_of_run(out) or {}
    for instant in ("opening_s", "closing_s"):
        beat.numbers[instant] -= beat.numbers["start_s"]
    try:
        probes = read_table(out / "probes.csv")
        if probes["area_cm2"].max() > 0:
            beat.traces["area"] = np.interp(beat.t + start, probes["t_s"], probes["area_cm2"])
    except (Missing, KeyError):
        pass
    return beat


def beat_of_data(path):
    """A measured beat: columns t_s, Q_..._ml_s and, if measured, p_ao_mmHg and p_lv_mmHg."""
    table = read_table(path)
    if "t_s" not in table:
        raise Missing(f"{path.name} has no column t_s")
    t, q = table["t_s"], main_flow(table)[1]
    ends = np.nonzero(q <= 0)[0]
    if q[0] > 0 and len(ends):  # the record starts during ejection: move its end to the front
        turn = ends[-1]
        period = t[-1] - t[0] + (t[-1] - t[-2])
        table = {c: np.roll(v, -turn) for c, v in table.items() if not isinstance(v, list)}
        table["t_s"] = np.concatenate([t[turn:], t[:turn] + period])
    return _beat(path.stem, table)


def _beat(name, table):
    t = table["t_s"] - table["t_s"][0]
    pressures = columns_like(table, r"p_(.+)_mmHg")
    traces = {"flow": main_flow(table)[1]} | {f"p_{p}": pressures[p] for p in ("ao", "lv") if p in pressures}
    return Beat(name, beat_of_trace(t, traces["flow"], traces.get("p_ao"), traces.get("p_lv")), t, traces)


def align(beats):
    """Sets every `shift` so that all valves open with the first."""
    first = ejection(beats[0].t, beats[0].traces["flow"])[0]
    for beat in beats:
        beat.shift = first - ejection(beat.t, beat.traces["flow"])[0]


def rms_difference(beat, reference, trace):
    """Rms difference over the time that both beats cover once aligned; nan if one lacks the trace."""
    if trace not in beat.traces or trace not in reference.traces:
        return np.nan
    start, end = max(beat.shift, 0.0), min(beat.t[-1] + beat.shift, reference.t[-1])
    t = np.linspace(start, end, 2001)
    both = [np.interp(t, b.t + b.shift, b.traces[trace]) for b in (beat, reference)]
    return float(np.sqrt(np.mean((both[0] - both[1]) ** 2)))


def rows(beats):
    """[(label, unit, format, values)] of every quantity that at least one beat has; nan where a beat lacks it."""
    table = []
    for metric in METRICS + FURTHER:
        values = [dict((m.column, v) for m, v in known(b.numbers, [metric])).get(metric.column, np.nan) for b in beats]
        if np.any(np.isfinite(values)):
            table.append((metric.label, metric.unit, metric.form, values))
    table.append(("shift in time", "s", "{:.3f}", [b.shift for b in beats]))
    for trace, label, unit in TRACES:
        values = [np.nan] + [rms_difference(b, beats[0], trace) for b in beats[1:]]
        if np.any(np.isfinite(values)):
            table.append((f"rms difference, {label}", unit, "{:.2f}", values))
    return table


def cells(row):
    """The values of a row as text, with the difference from the first in per cent where that is meaningful."""
    label, _, form, values = row
    said = []
    for i, value in enumerate(values):
        words = number(form, value) if np.isfinite(value) else "–"
        compares = i and label in RELATIVE and np.isfinite(value) and abs(values[0]) > 0
        said.append(words + (f" ({100 * (value / values[0] - 1):+.0f} %)" if compares else ""))
    return said


def as_text(beats, table, markdown=False):
    """The table with aligned columns, as Markdown or plain text."""
    lines = [["", *(b.name for b in beats)]] + [[f"{row[0]}, {row[1]}", *cells(row)] for row in table]
    widths = [max(map(len, column)) for column in zip(*lines)]
    lines = [[line[0].ljust(widths[0])] + [w.rjust(n) for w, n in zip(line[1:], widths[1:])] for line in lines]
    if not markdown:
        return "\n".join("  ".join(line).rstrip() for line in lines) + "\n"
    rule = ["-" * widths[0]] + ["-" * (n - 1) + ":" for n in widths[1:]]
    return "\n".join(f"| {' | '.join(line)} |" for line in [lines[0], rule, *lines[1:]]) + "\n"


def as_csv(beats, table):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["quantity", "unit", *(b.name for b in beats)])
    for label, unit, _, values in table:
        writer.writerow([label, unit, *(f"{v:.9g}" if np.isfinite(v) else "" for v in values)])
    return text.getvalue()


def draw(beats, folder, name, width):
    """Plots the aligned traces in common axes."""
    shown = [t for t in TRACES if any(t[0] in b.traces for b in beats)]
    figure, axes = plt.subplots(len(shown), 1, sharex=True, squeeze=False, figsize=(width, 1.7 * len(shown) + 0.6))
    for panel, (trace, label, unit) in zip(axes[:, 0], shown):
        for i, beat in enumerate(beats):
            if trace in beat.traces:
                panel.plot(beat.t + beat.shift, beat.traces[trace], color=COLORS[i % len(COLORS)], label=beat.name,
                           linestyle="-" if i < len(COLORS) else "--", zorder=10 - i)
        if trace == "flow":
            panel.axhline(0, color=style.GREY, linewidth=0.6)
        panel.set_ylabel(f"{label.replace(' pressure', '')}{chr(10) if 'pressure' in label else ' '}({unit})")
    lines = {line.get_label(): line for panel in axes[:, 0] for line in panel.lines if line.get_label()[0] != "_"}
    names = [b.name for b in beats if b.name in lines]
    axes[0, 0].legend([lines[n] for n in names], names, loc="lower left", bbox_to_anchor=(0, 1.0), borderaxespad=0,
                      ncol=4 if width > style.COLUMN_WIDTH else 2)
    axes[-1, 0].set_xlabel(f"time from the start of the beat of {beats[0].name} (s)")
    figure.align_ylabels(axes[:, 0])
    figure.tight_layout(pad=0.6)
    style.save(figure, folder, name, "svg")
