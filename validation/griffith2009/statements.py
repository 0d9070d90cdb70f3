"""The paper's statements about each figure, with the numbers of a run."""
import json
import tomllib

import h5py
import numpy as np

from drawing.centre_line import axis_of, read_line
from drawing.fields import boxes_of
from drawing.instants import story
from drawing.metrics import last_beat_of_run
from drawing.run_output import Fibers, Missing, leaflet_frames, nearest, read_series, read_table, wall_points
from drawing.scene import fit_annulus, leaflet_points

BEGIN, END = "<!-- from the run: begin -->", "<!-- from the run: end -->"


def valve_flow(out):
    """(t, flow through the valve in ml/s), from the probe downstream of the valve."""
    probes = read_table(out / "probes.csv")
    return probes["t_s"], probes["Q_valve_ml_s"]


def equal_pressures(out):
    """(instant of the maximum load, instant at which the ventricular pressure first reaches the aortic one)."""
    table = read_table(out / "openings.csv")
    t, load = table["t_s"], table["p_ao_mmHg"] - table["p_lv_mmHg"]
    loaded = int(np.argmax(load[:np.argmax(table["Q_outlet_ml_s"])]))
    meets = np.nonzero(load[loaded:] <= 0)[0]
    if not len(meets):
        raise Missing("the pressures have not met yet")
    return t[loaded], t[loaded + meets[0]]


def line_frames(out):
    """[(what, time, path)]: the frames of fields nearest to the four instants of the paper."""
    loaded, equal = equal_pressures(out)
    instants = dict(story(out)[2:])
    wanted = [("closed, loaded", loaded), ("before opening", equal), ("open", instants.get("peak flow")),
              ("closed again", instants.get("closed under load"))]
    fields = read_series(out / "fields")
    return [(what, *nearest(fields, t)) for what, t in wanted if t is not None]


def rows(out):
    """[(figure, statement of the paper, result of the run)]"""
    return _flow_rows(out) + _pressure_rows(out) + _grid_rows(out)


def _flow_rows(out):
    beat = last_beat_of_run(out)
    if beat is None:
        raise Missing("no complete beat in beats.csv")
    t, q = valve_flow(out)
    frequency, decay = ringing(t, q, beat["closing_s"])
    return [
        ("7", "stroke volume about 90 ml", f"{beat['stroke_volume_ml']:.1f} ml net, "
         f"{beat['forward_volume_ml']:.1f} ml forward"),
        ("7", "peak flow near 30 l/min", f"{0.06 * beat['peak_flow_ml_s']:.1f} l/min"),
        ("7", "backflow near 10 l/min at closure", f"{-0.06 * beat['least_flow_ml_s']:.1f} l/min, "
         f"closing volume {beat['closing_volume_ml']:.1f} ml"),
        ("7", "oscillation at closure (the second heart sound)", f"{frequency:.0f} Hz, decaying as "
         f"exp(-{decay:.0f} t/s); the frequency is set by the compliance of wall and valve against the column of blood"),
        ("7", "smooth when zoomed", f"minimum flow at {1e3 * least(t, q):.0f} ms; in the ten milliseconds around it the "
         f"second difference between steps is {100 * roughness(t, q):.2g} % of the range of the flow (rms)"),
        ("7", "no backflow while closed", f"mean {beat['mean_leak_ml_s']:.2f} ml/s after closure; in the last tenth of "
         f"the run {np.mean(q[t > t[0] + 0.9 * np.ptp(t)]):.2f} ml/s"),
        ("4", "low resistance when open", f"maximum orifice area {beat['max_orifice_area_cm2']:.2f} cm², mean gradient "
         f"{beat['mean_gradient_mmHg']:.1f} mmHg from end to end of the model"),
    ]


def least(t, q):
    return t[int(np.argmin(q))]


def roughness(t, q):
    """Rms second difference between steps over the range of q, within 5 ms of the minimum flow."""
    near = q[np.abs(t - least(t, q)) < 0.005]
    return float(np.sqrt(np.mean(np.diff(near, 2) ** 2)) / max(np.ptp(near), 1e-9)) if len(near) > 3 else np.nan


def ringing(t, q, closing):
    """(frequency in Hz, decay rate in 1/s) of the flow over the 0.15 s after closing, from its extrema."""
    after = (t > closing) & (t < closing + 0.15)
    t, q = t[after], q[after]
    turns = np.nonzero(np.diff(np.sign(np.diff(q))))[0] + 1
    turns = [i for i in turns if abs(q[i]) == np.abs(q[(t > t[i] - 0.005) & (t < t[i] + 0.005)]).max()]
    if len(turns) < 3:
        return np.nan, np.nan
    period = 2 * np.mean(np.diff(t[turns]))
    swing = np.abs(np.diff(q[turns]))
    return 1 / period, -np.polyfit(t[turns][1:], np.log(swing), 1)[0]


def _pressure_rows(out):
    annulus = fit_annulus(Fibers(leaflet_frames(out)[0][1]))[0][2]
    axis, said = axis_of(out), []
    for what, t, path in line_frames(out):
        z, p = read_line(path, axis)
        before, after, end = (np.interp(annulus + dz, z, p) for dz in (-1, 2.5, z[-1] - annulus - 1))
        if what == "open":
            throat = (z > annulus) & (z < annulus + 6)
            dip = int(np.argmin(np.where(throat, p, np.inf)))
            said.append(("5", "open valve: almost no drop, a dip just downstream, recovery towards the outlet",
                         f"at {t:.2f} s {before:.0f} mmHg 1 cm below the annulus, minimum {p[dip]:.0f} mmHg "
                         f"{z[dip] - annulus:.1f} cm above it, {end:.0f} mmHg 1 cm before the outlet"))
        elif what == "before opening":
            said.append(("5", "equal pressures just before opening", f"at {t:.2f} s {before:.0f} and {after:.0f} mmHg "
                         "on the two sides"))
        else:
            first = what == "closed, loaded"
            said.append(("5", f"the closed valve bears {'85 mmHg' if first else 'the load again'}",
                         f"at {t:.2f} s {before:.0f} mmHg below, {after:.0f} mmHg above"))
    return said


def _grid_rows(out):
    """Counts nodes outside the finest level in the frames of the fields that have a frame of the structure."""
    shapes, wall = leaflet_frames(out), wall_points(out)
    outside = frames = levels = 0
    for t, path in read_series(out / "fields"):
        time, shape = nearest(shapes, t)
        if abs(time - t) > 1e-6:
            continue
        points = leaflet_points(Fibers(shape))
        points = points if wall is None else np.concatenate([points, wall])
        with h5py.File(path, "r") as file:
            boxes, origin = list(boxes_of(file)), file["VTKHDF"].attrs["Origin"]
        levels = boxes[-1].level + 1
        places = (points - origin) / boxes[-1].h  # in cells
        inside = np.zeros(len(points), bool)
        for box in boxes:
            if box.level + 1 == levels:
                inside |= np.all((places >= box.lo) & (places <= box.hi + 1), axis=1)
        outside, frames = outside + int(np.sum(~inside)), frames + 1
    return [("6", "three levels, the finest covers the structure",
             f"{levels} level{'s' if levels > 1 else ''}; {outside} nodes outside the finest in {frames} frames")]


def _settings(out):
    resolved = (out / "case.resolved.toml").read_text()
    case, facts = tomllib.loads(resolved), json.loads((out / "run.json").read_text())
    grid, fluid = case["grid"], case["fluid"]
    return (f"From a run of `{facts['case']}`, {facts['outcome']} {facts['written'][:10]}: finest spacing "
            f"{grid['finest_cm']:g} cm, {grid.get('levels', 1)} level(s), convection `{fluid['advection']}`, viscosity "
            f"`{fluid.get('viscosity_scheme', 'explicit')}`.")


def fill_page(template, target, out, drawn):
    """Writes `template` to `target`, with the part between the marks regenerated from the run."""
    head, _, rest = template.read_text().partition(BEGIN)
    tail = rest.partition(END)[2]
    lines = [_settings(out), "", "| figure | the paper | this run |", "|---|---|---|"]
    lines += [f"| {figure} | {stated} | {found} |" for figure, stated, found in rows(out)] + [""]
    for number, what in drawn.items():
        lines += [f"**Figure {number}.** {what}", "", f"![Figure {number}](figures/figure_{number}.png)", ""]
    target.write_text(f"{head}{BEGIN}\n\n" + "\n".join(lines) + f"\n{END}{tail}")
