"""Compares two recordings, or two folders in them, value by value: doubles by their bits, printed numbers in their order.

Numbers, and names that only one side has, fail; words and what a rule expects are told apart and do not.
"""
import difflib
import re
from dataclasses import dataclass
from fnmatch import fnmatch

import numpy as np

from recording import exclusions, readers

NUMBER = re.compile(r"(?<![\w.^*-])[-+]?(?:\d+\.?\d*(?:[eE][-+]?\d+)?|nan|inf)(?![\w^*]|\.\d)")


@dataclass
class Finding:
    file: str
    name: str
    what: str
    kind: str = "number"  # or printed, missing, additional; words, NaN, expected

    @property
    def fails(self):
        return self.kind not in ("words", "NaN", "expected")

    def __str__(self):
        return "  ".join(part for part in [self.file, self.name, self.what] if part)


class Rules:
    """What is meant to differ.

    rename [FILES:]OLD=NEW   whole parts of a name (between . / : @) of a file, column, key or dataset; * stands for a part
    expect PATTERN           a difference whose file and name, joined by a blank, match
    """

    def __init__(self, renames=(), expected=(), files=()):
        renames, self.expected = list(renames), list(expected)
        for file in files:
            for line in file.read_text().splitlines():
                verb, _, rest = line.partition("#")[0].strip().partition(" ")
                if verb and verb not in ("rename", "expect"):
                    raise SystemExit(f"same_numbers: {file}: a rule begins with rename or expect, found: {line}")
                if verb:
                    (renames if verb == "rename" else self.expected).append(rest.strip())
        self.renames = [self.rename_rule(rule) for rule in renames]

    def rename_rule(self, rule):
        old, equals, new = (part.strip() for part in rule.partition("="))
        files, colon, old = old.rpartition(":")
        if not equals or not old or not new:
            raise SystemExit(f"same_numbers: rename {rule}: expected OLD=NEW or FILES:OLD=NEW")
        pattern = re.escape(old).replace(r"\*", "([^./:@]*)")
        return files if colon else "*", re.compile(f"(?<![^./:@]){pattern}(?![^./:@])"), new.split("*")

    def renamed(self, file, name):
        for files, pattern, new in self.renames:
            if fnmatch(file, files):
                name = pattern.sub(lambda m: new[0] + "".join((g or "") + n for g, n in zip(m.groups(), new[1:])), name)
        return name

    def expects(self, finding):
        return any(fnmatch(f"{finding.file} {finding.name}", pattern) for pattern in self.expected)


def compare_recordings(old, new, rules=Rules(), only="*"):
    """All findings about the recipes that match `only`."""
    recipes = [{p.name for p in folder.iterdir() if p.is_dir() and not p.is_symlink() and ".ranks_" in p.name and
                fnmatch(p.name.rpartition(".")[0], only)} for folder in (old, new)]
    findings = one_sided(*recipes, lambda name, kind: Finding(name, "", f"{kind} recipe", kind))
    for name in sorted(recipes[0] & recipes[1]):
        for finding in compare_folders(old / name, new / name, rules.renamed):
            finding.file = f"{name}/{finding.file}"
            findings.append(finding)
    for finding in findings:
        if finding.fails and rules.expects(finding):
            finding.kind = "expected"
    return findings


def one_sided(old, new, finding):
    return ([finding(name, "missing") for name in sorted(old - new)] +
            [finding(name, "additional") for name in sorted(new - old)])


def compare_folders(old, new, renamed=lambda file, name: name, ignore=()):
    def files(folder, rename):
        found = {p.relative_to(folder).as_posix(): p for p in sorted(folder.rglob("*")) if p.is_file()}
        return {rename(f): p for f, p in found.items() if not exclusions.file_is_excluded(f) and f not in ignore}

    one, other = files(old, lambda f: renamed(f, f)), files(new, lambda f: f)
    findings = one_sided(set(one), set(other), lambda f, kind: Finding(f, "", f"{kind} file", kind))
    for file in sorted(set(one) & set(other)):
        try:
            values = {renamed(file, n): v for n, v in readers.read(one[file], file).items()}
            findings += compare_values(file, values, readers.read(other[file], file))
        except (OSError, ValueError, KeyError) as error:
            findings.append(Finding(file, "", f"cannot be read: {error}"))
    return findings


def compare_values(file, old, new):
    findings = one_sided(set(old), set(new), lambda name, kind: Finding(file, name, kind, kind))
    for name in sorted(set(old) & set(new)):
        findings += [Finding(file, name, what, kind) for what, kind in compare(old[name], new[name])]
    return findings


def compare(a, b):
    """(what, kind) of every difference between two values of the same name."""
    if isinstance(a, readers.Text) and isinstance(b, readers.Text):
        return compare_lines(a, b)
    if isinstance(a, tuple) and isinstance(b, tuple):
        return compare_words(a, b)
    if isinstance(a, np.ndarray) and isinstance(b, np.ndarray):
        return compare_numbers(a, b)
    return [] if a is None and b is None else [(f"{shown(a)} became {shown(b)}", "number")]


def shown(value):
    if isinstance(value, np.ndarray) and value.size == 1:
        return repr(value.item())
    return {type(None): "null", np.ndarray: "numbers"}.get(type(value), "words")


def compare_numbers(a, b):
    if a.shape != b.shape:
        return [(f"shape {list(a.shape)} became {list(b.shape)}", "number")]
    findings = []
    if a.dtype != b.dtype:
        if {a.dtype.kind, b.dtype.kind} & {"f"} and a.dtype.itemsize != b.dtype.itemsize and min(
                a.dtype.itemsize, b.dtype.itemsize) < 8:
            return [(f"type {a.dtype} became {b.dtype}", "number")]
        findings.append((f"type {a.dtype} became {b.dtype}", "words"))
        common = np.result_type(a, b)
        a, b = a.astype(common), b.astype(common)
    if a.dtype.kind != "f":
        differ, nans = a != b, 0
    else:
        bits = f"u{a.dtype.itemsize}"
        both_nan = np.isnan(a) & np.isnan(b)
        differ = (np.ascontiguousarray(a).view(bits).reshape(a.shape) !=
                  np.ascontiguousarray(b).view(bits).reshape(a.shape)) & ~both_nan
        nans = int(both_nan.sum())
    if nans:
        findings.append((f"{nans} of {a.size} values are NaN in both", "NaN"))
    if differ.any():
        first = tuple(int(i) for i in np.argwhere(differ)[0])
        with np.errstate(invalid="ignore", over="ignore"):
            distance = np.abs(a.astype(float) - b.astype(float))[differ]
        largest = "NaN on one side only" if np.isnan(distance).any() else f"largest difference {distance.max():.3g}"
        findings.append((f"{int(differ.sum())} of {a.size} differ, first at {list(first)}: {a[first].item()!r} became "
                         f"{b[first].item()!r}, {largest}", "number"))
    return findings


def numbers_in(lines):
    return [(float(m.group()), number) for number, line in lines for m in NUMBER.finditer(line)]


def compare_lines(a, b):
    """Two printed texts: their numbers in order, and whether the words about them are the same."""
    old, new = numbers_in(a), numbers_in(b)
    keys = [[np.float64(value).tobytes() for value, _ in side] for side in (old, new)]
    findings = []
    if keys[0] != keys[1]:
        changes = [c for c in difflib.SequenceMatcher(None, *keys, autojunk=False).get_opcodes() if c[0] != "equal"]
        for _, i, i_end, j, j_end in changes[:3]:
            line = (old[i:i_end] or new[j:j_end])[0][1]
            sides = [" ".join(f"{value:g}" for value, _ in part) or "nothing" for part in (old[i:i_end], new[j:j_end])]
            findings.append((f"line {line}: {sides[0]} became {sides[1]}", "printed"))
        if len(changes) > 3:
            findings.append((f"... and {len(changes) - 3} further places with other numbers", "printed"))
    words = [[NUMBER.sub("#", line).split() for _, line in side] for side in (a, b)]
    if words[0] != words[1]:
        lines = [" ".join(next((x for x, y in zip(p, q + [None] * len(p)) if x != y), ["(nothing)"]))
                 for p, q in (words, words[::-1])]
        findings.append((f'"{lines[0][:100]}" became "{lines[1][:100]}"', "words"))
    return findings


def compare_words(a, b):
    """Words that went one to one into others were renamed; anything else is another result."""
    if len(a) != len(b):
        return [(f"{len(a)} words became {len(b)}", "number")]
    findings = [f for f in compare_lines(list(enumerate(a)), list(enumerate(b))) if f[1] == "printed"]
    pairs = {(NUMBER.sub("#", x), NUMBER.sub("#", y)) for x, y in zip(a, b)}
    if len({x for x, _ in pairs}) < len(pairs) or len({y for _, y in pairs}) < len(pairs):
        at = next(i for i, (x, y) in enumerate(zip(a, b)) if x != y)
        findings.append((f'word {at}: "{a[at][:60]}" became "{b[at][:60]}", elsewhere it did not', "number"))
    elif any(x != y for x, y in pairs):
        x, y = next((x, y) for x, y in sorted(pairs) if x != y)
        findings.append((f'"{x[:100]}" became "{y[:100]}"', "words"))
    return findings
