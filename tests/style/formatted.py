#!/usr/bin/python3
"""Checks every C++ file with clang-format 14 and the .clang-format of the project.

    formatted.py ROOT        exit code 1 and the names of the files to format
"""
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
from source_files import CPP, source_files


def main(root):
    program = shutil.which("clang-format-14") or shutil.which("clang-format")
    if not program:
        print("clang-format is missing; install it with scripts/bootstrap")
        return 1
    files = [str(p) for p in source_files(root, ("src", "tests"), frozenset(CPP)) if p.suffix in CPP]
    said = subprocess.run([program, "--dry-run", "-Werror", *files], capture_output=True, text=True).stderr
    bad = sorted({line.split(":")[0] for line in said.splitlines() if "clang-format-violations" in line})
    if bad:
        print("not formatted; fix with:\nclang-format -i " + " ".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
