"""The verdict on a run: what the valve did, and how far the result can be trusted, in sentences and numbers."""
import numpy as np

from drawing.instants import main_flow
from drawing.metrics import SHUT_CM2, METRICS, FURTHER, beat_of_trace, known, last_beat_of_run, number
from drawing.run_output import Missing, columns_like, read_table

LEAST_ML = 1.0    # a smaller forward volume is not an ejection
COARSE_CM = 0.11  # above this spacing, results on the valve change by a tenth or more on finer grids


def beat_of_run(out):
    """The last beat of the run: from beats.csv, or from the traces so far during the first beat."""
    beat = last_beat_of_run(out)
    if beat:
        return beat
    table = read_table(out / "openings.csv")
    pressures = columns_like(table, r"p_(.+)_mmHg")
    return beat_of_trace(table["t_s"], main_flow(table)[1], pressures.get("ao"), pressures.get("lv"))


def number_rows(out):
    """[(label, value with unit, range of a resting adult, whether inside or None)] of the last beat."""
    rows = []
    for metric, value in known(beat_of_run(out), METRICS + FURTHER):
        usual, inside = "", None
        if metric.low is not None and metric.high is not None:
            usual, inside = f"{metric.low:g}–{metric.high:g}", metric.low <= value <= metric.high
        elif metric.high is not None:
            usual, inside = f"up to {metric.high:g}", value <= metric.high
        rows.append((metric.label, f"{number(metric.form, value)} {metric.unit}", usual, inside))
    return rows


def valve_sentences(out):
    """What the valve did in the last beat, in sentences."""
    beat = beat_of_run(out)
    if beat["forward_volume_ml"] < LEAST_ML:
        raise Missing("no blood has passed the valve yet")
    has_orifice = beat.get("max_orifice_area_cm2", 0) > 0
    opened = f" to {beat['max_orifice_area_cm2']:.1f} cm²" if has_orifice else ""
    said = [f"The valve opened at {beat['opening_s']:.3f} s{opened} and passed {beat['forward_volume_ml']:.1f} ml in "
            f"{beat['ejection_time_s']:.3f} s, with a peak flow of {beat['peak_flow_ml_s']:.0f} ml/s."]
    if beat["closing_volume_ml"] != 0 or has_orifice:
        said.append(f"{beat['closing_volume_ml']:.1f} ml regurgitated during closure{_leak(beat)}; net stroke volume "
                    f"{beat['stroke_volume_ml']:.1f} ml.")
    gap = _gap_at_end(out)
    if has_orifice and gap is not None:
        said.append("At the end its free edges meet." if gap < SHUT_CM2 else
                    f"At the end a gap of {gap:.2f} cm² remains between the free edges, seen from above (the leaflets "
                    "may touch below them).")
    outside = [m.label for m, v in known(beat) if (m.low is not None and v < m.low) or
               (m.high is not None and v > m.high)]
    said.append(f"Outside the range of a resting adult: {', '.join(outside)}." if outside else
                "All values are within the range of a resting adult.")
    return said


def _leak(beat):
    rate = beat.get("mean_leak_ml_s", np.nan)
    if not np.isfinite(rate):
        return " (the beat ended before it was complete)"
    return f" and {rate:.1f} ml/s on average once closed" if rate > 1 else " and none once closed"


def _gap_at_end(out):
    try:
        area = read_table(out / "probes.csv")["area_cm2"]
    except (Missing, KeyError):
        return None
    return float(area[-1]) if area[-1] >= 0 else None


def numerics_sentences(out, case):
    """How accurately the equations were solved, and what limits the trust in the result."""
    said = []
    try:
        step = read_table(out / "step.csv")
        said.append(f"{len(step['t_s']) - 1} steps with a median of {1e6 * np.median(step['dt_s'][1:]):.0f} µs and a "
                    f"maximum CFL number of {step['cfl'].max():.2f}; {np.mean(step['iterations'][1:]):.1f} pressure "
                    f"iterations per step on average; maximum rms divergence {step['rms_divergence_1_s'].max():.1g} 1/s.")
    except (Missing, KeyError, IndexError):
        pass
    beat = last_beat_of_run(out)
    if beat and case.get("opening"):
        said.append(f"Mass-balance error over the last beat: {1e3 * beat['mass_balance_ml']:.2g} µl.")
    h = case.get("grid", {}).get("finest_cm")
    if case.get("opening") and h and h > COARSE_CM:
        said.append(f"The grid spacing of {h:.3f} cm is coarse: treat these results as a smoke test.")
    return said
