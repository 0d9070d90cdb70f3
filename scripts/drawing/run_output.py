"""Readers for the output of a run, finished or not."""
import csv
import json
import re
from pathlib import Path

import h5py
import numpy as np


class Missing(Exception):
    """An input of a picture is missing; the text says which."""


def read_table(path):
    """CSV -> {column: array}; text columns stay lists of strings. An incomplete last row is dropped."""
    path = Path(path)
    if not path.is_file():
        raise Missing(f"no {path.name}")
    with open(path, newline="") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    if len(rows) < 2:
        raise Missing(f"{path.name} has no rows yet")
    header, rows = [name.strip() for name in rows[0]], rows[1:]
    if len(rows[-1]) < len(header):
        rows.pop()
    table = {}
    for name, column in zip(header, zip(*rows)):
        try:
            table[name] = np.array([float(v) if v.strip() else np.nan for v in column])
        except ValueError:
            table[name] = list(column)
    return table


def phase_times(out):
    """[(phase, seconds, share in %)] from the table at the end of log.txt; empty if there is none yet."""
    path = Path(out) / "log.txt"
    log = path.read_text() if path.is_file() else ""
    rows = re.findall(r"^(\S[^\d\n]*?) +([\d.]+) +([\d.]+) +\d+ +[\d.]+$", log.rpartition("\nphase ")[2], re.MULTILINE)
    return [(name, float(seconds), float(share)) for name, seconds, share in rows]


def columns_like(table, pattern):
    """{first group of the pattern: array} for the columns whose full name matches, in file order."""
    found = {}
    for name, values in table.items():
        match = re.fullmatch(pattern, name)
        if match and not isinstance(values, list):
            found[match.group(1)] = values
    return found


def read_series(folder, stem=None):
    """[(time, path)] from a .hdf.series, or from the numbered files if there is none; only files that exist."""
    folder = Path(folder)
    if not folder.is_dir():
        raise Missing(f"no folder {folder.name}/")
    found = {}
    for series in sorted(folder.glob(f"{stem or '*'}.hdf.series")):
        for entry in json.loads(series.read_text())["files"]:
            found[folder / entry["name"]] = float(entry["time"])
    if not found:
        for path in sorted(folder.glob(f"{stem or '*'}_[0-9]*.hdf")):
            with h5py.File(path, "r") as file:
                found[path] = float(np.ravel(file.attrs.get("time_s", [np.nan]))[0])
    frames = sorted((t, path) for path, t in found.items() if path.is_file() and np.isfinite(t))
    if not frames:
        raise Missing(f"no files in {folder.name}/")
    return frames


def nearest(frames, t):
    """The frame (time, path) nearest to t; of two equally near (to a millisecond), the later."""
    return min(frames, key=lambda frame: (round(abs(frame[0] - t), 3), -frame[0]))


class Fibers:
    """Points, groups and lines of one structure file; all pieces in one numbering."""

    def __init__(self, path):
        with h5py.File(path, "r") as file:
            data = file["VTKHDF"]
            self.points = data["Points"][:].astype(float)
            self.group = data["PointData/group"][:]
            names = file.attrs.get("group_names", b"")
            self.names = (names.decode() if isinstance(names, bytes) else str(names)).split("\n")
            self.lines, self.strain = self._lines(data)

    @staticmethod
    def _lines(data):
        types, strain = data["Types"][:], data["CellData/strain"][:]
        connectivity, offsets = data["Connectivity"][:], data["Offsets"][:]
        point = cell = index = offset = 0
        lines, strains = [], []
        for n_points, n_cells, n_ids in zip(*(data[f"NumberOf{what}"][:]
                                              for what in ("Points", "Cells", "ConnectivityIds"))):
            line = types[cell:cell + n_cells] == 3
            first = offsets[offset:offset + n_cells][line]
            ids = connectivity[index:index + n_ids] + point
            lines.append(np.stack([ids[first], ids[first + 1]], axis=1))
            strains.append(strain[cell:cell + n_cells][line])
            point, cell, index, offset = point + n_points, cell + n_cells, index + n_ids, offset + n_cells + 1
        if not lines:
            return np.zeros((0, 2), int), np.zeros(0)
        return np.concatenate(lines), np.concatenate(strains)

    def groups_like(self, word):
        """Numbers of the groups whose name begins with `word`, in order; without names, all but group 0."""
        named = [g for g, name in enumerate(self.names) if name.startswith(word)]
        if named or any(self.names):
            return named
        return [g for g in np.unique(self.group) if g > 0] if word == "leaflet" else [0]

    def lines_of(self, group):
        return self.lines[self.group[self.lines[:, 0]] == group]


def leaflet_frames(out):
    """The frames of the leaflets: structure/leaflets*.hdf, or files with the whole structure."""
    folder = Path(out) / "structure"
    try:
        return read_series(folder, "leaflets")
    except Missing:
        return [f for f in read_series(folder) if f[1].name != "wall.hdf"]


def wall_points(out):
    """Points of the wall (n, 3), from structure/wall.hdf or a file with the whole structure; None if unknown."""
    path = Path(out) / "structure" / "wall.hdf"
    if not path.is_file():
        try:
            path = leaflet_frames(out)[0][1]
        except Missing:
            return None
    fibers = Fibers(path)
    walls = fibers.groups_like("wall")
    points = fibers.points[np.isin(fibers.group, walls)]
    return points if len(points) else None
