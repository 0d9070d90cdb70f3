#!/usr/bin/python3
"""ParaView opens the output of a run: the same numbers as h5py reads, all times, and the standard view.

    paraview.py VALSALVA ROOT
Exit code 77 (skipped) without pvpython or xvfb-run (apt-get install python3-paraview xvfb).
"""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np
from PIL import Image

program, root = sys.argv[1], Path(sys.argv[2])
if not shutil.which("pvpython") or not shutil.which("xvfb-run"):
    print("skipped: needs pvpython and xvfb-run (apt-get install python3-paraview xvfb)")
    sys.exit(77)

READ = """
import json, sys
from paraview import simple as pv
from paraview.simple import servermanager
found = {}
for name in sys.argv[1:]:
    reader = pv.OpenDataFile(name)
    times = [float(t) for t in getattr(reader, "TimestepValues", None) or []]
    reader.UpdatePipeline(times[-1] if times else 0.0)
    info = reader.GetDataInformation()
    arrays = {}
    for where in (reader.PointData, reader.CellData):
        for array in where:
            arrays[array.Name] = [array.GetRange(c) for c in range(array.GetNumberOfComponents())]
    found[name] = {"points": info.GetNumberOfPoints(), "cells": info.GetNumberOfCells(),
                   "bounds": info.GetBounds(), "times": times, "arrays": arrays}
print("FOUND" + json.dumps(found))
"""
found = []


def expect(truth, words):
    if not truth:
        found.append(words)


def run(*words):
    return subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=280)


def ranges(values):
    values = np.asarray(values, float).reshape(len(values), -1)
    return list(zip(values.min(axis=0), values.max(axis=0)))


def check_grid(seen, path):
    """Compares a file of points and cells."""
    with h5py.File(path, "r") as file:
        data = file["VTKHDF"]
        points = data["Points"][:]
        expect(seen["points"] == len(points), f"{path.name}: {seen['points']} points, h5py finds {len(points)}")
        expect(seen["cells"] == len(data["Types"]), f"{path.name}: {seen['cells']} cells")
        limits = np.array(ranges(points)).ravel()
        expect(np.allclose(seen["bounds"], limits, atol=1e-6), f"{path.name}: bounds {seen['bounds']}, {limits}")
        for group in ("PointData", "CellData"):
            for name, values in data[group].items():
                expect(np.allclose(seen["arrays"].get(name, np.nan), ranges(values[:]), rtol=1e-6),
                       f"{path.name}: {name} {seen['arrays'].get(name)}, h5py finds {ranges(values[:])}")


def check_fields(seen, path):
    """Compares a file of levels and boxes: number of cells, bounds and the ranges over all cells."""
    with h5py.File(path, "r") as file:
        levels = [file["VTKHDF"][name] for name in file["VTKHDF"]]
        cells = sum(len(level["CellData/pressure_mmHg"]) for level in levels)
        size = levels[0].attrs["Spacing"] * (levels[0]["AMRBox"][:, 1::2].max(axis=0) + 1)
        expect(seen["cells"] == cells, f"{path.name}: {seen['cells']} cells, h5py finds {cells}")
        expect(np.allclose(seen["bounds"][1::2], size), f"{path.name}: bounds {seen['bounds']}, size {size}")
        for name in ("pressure_mmHg", "velocity_cm_s"):
            values = np.concatenate([level["CellData"][name][:] for level in levels])
            low_high = np.array(ranges(values))
            shown = np.array(seen["arrays"][name])[:low_high.shape[0]]
            expect(np.allclose(shown, low_high, rtol=1e-5, atol=1e-6), f"{path.name}: {name} {shown}, {low_high}")


with tempfile.TemporaryDirectory() as scratch:
    out, picture = Path(scratch, "out"), Path(scratch, "view.png")
    ran = run(program, "run", root / "cases/aortic_root", "-o", out, "--set", "grid.finest_cm=0.15625", "--set",
              "grid.levels=2", "--set", "time.end_s=0.002", "--set", "output.fields_every_s=0.001", "--set",
              "output.structure_every_s=0.001", "--set", "output.pictures=false", "--set", "markers.aorta.start_s=1.0",
              "--set", "markers.ventricle.start_s=0.0005")
    expect(ran.returncode == 0, f"run: {ran.stdout}{ran.stderr}")
    Path(scratch, "read.py").write_text(READ)
    series = {"fields": "fields/fields", "leaflets": "structure/leaflets", "markers": "structure/markers"}
    names = [out / f"{stem}.hdf.series" for stem in series.values()] + [out / "structure/wall.hdf",
                                                                       out / "structure/markers_0000.hdf"]
    read = run("pvpython", "--force-offscreen-rendering", Path(scratch, "read.py"), *names)
    answer = read.stdout.partition("FOUND")[2]
    if not answer:
        found.append(f"pvpython read nothing\n{read.stdout}{read.stderr}")
    else:
        expect("ERR" not in read.stderr, read.stderr)
        seen = {Path(name).name: what for name, what in json.loads(answer).items()}
        for stem in series.values():
            times = seen[f"{Path(stem).name}.hdf.series"]["times"]
            expect(np.allclose(times, [0, 0.001, 0.002]), f"{stem}: times {times}")
        check_fields(seen["fields.hdf.series"], out / "fields/fields_0002.hdf")
        check_grid(seen["leaflets.hdf.series"], out / "structure/leaflets_0002.hdf")
        check_grid(seen["markers.hdf.series"], out / "structure/markers_0002.hdf")
        check_grid(seen["wall.hdf"], out / "structure/wall.hdf")
        expect(seen["markers_0000.hdf"]["points"] == 0, "a file without markers has some")
    for _ in range(4):  # xvfb-run waits three seconds for its server, which may be too short on a busy machine
        view = run("xvfb-run", "-a", "pvpython", root / "scripts/paraview_view.py", out, "-o", picture)
        if "bad X server" not in view.stderr:
            break
    if not picture.is_file():
        found.append(f"no picture\n{view.stdout}{view.stderr}")
    else:
        pixels = np.asarray(Image.open(picture).convert("RGB")).reshape(-1, 3)
        expect(len(np.unique(pixels, axis=0)) > 200, "the view is all but empty")
        expect(np.mean(np.all(pixels > 250, axis=1)) > 0.2, "the background is not white")

print("\n".join(found))
sys.exit(1 if found else 0)
