"""The statistics of one beat: their names, their ranges in a resting adult, and their computation from a trace.

A run writes them itself (beats.csv, docs/outputs.md); this module computes them for traces from elsewhere.
"""
from collections import namedtuple

import numpy as np

from .run_output import Missing, read_table

Metric = namedtuple("Metric", "column label form unit low high")  # low, high: range of a resting adult, None: no limit
METRICS = [
    Metric("stroke_volume_ml", "stroke volume", "{:.1f}", "ml", 70, 100),
    Metric("forward_volume_ml", "forward volume", "{:.1f}", "ml", None, None),
    Metric("closing_volume_ml", "closing volume", "{:.1f}", "ml", None, 5),
    Metric("leak_volume_ml", "leak volume", "{:.1f}", "ml", None, 4),
    Metric("peak_flow_ml_s", "peak flow", "{:.0f}", "ml/s", 400, 650),
    Metric("ejection_time_s", "ejection time", "{:.3f}", "s", 0.25, 0.32),
    Metric("mean_gradient_mmHg", "mean gradient", "{:.1f}", "mmHg", None, 6),
    Metric("max_orifice_area_cm2", "maximum orifice area", "{:.2f}", "cm²", 3, 4),
    Metric("p_ao_systolic_mmHg", "aorta, systolic", "{:.0f}", "mmHg", 90, 130),
    Metric("p_ao_diastolic_mmHg", "aorta, diastolic", "{:.0f}", "mmHg", 60, 85),
    Metric("p_ao_mean_mmHg", "aorta, mean", "{:.0f}", "mmHg", 70, 105),
]
FURTHER = [
    Metric("least_flow_ml_s", "minimum flow", "{:.0f}", "ml/s", None, None),
    Metric("mean_leak_ml_s", "mean leak after closure", "{:.2f}", "ml/s", None, None),
    Metric("opening_s", "opening", "{:.3f}", "s", None, None),
    Metric("closing_s", "closing", "{:.3f}", "s", None, None),
    Metric("period_s", "period", "{:.3f}", "s", None, None),
]
REMNANT = 0.05  # of the peak flow: residual ringing at the start of a beat stays below it
LONGEST_CLOSING = 0.25  # of the beat: the closing backflow ends within it
SHUT_CM2 = 0.05  # an orifice below this counts as shut


def known(beat, metrics=METRICS):
    """[(metric, value)] of those that the beat has as a number; an orifice of 0 means that there is none (0D)."""
    found = [(m, beat[m.column]) for m in metrics if m.column in beat and not isinstance(beat[m.column], str)]
    return [(m, v) for m, v in found if np.isfinite(v) and not (m.column == "max_orifice_area_cm2" and v <= 0)]


def number(form, value):
    """The value formatted by `form`, zero without a sign."""
    words = form.format(value)
    return form.format(0.0) if float(words) == 0 else words


def last_beat_of_run(out):
    """{column: value} of the last row of beats.csv; None while there is none."""
    try:
        return {name: values[-1] for name, values in read_table(out / "beats.csv").items()}
    except Missing:
        return None


def ejection(t, q):
    """(opening, end): where q rises through zero before its peak (through 5 % of the peak if positive from the start) and
    falls through zero after it."""
    peak = int(np.argmax(q))
    if q[peak] <= 0:
        raise Missing("no forward flow")
    before = np.nonzero(q[:peak] <= 0)[0]
    after = np.nonzero(q[peak:] <= 0)[0]
    if len(before):
        opening = _zero(t, q, before[-1])
    else:
        opening = t[np.nonzero(q[: peak + 1] > REMNANT * q[peak])[0][0]]
    end = _zero(t, q, peak + after[0] - 1) if len(after) else t[-1]
    return opening, end


def beat_of_trace(t, q, p_ao=None, p_lv=None):
    """{column: value} of one beat with flow q (ml/s) and pressures (mmHg), as docs/outputs.md defines them."""
    opening, end = ejection(t, q)
    closing = (t >= end) & (t <= end + LONGEST_CLOSING * (t[-1] - t[0]))
    least = t[closing][np.argmin(q[closing])] if np.any(closing) else end
    rise = (t > max(end, least)) & (q >= 0)
    shut = t[rise][0] if np.any(rise) else t[-1]
    beat = {
        "start_s": t[0], "period_s": t[-1] - t[0], "opening_s": opening, "closing_s": shut,
        "ejection_time_s": end - opening, "peak_flow_ml_s": q.max(),
        "least_flow_ml_s": q[t >= end].min() if np.any(t >= end) else np.nan,
        "forward_volume_ml": volume(t, q, opening if np.any(q[t < opening] <= 0) else t[0], end),
        "closing_volume_ml": -volume(t, q, end, shut),
        "leak_volume_ml": -volume(t, q, shut, t[-1]),
    }
    beat["stroke_volume_ml"] = beat["forward_volume_ml"] - beat["closing_volume_ml"] - beat["leak_volume_ml"]
    beat["mean_leak_ml_s"] = beat["leak_volume_ml"] / (t[-1] - shut) if t[-1] > shut else np.nan
    if p_ao is not None:
        later = p_ao[t >= opening]
        beat |= {"p_ao_systolic_mmHg": later.max(), "p_ao_diastolic_mmHg": later.min(),
                 "p_ao_mean_mmHg": volume(t, p_ao, t[0], t[-1]) / (t[-1] - t[0])}
        if p_lv is not None:
            beat["mean_gradient_mmHg"] = volume(t, p_lv - p_ao, opening, end) / (end - opening)
    return beat


def volume(t, q, start, end):
    """Trapezoidal integral of q from start to end, which need not coincide with samples."""
    inside = t[(t > start) & (t < end)]
    nodes = np.concatenate([[start], inside, [end]])
    values = np.interp(nodes, t, q)
    return float(np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(nodes)))


def _zero(t, q, i):
    """The instant between samples i and i + 1 at which q is zero."""
    return t[i] + (t[i + 1] - t[i]) * q[i] / (q[i] - q[i + 1]) if q[i] != q[i + 1] else t[i]
