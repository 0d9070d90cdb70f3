"""What is recorded: short runs of every bundled case and of the cases of this folder, so chosen that together they go
through every scheme, solver and kind of output.

A recipe is a list of commands that run in a folder of their own, from which ../tree is the source tree and ../inputs holds
what inputs.py writes. `same` names two output folders of a recipe that must hold the same numbers.
"""
import tomllib
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Command:
    words: list
    exit_code: int = 0
    ranks: int = 0  # 0: those of the recipe


@dataclass
class Recipe:
    name: str
    commands: list
    same: tuple = ()
    edits: tuple = ()  # (file, pattern, replacement), made after the first command


COARSE = {"grid.finest_cm": 0.15625}
# A line of progress after every step, a checkpoint at the end, no pictures.
QUIET = {"output.pictures": "false", "output.progress_every_s": 0, "checkpoint.every_wall_s": 0, "checkpoint.keep": 1}
# A ventricle that opens the valve at once.
SURGE = {"element.ventricle.time_s": "[0.0, 0.002, 0.15]", "element.ventricle.pressure_mmHg": "[0.0, 20.0, 120.0]",
         "element.arteries.pressurise_s": 0.0, "element.arteries.initial_pressure_mmHg": 0.0}
# The valve opens, ejects and closes within 0.1 s.
SHORT_BEAT = {"grid.finest_cm": 0.208333, "time.end_s": 0.1, "output.fields_every_s": 0.05, "output.structure_every_s": 0.02,
              "element.ventricle.time_s": "[0.0, 0.01, 0.05, 0.06, 0.12]",
              "element.ventricle.pressure_mmHg": "[0.0, 60.0, 60.0, 0.0, 0.0]",
              "element.arteries.pressurise_s": 0.005, "element.arteries.initial_pressure_mmHg": 40.0}
# Of the surge on one level; each takes another way through the program.
VARIANTS = {
    "xsppm7": {"fluid.advection": "xsppm7"},
    "stokes": {"fluid.advection": "none"},
    "convection_every_step": {"fluid.convection_cfl": 0, "fluid.advection": "xsppm7"},
    "crank_nicolson": {"fluid.viscosity_scheme": "crank_nicolson"},
    "midpoint": {"structure.scheme": "midpoint"},
    "fold_relaxation": {"structure.fold_relaxation_s": 0.0005},
    "midpoint_with_all": {"structure.scheme": "midpoint", "structure.fold_relaxation_s": 0.001,
                          "fluid.viscosity_scheme": "crank_nicolson", "fluid.advection": "xsppm7",
                          "coupling.scheme": "explicit"},
    "pfmg": {"pressure.solver": "pfmg"},
    "explicit_coupling": {"coupling.scheme": "explicit"},
    "fixed_step": {"time.dt_fixed_s": 1e-4},
    "sides_open": {"domain.sides": "open"},
    "sides_periodic": {"domain.sides": "periodic"},
    "factors": {"leaflets.stiffness_factors": "[0.8, 1.0, 1.3]", "leaflets.bending_factors": "[1.0, 3.0, 2.0]",
                "leaflets.height_factors": "[1.0, 0.9, 1.05]", "leaflets.free_edge_factors": "[0.95, 1.0, 1.0]",
                "leaflets.fused_shares": "[0.3, 0.0, 0.2]", "wall.layers": 2},
    "every_7_steps": {"output.traces_every_steps": 7},
}
LEVELS = {
    "vorticity": {"grid.vorticity_1_s": 1.0},
    "without_lumen": {"grid.lumen": "false", "grid.margin_cells": 1, "time.end_s": 0.018},
    "crank_nicolson": {"fluid.viscosity_scheme": "crank_nicolson", "structure.scheme": "midpoint",
                       "structure.fold_relaxation_s": 0.0005},
    "explicit_coupling": {"coupling.scheme": "explicit", "fluid.advection": "limited", "grid.levels": 2},
}
# Of the refined tube.
SIDES = {"sides_open": {"domain.sides": "open"}, "sides_periodic": {"domain.sides": "periodic"}}
# A sheet without tethers, carried over several cells.
ADRIFT = {"structure.files_prefix": "raft", "element.ventricle.pressure_mmHg": "[0.0, 20.0, 10.0, 0.0]"}


def run(case, out, changes=None, *more, **how):
    words = ["run", case, "-o", out, *more]
    for key, value in {**QUIET, **(changes or {})}.items():
        words += ["--set", f"{key}={value}"]
    return Command(words, **how)


def short(end_s):
    """A run to `end_s` on the coarse grid, fields and structure also in the middle."""
    return {**COARSE, "time.end_s": end_s, "output.fields_every_s": end_s / 2, "output.structure_every_s": end_s / 2}


def read_case(path):
    case = tomllib.loads(path.read_text())
    base = read_case(path.parent / case["extends"]) if "extends" in case else {}
    return {**base, **case}


def bundled(tree):
    """(name, path in the tree, has a 3D part) of every case of the tree."""
    for path in sorted(tree.glob("cases/*/*.toml")):
        if path.name != "expected.toml":
            name = path.parent.name + ("" if path.name == "case.toml" else f"_{path.stem}")
            yield name, f"../tree/{path.relative_to(tree)}", "opening" in read_case(path)


def of_bundled_cases(tree):
    for name, case, is_3d in bundled(tree):
        if is_3d:
            yield Recipe(name, [run(case, "out", short(0.008))])
            yield Recipe(f"lumped.{name}", [run(case, "out", None, "--lumped")])
            yield Recipe(f"check.{name}", [Command(["check", case, "--set", "grid.finest_cm=0.15625"])])
        else:
            yield Recipe(name, [run(case, "out")])
            yield Recipe(f"check.{name}", [Command(["check", case])])


ROOT, PAPER = "../tree/cases/aortic_root/case.toml", "../tree/cases/aortic_root/paper.toml"
HEALTHY, HEART = "../tree/cases/healthy_adult/case.toml", "../tree/cases/lumped_heart/case.toml"
TUBE, SHEET = "../inputs/tube.toml", "../inputs/sheet.toml"


def of_schemes():
    surge = {**short(0.012), **SURGE}
    yield Recipe("surge", [run(ROOT, "out", surge)])
    for name, changes in VARIANTS.items():
        yield Recipe(f"surge.{name}", [run(ROOT, "out", surge | changes)])
    for name, changes in LEVELS.items():
        yield Recipe(f"levels.{name}", [run(PAPER, "out", surge | changes)])
    yield Recipe("periodic_start", [run(HEALTHY, "out", short(0.012) | {"time.start": "periodic"})])
    yield Recipe("short_beat", [run(ROOT, "out", SHORT_BEAT)])
    yield Recipe("tube", [run(TUBE, "out")])
    yield Recipe("tube.every_7_steps", [run(TUBE, "out", {"output.traces_every_steps": 7})])
    yield Recipe("tube.tables_only", [run(TUBE, "out", {"output.fields_every_s": 0, "output.structure_every_s": 0})])
    yield Recipe("branches", [run("../inputs/branches.toml", "out")])
    yield Recipe("refined", [run("../inputs/refined.toml", "out")])
    for name, changes in SIDES.items():
        yield Recipe(f"refined.{name}", [run("../inputs/refined.toml", "out", changes)])
    for scheme in ["leapfrog", "midpoint"]:
        yield Recipe(f"fibre_files.{scheme}", [run(SHEET, "out", {"structure.scheme": scheme})])
    yield Recipe("fibre_files.adrift", [run(SHEET, "out", ADRIFT)])
    yield Recipe("fibre_files.followed", [run(SHEET, "out", ADRIFT | {"grid.finest_cm": 0.0625, "grid.levels": 2})])
    yield Recipe("diverges", [run(ROOT, "out", short(0.01) | SURGE | {
        "grid.finest_cm": 0.208333, "time.dt_fixed_s": 1e-4, "element.ventricle.time_s": "[0.0, 0.002, 0.01]",
        "element.ventricle.pressure_mmHg": "[0.0, 0.0, 20000.0]"}, exit_code=3)])


def continued(name, case, changes, middle_s, ranks=0):
    """A run that ends in the middle and is continued, and the same in one piece; on other `ranks` only nearly the same."""
    first = run(case, "continued", changes | {"time.end_s": middle_s})
    second = run(case, "continued", changes, "--restart", "latest", ranks=ranks)
    whole = [] if ranks else [run(case, "whole", changes)]
    return Recipe(f"restart.{name}", [*whole, first, second], same=() if ranks else ("whole", "continued"))


def of_restarts(ranks):
    surge = {**short(0.012), **SURGE, "time.period_s": 0.8}
    yield continued("surge", ROOT, surge, 0.006)
    yield continued("midpoint", ROOT, surge | VARIANTS["midpoint_with_all"] | {"coupling.scheme": "implicit"}, 0.006)
    yield continued("other_ranks", ROOT, surge, 0.006, ranks=3 - min(ranks, 2))
    yield continued("levels", PAPER, surge | LEVELS["vorticity"], 0.006)
    yield continued("ventricle", HEALTHY, short(0.012), 0.006)
    yield continued("tube", TUBE, {"time.end_s": 0.3, "time.period_s": 0.02}, 0.05)
    yield continued("fibre_files", SHEET, {"time.end_s": 0.02}, 0.01)


def of_networks(has_measured):
    for name in ["network", "resistive"]:
        yield Recipe(name, [run(f"../inputs/{name}.toml", "out")])
    yield Recipe("network.periodic_start", [run(HEART, "out", {"time.start": "periodic", "time.end_s": 1.6})])
    yield Recipe("network.loop_periodic_start", [run("../tree/cases/four_chamber_loop/case.toml", "out",
                                                     {"time.start": "periodic", "time.end_s": 1.6})])
    yield Recipe("network.until_periodic", [run(HEART, "out", {"time.stop_when_periodic_within": 0.002, "time.end_s": 40})])

    def fit(case, *more):
        return Command(["fit", case, "-o", "out", "--set", "output.pictures=false", *more])
    for name in ["signal", "targets", "elements", "loop"]:
        yield Recipe(f"fit.{name}", [fit(f"../inputs/fit_{name}.toml")])
    yield Recipe("fit.from_start", [fit("../inputs/fit_signal.toml", "--set", "fit.periodic=false")])
    if has_measured:
        for case in ["case", "four_elements"]:
            yield Recipe(f"fit.human_{case}", [fit(f"../tree/validation/human_windkessel/{case}.toml", "--data",
                                                   "../inputs/measured.csv")])
    # `calibrate` needs a beat of a 3D run; a 0D one whose flow has the name of the opening is as good.
    yield Recipe("calibrate", [
        run(ROOT, "root", {"surrogate.area_open_cm2": 2.5, "surrogate.closing_1_mmHg_s": 4.0}, "--lumped"),
        Command(["calibrate", "root", "-o", "calibrated"]),
        run("calibrated/surrogate.toml", "again", None, "--lumped")],
        edits=(("root/openings.csv", "Q_aortic_root_ml_s", "Q_outlet_ml_s"),
               ("root/case.resolved.toml", "area_open_cm2 = .*", "area_open_cm2 = 3.1")))
    yield Recipe("compare", [
        run("../tree/cases/hypertension/case.toml", "hypertension", None, "--lumped"),
        run("../tree/cases/stiff_aorta/case.toml", "stiff_aorta", None, "--lumped"),
        Command(["compare", "hypertension", "stiff_aorta", "--data", "../inputs/beat.csv", "-o", "compared"])])


def recipes(tree, ranks, has_measured):
    return [*of_bundled_cases(Path(tree)), *of_schemes(), *of_restarts(ranks), *of_networks(has_measured)]
