"""A recorded file as named values: arrays of numbers, tuples of words, printed text, None for a null of JSON."""
import csv
import json
import tomllib

import h5py
import numpy as np

from recording import exclusions

TOML_DATASETS = {"case"}  # text as bytes in the checkpoints
RECORDED_ENDINGS = {".csv", ".json", ".series", ".toml", ".hdf", ".h5", ".txt", ".md", ".stdout", ".stderr"}


class Text(list):
    """Printed text: (number of the line, line)."""


def read(path, file):
    """Name -> value of everything in `path`, known as `file`, that is not excluded."""
    readers = {".csv": read_csv, ".json": read_json, ".series": read_json, ".toml": read_toml, ".hdf": read_hdf5,
               ".h5": read_hdf5}
    values = readers.get(path.suffix, read_text)(path)
    values = {name: value for name, value in values.items() if not exclusions.name_is_excluded(file, name)}
    return {name: as_words(value) if exclusions.is_a_word(file, name) else value for name, value in values.items()}


def as_words(value):
    return tuple(map(str, value.ravel())) if isinstance(value, np.ndarray) else value


def read_text(path):
    return {"text": Text(exclusions.without_machine(path.read_text(errors="replace")))}


def number_of(word):
    try:
        return float(word)
    except ValueError:
        return None


def read_csv(path):
    with open(path, newline="") as file:
        header, *rows = list(csv.reader(file)) or [[]]
    values = {}
    for name, cells in zip(header, zip(*rows) if rows else [()] * len(header)):
        numbers = [number_of(cell) for cell in cells]
        if None in numbers:
            values[f"{name} (words)"] = tuple(c if n is None else "#" for c, n in zip(cells, numbers))
        if any(n is not None for n in numbers) or not cells:
            values[name] = np.array([n for n in numbers if n is not None], dtype=float)
    if rows:
        values["cells of a row"] = np.array([len(row) for row in rows])
    return values


def read_json(path):
    values = {}
    flatten(json.loads(path.read_text()), "", values)
    return values


def read_toml(path):
    values = {}
    flatten(tomllib.loads(path.read_text()), "", values)
    return values


def flatten(node, name, values):
    """Names are joined with dots; an entry of a list of tables goes by its `name` where all have one of their own."""
    if isinstance(node, list) and node and all(isinstance(entry, dict) for entry in node):
        names = [entry.get("name") for entry in node]
        named = None not in names and len(set(names)) == len(names)
        node = {str(n if named else i): entry for i, (n, entry) in enumerate(zip(names, node))}
    elif isinstance(node, list) and not is_plain(node):
        node = {str(i): entry for i, entry in enumerate(node)}
    if isinstance(node, dict):
        for key, entry in node.items():
            flatten(entry, f"{name}.{key}" if name else key, values)
    elif isinstance(node, str):
        values[name] = (node,)
    elif isinstance(node, list) and all(isinstance(entry, str) for entry in node):
        values[name] = tuple(node)
    else:
        values[name] = None if node is None else np.asarray(node)


def is_plain(entries):
    return (all(isinstance(e, str) for e in entries) or
            all(isinstance(e, (int, float)) for e in entries))


def read_hdf5(path):
    values = {}

    def attributes(name, item):
        for key, value in item.attrs.items():
            values[f"{name}@{key}"] = words_or_numbers(value)

    def add(name, item):
        attributes(name, item)
        if not isinstance(item, h5py.Dataset):
            return
        if name in TOML_DATASETS and item.dtype == np.uint8:
            case = {}
            flatten(tomllib.loads(item[()].tobytes().decode()), "", case)
            values.update({f"{name}:{key}": value for key, value in case.items()})
        else:
            values[name] = words_or_numbers(item[()])
    with h5py.File(path) as file:
        attributes("", file)
        file.visititems(add)
    return values


def words_or_numbers(value):
    array = np.asarray(value)
    if array.dtype.kind in "biuf":
        return array
    return tuple(one.decode() if isinstance(one, bytes) else str(one) for one in array.ravel().tolist())
