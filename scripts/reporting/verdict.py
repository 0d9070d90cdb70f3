"""What a run says about the valve and about itself, in sentences and numbers."""
import numpy as np

from drawing.instants import main_flow
from drawing.metrics import SHUT_CM2, METRICS, FURTHER, beat_of_trace, known, last_beat_of_run, number
from drawing.run_output import Missing, columns_like, read_table

LEAST_ML = 1.0    # forward flow of less is no ejection
COARSE_CM = 0.11  # the valve's numbers still change by a tenth and more on finer grids than this


def beat_of_run(out):
    """The last beat of the run: of beats.csv, or of what there is while the first beat goes on."""
    beat = last_beat_of_run(out)
    if beat:
        return beat
    table = read_table(out / "openings.csv")
    pressures = columns_like(table, r"p_(.+)_mmHg")
    return beat_of_trace(table["t_s"], main_flow(table)[1], pressures.get("ao"), pressures.get("lv"))


def number_rows(out):
    """[(label, value with unit, usual range, whether inside or None)] of the last beat."""
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
    """What the valve did in the last beat."""
    beat = beat_of_run(out)
    if beat["forward_volume_ml"] < LEAST_ML:
        raise Missing("the valve has not let any blood pass yet")
    has_orifice = beat.get("max_orifice_area_cm2", 0) > 0
    opened = f" to {beat['max_orifice_area_cm2']:.1f} cm²" if has_orifice else ""
    said = [f"The valve opened at {beat['opening_s']:.3f} s{opened} and let {beat['forward_volume_ml']:.1f} ml pass in "
            f"{beat['ejection_time_s']:.3f} s, at most {beat['peak_flow_ml_s']:.0f} ml/s."]
    if beat["closing_volume_ml"] != 0 or has_orifice:
        said.append(f"While it closed {beat['closing_volume_ml']:.1f} ml flowed back; {_leak(beat)}, which leaves a "
                    f"stroke volume of {beat['stroke_volume_ml']:.1f} ml.")
    gap = _gap_at_end(out)
    if has_orifice and gap is not None:
        said.append("At the end its free edges meet." if gap < SHUT_CM2 else
                    f"At the end {gap:.2f} cm² are left between the free edges, seen from above (below them the "
                    "leaflets may touch).")
    outside = [m.label for m, v in known(beat) if (m.low is not None and v < m.low) or
               (m.high is not None and v > m.high)]
    said.append(f"Outside of what a resting adult has: {', '.join(outside)}." if outside else
                "All numbers lie in the range of a resting adult.")
    return said


def _leak(beat):
    rate = beat.get("mean_leak_ml_s", np.nan)
    if not np.isfinite(rate):
        return "the beat ended before it was closed"
    return f"closed, it leaked {rate:.1f} ml/s on average" if rate > 1 else "closed, it held"


def _gap_at_end(out):
    try:
        area = read_table(out / "probes.csv")["area_cm2"]
    except (Missing, KeyError):
        return None
    return float(area[-1]) if area[-1] >= 0 else None


def numerics_sentences(out, case):
    """How well the equations were solved, and what limits the trust in the answer."""
    said = []
    try:
        step = read_table(out / "step.csv")
        said.append(f"{len(step['t_s']) - 1} steps, {1e6 * np.median(step['dt_s'][1:]):.0f} µs in the middle, largest "
                    f"CFL number {step['cfl'].max():.2f}; {np.mean(step['iterations'][1:]):.1f} iterations of the "
                    f"pressure solve per step, largest rms divergence left {step['rms_divergence_1_s'].max():.1g} 1/s.")
    except (Missing, KeyError, IndexError):
        pass
    beat = last_beat_of_run(out)
    if beat and case.get("opening"):
        said.append(f"Over the last beat {1e3 * beat['mass_balance_ml']:.2g} µl entered the 3D domain and did not "
                    "leave it.")
    h = case.get("grid", {}).get("finest_cm")
    if case.get("opening") and h and h > COARSE_CM:
        said.append(f"The spacing of {h:.3f} cm is coarse: treat the valve's numbers as those of a smoke test.")
    return said
