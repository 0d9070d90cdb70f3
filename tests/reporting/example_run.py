"""A small synthetic run folder: a beat with statistics in closed form, three flat leaflets, two grid levels.

Flow: forward q = PEAK sin(pi (t - 0.1)/0.3) from 0.1 to 0.4 s, back q = -BACK sin(pi (t - 0.4)/0.05) until 0.45 s,
then zero until 0.8 s.
"""
import json

import h5py
import numpy as np

PEAK, BACK, EJECTION = 400.0, 80.0, 0.3
FORWARD_ML = PEAK * EJECTION * 2 / np.pi
CLOSING_ML = BACK * 0.05 * 2 / np.pi
FRAMES = 41


def flow(t):
    return np.where((t > 0.1) & (t < 0.4), PEAK * np.sin(np.pi * (t - 0.1) / EJECTION),
                    np.where((t > 0.4) & (t < 0.45), -BACK * np.sin(np.pi * (t - 0.4) / 0.05), 0.0))


def write_csv(path, columns):
    rows = [",".join(columns)] + [",".join(v if isinstance(v, str) else f"{v:.9g}" for v in row)
                                  for row in zip(*columns.values())]
    path.write_text("\n".join(rows) + "\n")


def write(out, scale=1.0, outcome="finished"):
    """Writes the run folder `out`, with the flow multiplied by `scale`."""
    for folder in ("fields", "structure"):
        (out / folder).mkdir(parents=True)
    t = np.linspace(0, 0.8, 1601)
    q = scale * flow(t)
    p_ao, p_lv = 80 + 0.05 * q, np.where((t > 0.1) & (t < 0.4), 84 + 0.05 * q, 5.0)
    write_csv(out / "openings.csv", {"t_s": t, "p_lv_mmHg": p_lv, "p_ao_mmHg": p_ao, "Q_inlet_ml_s": q,
                                     "Q_outlet_ml_s": q, "arteries.Pc_mmHg": p_ao})
    write_csv(out / "probes.csv", {"t_s": t, "p_z1_mmHg": p_lv, "p_z9_mmHg": p_ao, "Q_upstream_ml_s": q,
                                   "Q_valve_ml_s": q, "area_cm2": np.where(q > 0, 3.5 * q / PEAK, 0),
                                   "fibre_strain_max": 0.1 + 0 * t})
    write_csv(out / "step.csv", {"step": np.arange(len(t)), "t_s": t, "dt_s": np.append(0, np.diff(t)),
                                 "cfl": 0.2 + 0 * t, "iterations": 3 + 0 * t, "rms_divergence_1_s": 1e-4 + 0 * t,
                                 "max_divergence_1_s": 1e-3 + 0 * t, "wall_s": 0.01 + 0 * t,
                                 "dt_bound": ["elastic"] * len(t)})
    if outcome == "finished":
        beat = {"beat": 1, "start_s": 0, "period_s": 0.8, "stroke_volume_ml": scale * (FORWARD_ML - CLOSING_ML),
                "forward_volume_ml": scale * FORWARD_ML, "closing_volume_ml": scale * CLOSING_ML, "leak_volume_ml": 0,
                "mean_leak_ml_s": 0, "ejection_time_s": EJECTION, "opening_s": 0.1, "closing_s": 0.45,
                "peak_flow_ml_s": scale * PEAK, "least_flow_ml_s": -scale * BACK, "mean_gradient_mmHg": 4,
                "max_orifice_area_cm2": 3.5 * scale, "p_ao_systolic_mmHg": 80 + 0.05 * scale * PEAK,
                "p_ao_diastolic_mmHg": 80 - 0.05 * scale * BACK, "p_ao_mean_mmHg": 85, "mass_balance_ml": 1e-6}
        write_csv(out / "beats.csv", {name: [value] for name, value in beat.items()})
    (out / "run.json").write_text(json.dumps({"case": "made/up.toml", "outcome": outcome, "ranks": 2, "host": "here",
                                              "t_s": 0.8, "steps": 1600, "cells": 640, "nodes": 147, "wall_s": 12.5,
                                              "peak_memory_mb": 20, "written": "2026-01-01T00:00:00Z"}))
    (out / "case.resolved.toml").write_text('title = "Made up <b>& more</b>"\n[time]\nend_s = 0.8\n'
                                            '[grid]\nfinest_cm = 0.1\n[fluid]\nadvection = "limited"\n'
                                            '[[opening]]\nname = "inlet"\n')
    (out / "log.txt").write_text("phase       s     %   calls   ms/call\nspread   4.00  40.0    1600     2.500\n"
                                 "output   6.00  60.0    1600     3.750\nwall    10.00 100.0\n")
    for frame, time in enumerate(np.linspace(0, 0.8, FRAMES)):
        _structure(out / "structure" / f"leaflets_{frame:04d}.hdf", time, float(flow(np.array([time]))[0]) / PEAK)
        _fields(out / "fields" / f"fields_{frame:04d}.hdf", time)
        _markers(out / "structure" / f"markers_{frame:04d}.hdf", time)
    for folder, stem in (("fields", "fields"), ("structure", "leaflets"), ("structure", "markers")):
        files = [{"name": f"{stem}_{i:04d}.hdf", "time": t} for i, t in enumerate(np.linspace(0, 0.8, FRAMES))]
        (out / folder / f"{stem}.hdf.series").write_text(json.dumps({"file-series-version": "1.0", "files": files}))


def _structure(path, time, opening):
    """Three sectors of a disc of radius 1 cm about (2, 2), lifted by `opening`."""
    points, lines, group = [], [], []
    for leaflet in range(3):
        radius, angle = np.meshgrid(np.linspace(0.2, 1, 7), np.linspace(0, 2 * np.pi / 3, 7), indexing="ij")
        angle = angle + 2 * np.pi / 3 * leaflet
        number = len(points) + np.arange(49).reshape(7, 7)
        points += np.stack([2 + radius * np.cos(angle), 2 + radius * np.sin(angle),
                            2 + max(opening, 0) * (1 - radius)], axis=2).reshape(-1, 3).tolist()
        lines += np.stack([number[:-1].ravel(), number[1:].ravel()], axis=1).tolist()
        lines += np.stack([number[:, :-1].ravel(), number[:, 1:].ravel()], axis=1).tolist()
        group += 49 * [leaflet]
    with h5py.File(path, "w") as file:
        data = file.create_group("VTKHDF")
        data["Points"] = np.array(points, "f4")
        data["PointData/group"] = np.array(group, "i4")
        data["CellData/strain"] = np.zeros(len(lines), "f4")
        data["Types"] = np.full(len(lines), 3, "u1")
        data["Connectivity"] = np.array(lines).ravel()
        data["Offsets"] = 2 * np.arange(len(lines) + 1)
        for what, n in (("Points", len(points)), ("Cells", len(lines)), ("ConnectivityIds", 2 * len(lines))):
            data[f"NumberOf{what}"] = np.array([n])
        file.attrs["group_names"] = np.bytes_("leaflet 1\nleaflet 2\nleaflet 3")
        file.attrs["time_s"] = np.array([time])


def _markers(path, time):
    """Two planes of 9 x 9 markers below and above the leaflets, the lower one carried upwards during ejection."""
    x, y = (a.ravel() for a in np.meshgrid(np.linspace(1.2, 2.8, 9), np.linspace(1.2, 2.8, 9)))
    carried = 5 * np.clip((time - 0.1) / EJECTION, 0, 1)
    with h5py.File(path, "w") as file:
        data = file.create_group("VTKHDF")
        data["Points"] = np.concatenate([np.stack([x, y, 0 * x + z], axis=1) for z in (1 + carried, 4)]).astype("f4")
        data["PointData/id"] = np.arange(162, dtype="i4")
        data["PointData/group"] = np.repeat([0, 1], 81).astype("i4")
        data["PointData/age_s"] = np.full(162, time, "f4")
        file.attrs["group_names"] = np.bytes_("ventricle\naorta")
        file.attrs["time_s"] = np.array([time])


def _fields(path, time):
    """Level 0: 4 x 4 x 10 cells of 1 cm; level 1: the centre, 4 x 4 x 20 of 0.5 cm. Pressure is 10 z mmHg."""
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Origin"] = np.zeros(3)
        for name, h, box in (("Level0", 1.0, [0, 3, 0, 3, 0, 9]), ("Level1", 0.5, [2, 5, 2, 5, 0, 19])):
            level = root.create_group(name)
            level.attrs["Spacing"] = np.full(3, h)
            level["AMRBox"] = np.array([box], "i4")
            nx, ny, nz = (box[2 * d + 1] - box[2 * d] + 1 for d in range(3))
            z = (np.arange(nz) + 0.5) * h
            level["CellData/pressure_mmHg"] = np.repeat(10 * z, nx * ny).astype("f4")
            speed = np.zeros((nz * ny * nx, 3), "f4")
            speed[:, 2] = 100 * abs(float(flow(np.array([time]))[0])) / PEAK
            level["CellData/velocity_cm_s"] = speed
        file.attrs["time_s"] = np.array([time])
