#!/usr/bin/python3
"""Holds every #include "..." of src/ against docs/architecture.md and every source file against 300 lines.

    layers.py ROOT        exit code 1 and one line per offence
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from source_files import CPP, source_files

MOST_LINES = 300

# folder of src/ -> the folders it may include (its own is always allowed); "ib3d/*" is the folder and all below it
ALLOWED = {
    "common": [],
    "casefile": ["common"],
    "lumped/network": ["common"],
    "lumped/elements": ["common", "lumped/network"],
    "lumped/integration": ["common", "lumped/network"],
    "lumped/fit": ["common", "lumped/network", "lumped/integration"],
    "ib3d/grid": ["common"],
    "ib3d/structure": ["common"],
    "ib3d/structure/fibres": ["common", "ib3d/structure"],
    "ib3d/structure/aortic_root": ["common", "ib3d/structure", "ib3d/structure/fibres"],
    "ib3d/fluid/pressure": ["common", "ib3d/grid"],
    "ib3d/fluid": ["common", "ib3d/grid", "ib3d/fluid/pressure"],
    "ib3d/interaction": ["common", "ib3d/grid", "ib3d/structure"],
    "ib3d/output": ["common", "ib3d/grid", "ib3d/structure"],
    "ib3d": ["common", "ib3d/grid", "ib3d/fluid", "ib3d/structure", "ib3d/interaction"],
    "coupling": ["common", "lumped/*", "ib3d/*"],
    "setup": ["common", "casefile", "lumped/*", "ib3d/*", "coupling"],
    "run": ["common", "casefile", "lumped/*", "ib3d/*", "coupling", "setup", "run/beats"],
    "run/beats": ["common", "casefile", "lumped/*", "ib3d/*", "coupling", "setup"],
    "app": ["common", "casefile", "setup", "run"],
}
GENERATED = {"valsalva_version.hpp": "app"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def folder_of(relative):
    """'ib3d/grid/halo.hpp' -> 'ib3d/grid', or None outside the table."""
    folder = str(pathlib.PurePosixPath(relative).parent)
    return folder if folder in ALLOWED else None


def may_be(folder, allowed):
    """Does `allowed`, an entry of the table, cover `folder`?"""
    return folder == allowed or (allowed.endswith("/*") and f"{folder}/".startswith(allowed[:-1]))


def include_offences(src, path):
    relative = path.relative_to(src).as_posix()
    own = folder_of(relative)
    if own is None:
        return [f"src/{relative}: its folder is not in the table of tests/style/layers.py"]
    offences = []
    for included in INCLUDE.findall(path.read_text()):
        if GENERATED.get(included) == own:
            continue
        target = folder_of(included)
        if target is None or not (src / included).is_file():
            offences.append(f'src/{relative}: "{included}" is no file below src/')
        elif target != own and not any(may_be(target, allowed) for allowed in ALLOWED[own]):
            offences.append(f"src/{relative}: {own} may not include {target} ({included})")
    return offences


def main(root):
    src = pathlib.Path(root, "src")
    offences = []
    for path in source_files(root, ("src",), frozenset(CPP)):
        if path.suffix in CPP:
            offences += include_offences(src, path)
    for path in source_files(root):
        lines = len(path.read_text().splitlines())
        if lines > MOST_LINES:
            offences.append(f"{path.relative_to(root)}: {lines} lines, allowed are {MOST_LINES}; split it")
    print("\n".join(offences) or "layers and lengths are in order")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
