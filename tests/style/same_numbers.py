#!/usr/bin/python3
"""The comparison of recordings (scripts/same_numbers) finds what it must, and only that.

    same_numbers.py ROOT
    same_numbers.py ROOT VALSALVA     two recordings of a short run on one and two ranks are the same
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

sys.dont_write_bytecode = True
root = Path(sys.argv[1])
tool = root / "scripts" / "same_numbers"
found = []

CSV = {"t_s": [0.0, 0.1, 0.2], "p_ao_mmHg": [80.0, 1 / 3, float("nan")], "wall_s": [0.1, 0.2, 0.3],
       "dt_bound": ["elastic", "cfl", "elastic"]}
JSON = {"outcome": "finished", "steps": 12, "t_s": 0.1 + 0.2, "sd": None, "host": "a", "wall_s": 1.5, "peak_memory_mb": 70.1,
        "written": "2026-01-01T00:00:00Z"}
PRINTED = """grid       98304 cells of 0.15625 cm
step      7  t 0.0011 s (beat 1)  dt 1.5e-04 (output)  Q -23 ml/s  32 ms/step  ETA 1 min 3 s
memory     about 84 MB: fields with ghosts 43; the trial steps took 97 MB
time       31 ms per step on 2 ranks: 1234 steps to t = 0.8 s, 38 s without output
phase                            s       %     calls     ms/call
projection                    0.29    21.5       104       2.748
wall                          1.33   100.0
aortic pressure 120/80 (mean 95) mmHg
checkpoint /somewhere/1/checkpoint_00000007.h5
"""


def bit_after(x):
    return np.nextafter(x, np.inf, dtype=np.asarray(x).dtype)


def write(folder, table=None, record=None, fields=None, printed=PRINTED, more=()):
    """A recording of one recipe; the arguments replace what is given above."""
    out = folder / "surge.ranks_1" / "out"
    out.mkdir(parents=True)
    (folder / "record.json").write_text("{}")
    columns = {name: values for name, values in {**CSV, **(table or {})}.items() if values is not None}
    rows = zip(*[[v if isinstance(v, str) else repr(float(v)) for v in values] for values in columns.values()])
    (out / "step.csv").write_text("\n".join([",".join(columns), *map(",".join, rows)]) + "\n")
    (out / "run.json").write_text(json.dumps({**JSON, **(record or {})}))
    (out.parent / "01_run.stdout").write_text(printed)
    with h5py.File(out / "checkpoint_00000007.h5", "w") as file:
        file.attrs["time_s"] = 0.006
        for name, value in {"u": np.array([1.5, np.pi]), "strain": np.array([0.5, 0.1], "f4"), "boxes": np.array([[0, 7]]),
                            "wall_s": np.array([1.5]), "case": np.frombuffer(b"[grid]\nfinest_cm = 0.1\n", np.uint8),
                            **(fields or {})}.items():
            if value is not None:
                file[name] = value
    for name in more:
        (out / name).write_text("a\n1\n")


def compare(*options, **changes):
    with tempfile.TemporaryDirectory() as scratch:
        old, new = Path(scratch, "old"), Path(scratch, "new")
        write(old)
        write(new, **changes)
        done = subprocess.run([tool, "compare", old, new, *options], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def expect(code, words, *options, **changes):
    """The comparison with `changes` ends with `code` and has a line with all of `words`."""
    result, said = compare(*options, **changes)
    if result != code or not any(all(word in line for word in words) for line in said.splitlines()):
        found.append(f"{changes} {options}: exit code {result}, expected {code} and a line with {words}\n{said}")


def finds_changes():
    expect(0, ["0 differences"])
    third = 1 / 3
    p = [80.0, bit_after(third), float("nan")]
    expect(1, ["step.csv", "p_ao_mmHg", "1 of 3 differ, first at [1]", repr(third), repr(float(p[1]))], table={"p_ao_mmHg": p})
    expect(1, ["run.json", "t_s", repr(0.1 + 0.2), "5.55e-17"], record={"t_s": float(bit_after(0.1 + 0.2))})
    expect(1, ["run.json", "sd", "null became 1.0"], record={"sd": 1.0})
    expect(1, [".h5", "u", "1 of 2 differ, first at [1]"], fields={"u": bit_after(np.array([1.5, np.pi])) - [2.0 ** -52, 0]})
    expect(1, ["strain", "2 of 2 differ"], fields={"strain": bit_after(np.array([0.5, 0.1], "f4"))})
    expect(1, ["boxes", "first at [0, 1]: 7 became 8"], fields={"boxes": np.array([[0, 8]])})
    expect(1, ["case:grid.finest_cm", "0.1 became 0.2"], fields={"case": np.frombuffer(b"[grid]\nfinest_cm = 0.2\n", np.uint8)})
    expect(1, ["u", "shape [2] became [3]"], fields={"u": np.array([1.5, np.pi, 0])})
    expect(1, ["t_s", "0.0 became -0.0"], table={"t_s": [-0.0, 0.1, 0.2]})
    expect(1, ["missing", "step.csv", "p_ao_mmHg"], table={"p_ao_mmHg": None})
    expect(1, ["additional", "step.csv", "Q_ml_s"], table={"Q_ml_s": [1.0, 2.0, 3.0]})
    expect(1, ["missing", ".h5", "strain"], fields={"strain": None})
    expect(1, ["additional file", "beats.csv"], more=["beats.csv"])
    expect(1, ["text", "line 8: 80 became 81"], printed=PRINTED.replace("120/80", "120/81"))
    expect(1, ["text", "line 4: 1234 became 1235"], printed=PRINTED.replace("1234", "1235"))
    expect(1, ["text", "line 8: 95 became nan"], printed=PRINTED.replace("mean 95", "mean nan"))
    expect(1, ["dt_bound", "word 2"], table={"dt_bound": ["elastic", "cfl", "cfl"]})


def tells_of_nan():
    expect(0, ["NaN", "p_ao_mmHg", "1 of 3 values are NaN in both"])
    expect(1, ["p_ao_mmHg", "nan became 1.0", "NaN on one side only"], table={"p_ao_mmHg": [80.0, 1 / 3, 1.0]})
    expect(1, ["u", "nan", "NaN on one side only"], fields={"u": np.array([1.5, np.nan])})


def leaves_the_machine_out():
    slower = PRINTED.replace("32 ms/step  ETA 1 min 3 s", "40 ms/step  ETA 9 s").replace("84 MB", "85 MB")
    slower = slower.replace("31 ms per", "33 ms per").replace(", 38 s without", ", 1 min 2 s without")
    slower = slower.replace("2.748", "3.1").replace("1.33", "2.5").replace("/somewhere/1/", "/elsewhere/2/")
    code, said = compare(table={"wall_s": [7.0, 8.0, 9.0]}, printed=slower, fields={"wall_s": np.array([9.0])},
                         record={"host": "b", "wall_s": 3.0, "peak_memory_mb": 1.0, "written": "2027-01-01T00:00:00Z"})
    if code or "0 texts in other words" not in said:
        found.append(f"what measures the machine was reported: {said}")


def tells_words_apart():
    expect(0, ["words", "cells of", "cells, each"], "--words", printed=PRINTED.replace("cells of", "cells, each"))
    expect(0, ["words", "outcome"], "--words", record={"outcome": "done"})
    expect(0, ["words", "dt_bound"], "--words", table={"dt_bound": ["structure", "flow", "structure"]})


def knows_what_is_meant():
    renamed = {"p_ao_mmHg": None, "p_aorta_mmHg": CSV["p_ao_mmHg"]}
    expect(0, ["0 differences"], "--rename", "p_ao_mmHg=p_aorta_mmHg", table=renamed)
    expect(0, ["0 differences"], "--rename", "*.h5:u=velocity", fields={"u": None, "velocity": np.array([1.5, np.pi])})
    expect(1, ["missing"], "--rename", "*.csv:u=velocity", fields={"u": None, "velocity": np.array([1.5, np.pi])})
    expect(0, ["1 expected"], "--expect", "surge.*run.json steps", record={"steps": 13})
    with tempfile.NamedTemporaryFile("w", suffix=".rules") as rules:
        rules.write("rename p_ao_mmHg = p_aorta_mmHg\n# why\nexpect *run.json steps  # one step more\n")
        rules.flush()
        expect(0, ["1 expected"], "--rules", rules.name, table=renamed, record={"steps": 13})


def repeats_itself(program):
    """Real runs, with a restart: recorded twice, the numbers are the same."""
    with tempfile.TemporaryDirectory() as scratch:
        folders = [Path(scratch, name) for name in ("one", "two")]
        steps = [[tool, "record", root, folder, "--program", program, "--only", "restart.tube"] for folder in folders]
        for words in [*steps, [tool, "compare", *folders]]:
            done = subprocess.run(words, capture_output=True, text=True)
            if done.returncode:
                found.append(f"{words[1]}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        if "0 texts in other words" not in done.stdout:
            found.append(f"other words in the second recording: {done.stdout}")


if len(sys.argv) > 2:
    repeats_itself(sys.argv[2])
else:
    for test in [finds_changes, tells_of_nan, leaves_the_machine_out, tells_words_apart, knows_what_is_meant]:
        test()
print("\n".join(found))
sys.exit(1 if found else 0)
