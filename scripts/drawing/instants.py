"""The characteristic instants of a beat, found in flow and pressures, and the frames nearest to them."""
import numpy as np

from .run_output import Missing, columns_like, nearest, read_table

FLOW_NAMES = ("out", "outlet", "aortic_root", "valve", "aortic", "aortic_valve", "in", "inlet")


def main_flow(table):
    """(name, array) of the flow that represents ejection."""
    flows = columns_like(table, r"Q_(.+)_ml_s")
    if not flows:
        raise Missing("openings.csv has no column Q_..._ml_s")
    for name in FLOW_NAMES:
        if name in flows:
            return name, flows[name]
    return next(iter(flows.items()))


def last_beat(out, table):
    """(start, end) of the last complete beat, or of the whole trace if there is none."""
    t = table["t_s"]
    try:
        beats = read_table(out / "beats.csv")
        start = beats["start_s"][-1]
        return start, min(t[-1], start + beats["period_s"][-1])
    except (Missing, KeyError):
        return t[0], t[-1]


def story(out):
    """[(what, time)] of the last beat: those of six instants that the run has reached."""
    table = read_table(out / "openings.csv")
    start, end = last_beat(out, table)
    inside = (table["t_s"] >= start) & (table["t_s"] <= end)
    t, q = table["t_s"][inside], main_flow(table)[1][inside]
    pressure = columns_like(table, r"p_(.+)_mmHg")
    load = pressure["ao"][inside] - pressure["lv"][inside] if {"ao", "lv"} <= pressure.keys() else -np.abs(q)

    peak = int(np.argmax(q))
    if len(t) < 3 or q[peak] <= 0:
        return [("start", start), ("latest", end)]
    low = np.nonzero(q[:peak] < 0.15 * q[peak])[0]
    opening = int(low[-1]) if len(low) else 0
    found = [("closed under load", t[int(np.argmax(load[:opening + 1]))]), ("opening", t[opening]),
             ("peak flow" if peak + 1 < len(t) else "latest", t[peak])]
    falling = np.nonzero(q[peak:] < 0.35 * q[peak])[0]
    if not len(falling):
        return found + [("latest", end)]
    found.append(("late ejection", t[peak + int(falling[0])]))
    reversed_ = np.nonzero(q[peak:] < 0)[0]
    if not len(reversed_):
        return found + [("latest", end)]
    zero = peak + int(reversed_[0])
    soon = t <= t[zero] + 0.1
    closing = zero + int(np.argmin(q[zero:][soon[zero:]]))
    found.append(("closing", t[closing]))
    later = t > t[closing] + 0.03
    if np.any(later):
        settled = min(end, t[closing] + 0.15)
        found.append(("closed under load", settled))
    return found


def choose_frames(out, frames, wanted=None):
    """[(what, time, path)]: the frames nearest to the instants of `story` (those in `wanted`, or all), without repeats.

    Without a flow the frames are spaced evenly over the run.
    """
    try:
        instants = story(out)
    except Missing:
        picks = np.unique(np.linspace(0, len(frames) - 1, 4 if wanted else 6).round().astype(int))
        return [("", *frames[i]) for i in picks]
    if wanted:
        instants = [instants[i] for i in wanted if i < len(instants)]
    chosen, used = [], set()
    for what, t in instants:
        frame = nearest(frames, t)
        if frame not in used:
            used.add(frame)
            chosen.append((what, *frame))
    return chosen
