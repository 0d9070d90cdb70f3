#!/usr/bin/python3
"""Runs `valsalva check` and `valsalva run` on an invalid case and compares exit code and message with the case's comments.

    bad_case.py VALSALVA CASE.toml

A line `# expect: WORDS` requires WORDS in one line of the message; `@` stands for "line:column" of the line below
`# here:COLUMN`.
"""
import pathlib
import re
import subprocess
import sys
import tempfile


def expectations(case):
    lines = case.read_text().splitlines()
    place = ""
    for number, line in enumerate(lines, start=1):
        here = re.match(r"\s*# here:(\d+)", line)
        if here:
            place = f"{number + 1}:{here.group(1)}"
    wanted = [line.split("# expect: ", 1)[1] for line in lines if line.startswith("# expect: ")]
    return [words.replace("@", place) for words in wanted]


def failures(command, wanted):
    result = subprocess.run(command, capture_output=True, text=True)
    said = result.stderr
    found = []
    if result.returncode != 2:
        found.append(f"exit code {result.returncode} instead of 2")
    for words in wanted:
        if not any(words in line for line in said.splitlines()):
            found.append(f"not said: {words}")
    return [f"{' '.join(command)}: {f}\n{said}" for f in found]


def main(program, case_name):
    case = pathlib.Path(case_name)
    wanted = expectations(case)
    assert wanted, f"{case} expects nothing"
    with tempfile.TemporaryDirectory() as scratch:
        out = str(pathlib.Path(scratch, "out"))
        found = failures([program, "check", str(case)], wanted)
        found += failures([program, "run", str(case), "-o", out], wanted)
        if pathlib.Path(out).exists():
            found.append("a rejected case left an output folder behind")
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
