"""The sections of a run's report, from top to bottom."""
import json
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from drawing.instants import main_flow
from drawing.run_output import Missing, phase_times, read_table

from . import movie, page, verdict

BEAT = [  # picture, title, caption
    ("flow_and_pressure_column.png", "Pressures and flow", "Shaded: stroke volume of the last beat. Letters mark the "
     "instants of the leaflet pictures, if any."),
    ("pv_loop.svg", "Pressure-volume loop", "Left ventricle, last beat; earlier beats paler."),
    ("closure.svg", "Valve closure", "Flow after the end of ejection, and an enlarged ten milliseconds of it."),
    ("centre_line.svg", "Pressure on the centre line", "From the ventricle (left) through the valve to the aorta."),
    ("probes_column.png", "Probes", "Pressure at fixed heights, orifice area seen along the axis, maximum fibre "
     "strain."),
]
VALVE = [
    ("leaflets_above_column.png", "Leaflets from the aorta", "Every line is a fibre."),
    ("leaflets_side_column.png", "Leaflets from the side", "Dots: section of the wall; grey line: annulus."),
    ("markers_column.png", "Passive markers", "Within 0.3 cm of the plane through the axis, coloured by where they were "
     "released; black: section of the leaflets."),
]
PLANES = [
    ("midplane_pressure.png", "Pressure on the mid-plane", "With the boxes of every refined level of the grid."),
    ("midplane_speed.png", "Speed on the mid-plane", "Black: section of the leaflets."),
]
SOLVER = [
    ("step_column.png", "Time steps", "Step length, coloured by the active bound; CFL number; pressure iterations; "
     "maximum divergence; wall-clock time per step."),
    ("balances.svg", "Balances", "Mass-balance error of the 3D domain; flow through the probe discs minus that through "
     "the outlet, which is flow through or around the wall, or blood stored by moving leaflets."),
]


@dataclass
class Run:
    out: Path
    facts: dict   # run.json
    case: dict    # the resolved case
    resolved: str

    @property
    def title(self):
        return self.case.get("title") or self.facts.get("case") or self.out.name


def read_run(out):
    """The run in the folder `out`; Missing without traces."""
    if not (out / "openings.csv").is_file():
        raise Missing("no openings.csv: not the output folder of a run")
    facts = _read(out / "run.json", json.loads)
    resolved = _read(out / "case.resolved.toml", str)
    return Run(out, facts, tomllib.loads(resolved) if resolved else {}, resolved or "")


def _read(path, parse):
    return parse(path.read_text()) if path.is_file() else parse("{}") if parse is json.loads else ""


def body(run):
    pictures = run.out / "pictures"
    return "".join([
        _head(run),
        page.section("Verdict", _verdict(run)),
        page.section("The moving valve", _movie(run)),
        page.section("The beat", page.columns(_figures(pictures, BEAT))),
        page.section("Leaflets", page.grid(_figures(pictures, VALVE))),
        page.section("Pressure and velocity", page.grid(_figures(pictures, PLANES))),
        page.section("The solution", page.sentences(verdict.numerics_sentences(run.out, run.case)),
                     page.grid(_figures(pictures, SOLVER))),
        page.section("Computing time", _time_split(run.out)),
        page.section("The case", f"<details><summary>Every key, with defaults filled in</summary><pre>"
                     f"{page.text(run.resolved)}</pre></details>" if run.resolved else ""),
    ])


def _figures(pictures, wanted):
    return [page.figure(pictures / name, title, caption) for name, title, caption in wanted
            if (pictures / name).is_file()]


def _head(run):
    facts, end = run.facts, run.case.get("time", {}).get("end_s")
    state = f"<h1>{page.text(run.title)}</h1>"
    if facts.get("outcome") == "running":
        now = read_table(run.out / "openings.csv")["t_s"][-1]
        state += f'<p class="running">Still running: {now:.3f} s of {end:g} s. This page shows the results so far.</p>'
    said = [facts.get("case", run.out.name)]
    if facts.get("outcome") not in (None, "running"):
        said.append(f"{facts['outcome']} at t = {facts.get('t_s', 0):g} s")
    if facts.get("cells"):
        said.append(f"{facts['cells']:,} cells and {facts.get('nodes', 0):,} nodes".replace(",", "\u202f"))
    if facts.get("ranks"):
        said.append(f"{facts['ranks']} rank{'s' if facts['ranks'] > 1 else ''} on {facts.get('host', '?')}")
    if facts.get("wall_s") and facts.get("outcome") != "running":
        said.append(f"{facts['wall_s']:.3g} s of wall-clock time, {facts.get('peak_memory_mb', 0):.0f} MB")
    if facts.get("written"):
        said.append(facts["written"].replace("T", " ").replace("Z", " UTC"))
    return state + f'<p class="pale">{page.text(" · ".join(said))}</p>'


def _verdict(run):
    try:
        said, rows = verdict.valve_sentences(run.out), verdict.number_rows(run.out)
    except (Missing, KeyError) as reason:
        return page.sentences([f"No statistics yet: {reason}."])
    marks = {True: ("inside", "good"), False: ("outside", "off"), None: ""}
    cells = [(label, value, usual, marks[inside]) for label, value, usual, inside in rows]
    usual, others = [c for c in cells if c[2]], [c[:2] for c in cells if not c[2]]
    tables = [page.table(["last beat", "", "resting adult", ""], usual, "numbers"),
              page.table(["other quantities", ""], others, "numbers")]
    return page.sentences(said, "lead") + page.grid(tables)


def _movie(run):
    try:
        film = movie.film(run.out)
        table = read_table(run.out / "openings.csv")
        movie.save_gif(run.out, film, run.out / "pictures" / "valve.gif")
        return page.movie_player(film, table["t_s"], main_flow(table)[1])
    except (Missing, OSError):  # no frames, or one that is still being written
        return ""


def _time_split(out):
    """The table of timings at the end of log.txt as bars."""
    rows = phase_times(out)
    most = max((share for _, _, share in rows), default=0)
    return page.bars([(name, share / most, f"{s:.1f} s, {share:.0f} %") for name, s, share in rows]) if most > 0 else ""
