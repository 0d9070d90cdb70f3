"""The project's own source files."""
import pathlib

CPP = {".cpp", ".hpp"}
SOURCES = CPP | {".py", ".sh", ".cmake"}


def source_files(root, folders=("src", "tests", "scripts", "cmake", "validation", "cases"), endings=frozenset(SOURCES)):
    """All files of `folders` with one of `endings`; scripts without an ending count as sources if they begin with #!."""
    for folder in folders:
        for path in sorted(pathlib.Path(root, folder).rglob("*")):
            if not path.is_file() or "__pycache__" in path.parts:
                continue
            is_script = path.suffix == "" and ".py" in endings and path.read_bytes()[:2] == b"#!"
            if path.suffix in endings or path.name == "CMakeLists.txt" or is_script:
                yield path
