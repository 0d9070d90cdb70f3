"""A gallery of runs: one card per run (pressures, flow, the open and the closed valve) and a row of statistics."""
import tomllib

import matplotlib.pyplot as plt
import numpy as np

from drawing import style
from drawing.instants import choose_frames
from drawing.metrics import number
from drawing.run_output import Fibers, Missing, leaflet_frames
from drawing.scene import Scene

from . import comparison

PIXELS = 420          # width of one valve
DOTS_PER_INCH = 180   # for screens
COLUMNS = [  # heading, format, value from the numbers of a beat
    ("stroke volume (ml)", "{:.0f}", lambda n: n["stroke_volume_ml"]),
    ("output (l/min)", "{:.1f}", lambda n: 0.06 * n["stroke_volume_ml"] / n["period_s"]),
    ("peak flow (ml/s)", "{:.0f}", lambda n: n["peak_flow_ml_s"]),
    ("mean gradient (mmHg)", "{:.0f}", lambda n: n["mean_gradient_mmHg"]),
    ("maximum orifice area (cm²)", "{:.2f}", lambda n: n["max_orifice_area_cm2"]),
    ("backflow (ml)", "{:.0f}", lambda n: n["closing_volume_ml"] + n["leak_volume_ml"]),
    ("aorta, systolic (mmHg)", "{:.0f}", lambda n: n["p_ao_systolic_mmHg"]),
    ("aorta, diastolic (mmHg)", "{:.0f}", lambda n: n["p_ao_diastolic_mmHg"]),
]


def title(out):
    """The title of the run's case."""
    try:
        return tomllib.loads((out / "case.resolved.toml").read_text())["title"]
    except (OSError, KeyError, tomllib.TOMLDecodeError):
        return out.name


def table(beats):
    """Markdown: one row per run."""
    lines = ["| case | beat | " + " | ".join(heading for heading, *_ in COLUMNS) + " |", "|---" * (2 + len(COLUMNS)) + "|"]
    for beat in beats:
        cells = [number(form, value(beat.numbers)) for _, form, value in COLUMNS]
        lines.append(f"| [{beat.name}](../cases/{beat.name}/README.md) | {beat.numbers['beat']:.0f} | "
                     + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def common_limits(beats):
    """{"t" | "p" | "q": (low, high)}: axis limits shared by all cards, so that they can be compared."""
    pressures = np.concatenate([b.traces[name] for b in beats for name in ("p_lv", "p_ao")])
    flows = np.concatenate([b.traces["flow"] for b in beats])
    return {"t": (0, max(b.t[-1] for b in beats)), "p": (min(0, pressures.min()), 1.05 * pressures.max()),
            "q": (1.05 * flows.min(), 1.05 * flows.max())}


def draw_card(out, beat, reference, limits, pictures):
    """pictures/<name of the beat>.png, with the traces of the reference in grey behind."""
    figure = plt.figure(figsize=(style.PAGE_WIDTH, 2.5))
    left, right = figure.add_gridspec(1, 2, width_ratios=[1.05, 1.5], left=0.09, right=0.995, top=0.93, bottom=0.15,
                                      wspace=0.06)
    above, below = left.subgridspec(2, 1, hspace=0.16).subplots(sharex=True)
    if beat is not reference:
        _traces(above, below, reference, dict.fromkeys(("p_lv", "p_ao", "flow"), "#c4c4c4"))
    _traces(above, below, beat, {"p_lv": style.VENTRICLE, "p_ao": style.AORTA, "flow": style.FLOW})
    above.set(ylim=limits["p"], xlim=limits["t"], ylabel="mmHg")
    below.set(ylim=limits["q"], xlabel="time in the beat (s)", ylabel="ml/s")
    below.axhline(0, color=style.GREY, linewidth=0.6)
    above.text(1.0, 1.02, "ventricle", color=style.VENTRICLE, transform=above.transAxes, ha="right", va="bottom")
    above.text(0.0, 1.02, "aorta", color=style.AORTA, transform=above.transAxes, va="bottom")
    figure.align_ylabels([above, below])
    for panel, (what, fibers, scene) in zip(right.subgridspec(1, 2, wspace=0.03).subplots(), _valves(out)):
        panel.set_axis_off()
        panel.imshow(np.asarray(scene.image(fibers, PIXELS)), extent=scene.extent)
        panel.set_title(what, pad=3)
    with plt.rc_context({"savefig.dpi": DOTS_PER_INCH}):
        style.save(figure, pictures, beat.name)


def _traces(above, below, beat, colors):
    for name in ("p_lv", "p_ao"):
        above.plot(beat.t, beat.traces[name], color=colors[name], linewidth=1.1)
    below.plot(beat.t, beat.traces["flow"], color=colors["flow"], linewidth=1.1)


def _valves(out):
    """[(what, fibres, Scene)]: the valve from above at peak flow and closed."""
    chosen = choose_frames(out, leaflet_frames(out))
    open_, closed = ([frame for frame in chosen if frame[0] == what] for what in ("peak flow", "closed under load"))
    if not open_ or not closed:
        raise Missing(f"{out} has no frames of an open and a closed valve")
    frames = [(f"{what}, {t:.2f} s", Fibers(path)) for what, t, path in (open_[0], closed[-1])]
    scene = Scene("above", [fibers for _, fibers in frames], None)
    return [(what, fibers, scene) for what, fibers in frames]


def write(runs, page, pictures):
    """Writes the cards of the runs' last beats into the folder `pictures`, and the page with the statistics. The first
    run is the reference."""
    beats = [comparison.beat_of_run(run, run.name) for run in runs]
    limits = common_limits(beats)
    pictures.mkdir(parents=True, exist_ok=True)
    cards = []
    for run, beat in zip(runs, beats):
        draw_card(run, beat, beats[0], limits, pictures)
        path = (pictures / f"{beat.name}.png").relative_to(page.parent)
        cards.append(f"## [{beat.name}](../cases/{beat.name}/README.md)\n\n{title(run)}.\n\n![{title(run)}]({path})\n")
    page.write_text(HEAD.format(reference=beats[0].name) + table(beats) + "\n" + "\n".join(cards))


HEAD = """# Gallery

Written by `scripts/draw_gallery.py` from the output folders of runs. Every 3D case extends
[healthy_adult](../cases/healthy_adult/README.md): the same heart, anatomy and coarse grid with one change (several for
exercise). The grid (10/64) is that of a smoke test. Gradients are too high and all values change on finer grids, so compare
the cases with each other, not with a patient. Two cases have no 3D root:
[lumped_heart](../cases/lumped_heart/README.md), [four_chamber_loop](../cases/four_chamber_loop/README.md).

The pictures show pressures and flow of the beat (grey: {reference}) and the valve seen from the aorta.

"""
