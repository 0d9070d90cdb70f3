#!/usr/bin/python3
"""How a run ends: exit code, messages and complete files.

    run_ends.py VALSALVA ROOT finished|interrupted|blown_up
"""
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

program, root, ending = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
found = []


def expect(holds, message):
    if not holds:
        found.append(message)


def table(path):
    """Header and rows of a CSV file; every row must be complete, every value a number, and time increasing."""
    text = path.read_text()
    expect(text.endswith("\n"), f"{path.name}: the last line is incomplete")
    header, *rows = (line.split(",") for line in text.splitlines())
    expect(all(len(row) == len(header) for row in rows), f"{path.name}: a row has another number of values than the header")
    if "dt_bound" in header:  # the only column of words
        bound = header.index("dt_bound")
        words = {"longest", "cfl", "elastic", "viscous", "growth", "output", "fixed"}
        expect(all(row[bound] in words for row in rows), f"{path.name}: unknown dt_bound in {set(r[bound] for r in rows)}")
        rows = [row[:bound] + ["0"] + row[bound + 1:] for row in rows]
    rows = [[float(value) for value in row] for row in rows]
    if "t_s" in header:
        t = [row[header.index("t_s")] for row in rows]
        expect(t[:1] == [0.0], f"{path.name}: no row of t = 0")
        expect(all(a < b for a, b in zip(t, t[1:])), f"{path.name}: times do not increase")
    return header, rows


def start(case, out, *overrides):
    command = [program, "run", str(root / "cases" / case / "case.toml"), "-o", str(out), "--set", "output.pictures=false"]
    for override in overrides:
        command += ["--set", override]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def end(process, code):
    said = process.communicate(timeout=100)
    expect(process.returncode == code, f"exit code {process.returncode}, expected {code}\n{said[0]}{said[1]}")
    return said


def finished(out):
    """One beat of the lumped heart."""
    end(start("lumped_heart", out, "time.end_s=0.8"), 0)
    header, rows = table(out / "openings.csv")
    for column in ["t_s", "p_la_mmHg", "p_lv_mmHg", "p_ao_mmHg", "Q_mitral_ml_s", "Q_aortic_ml_s", "Q_arteries_ml_s",
                   "ventricle.V_ml", "arteries.Pc_mmHg"]:
        expect(any(name.startswith(column) for name in header), f"openings.csv has no column {column}: {header}")
    expect(abs(rows[-1][0] - 0.8) < 1e-9, f"the last row is at {rows[-1][0]} s")
    header, beats = table(out / "beats.csv")
    beat = dict(zip(header, beats[0]))
    expect(len(beats) == 1 and abs(beat["period_s"] - 0.8) < 1e-9, f"beats.csv: {beats}")
    expect(40 < beat["stroke_volume_ml"] < 120, f"stroke volume {beat['stroke_volume_ml']} ml")
    expect(json.loads((out / "run.json").read_text())["outcome"] == "finished", "run.json does not say finished")


def three_d_tables(out):
    lengths = {}
    for name in ["step.csv", "openings.csv", "probes.csv"]:
        header, rows = table(out / name)
        lengths[name] = len(rows)
    expect(len(set(lengths.values())) == 1, f"files of different length: {lengths}")
    return table(out / "step.csv")


def interrupted(out):
    """Ctrl-C in the middle of a 3D run."""
    process = start("aortic_root", out, "grid.finest_cm=0.208333", "output.fields_every_s=0.002")
    for _ in range(600):  # the run has started once there is a field after t = 0
        if len(list((out / "fields").glob("*.hdf"))) > 1 or process.poll() is not None:
            break
        time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    said = end(process, 0)
    expect("stopped" in said[0] + said[1], "the signal is not reported")
    header, rows = three_d_tables(out)
    expect(len(rows) > 2 and rows[-1][header.index("t_s")] < 0.8, f"{len(rows)} rows of step.csv")
    record = json.loads((out / "run.json").read_text())
    expect(record["outcome"] == "stopped by a signal", f"run.json says {record['outcome']}")
    expect(record["steps"] == rows[-1][0], f"run.json: {record['steps']} steps, step.csv: {rows[-1][0]}")
    series = json.loads(next((out / "fields").glob("*.series")).read_text())
    expect(all((out / "fields" / entry["name"]).exists() for entry in series["files"]), "a field of the series is missing")


def blown_up(out):
    """Fixed steps beyond the elastic bound are refused at once; a very strong ventricle makes the flow blow up later."""
    surge = ["element.ventricle.time_s=[0.0, 0.002, 0.01]", "element.ventricle.pressure_mmHg=[0.0, 0.0, 20000.0]"]
    for dt, more, cause, least_steps in [("0.01", [], "stable step", 0), ("0.0008", [], "stable step", 0),
                                         ("0.0001", surge, "blown up", 20)]:
        folder = out.with_name(f"dt_{dt}")
        said = end(start("aortic_root", folder, "grid.finest_cm=0.208333", f"time.dt_fixed_s={dt}", *more), 3)[1]
        header, rows = three_d_tables(folder)
        last, t = int(rows[-1][0]), rows[-1][header.index("t_s")]
        expect(last >= least_steps, f"only {last} steps before the end")
        expect(f"step {last + 1}," in said, f"step.csv ends with step {last}, so step {last + 1} failed; said: {said}")
        expect("t = " in said, f"no time in: {said}")
        expect(cause in said and "dt_fixed_s" in said, f"no cause or no repair in: {said}")
        told = float(said.split("t = ")[1].split(" ")[0]) if "t = " in said else -1
        expect(t - 1e-9 <= told <= t + float(dt) + 1e-9, f"step.csv ends at {t} s, the message says {told} s")
        outcome = json.loads((folder / "run.json").read_text())["outcome"]
        expect(outcome == "failed", f"run.json says {outcome}, not failed")


with tempfile.TemporaryDirectory() as scratch:
    {"finished": finished, "interrupted": interrupted, "blown_up": blown_up}[ending](pathlib.Path(scratch, "out"))
print("\n".join(found))
sys.exit(1 if found else 0)
