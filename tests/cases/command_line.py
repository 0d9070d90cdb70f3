#!/usr/bin/python3
"""The command line: version, help, errors, overrides, output folders.

    command_line.py VALSALVA ROOT
"""
import pathlib
import subprocess
import sys
import tempfile

program, root = sys.argv[1], pathlib.Path(sys.argv[2])
found = []


def expect(arguments, code, words, where="stderr"):
    """`valsalva arguments` ends with `code` and says `words` on stdout or stderr."""
    result = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    said = getattr(result, where)
    if result.returncode != code or words not in said:
        found.append(f"valsalva {' '.join(map(str, arguments))}: exit code {result.returncode}, expected {code} and "
                     f"'{words}'\n{result.stdout}{result.stderr}")


with tempfile.TemporaryDirectory() as scratch:
    occupied = pathlib.Path(scratch, "occupied")
    occupied.mkdir()
    (occupied / "thesis.tex").write_text("years of work")
    template = pathlib.Path(scratch, "template.toml")
    template.write_text(subprocess.run([program, "keys"], capture_output=True, text=True, check=True).stdout)
    root_case = root / "cases" / "aortic_root"

    expect(["--version"], 0, "SUNDIALS", "stdout")
    expect(["--help"], 0, "check", "stdout")
    expect([], 2, "subcommand")
    expect(["rnu", root_case], 2, "no command 'rnu'; did you mean 'run'?")
    expect(["run", root_case, "--sett", "a=b"], 2, "--sett")
    expect(["check", "/no/such/case.toml"], 4, "/no/such/case.toml")
    expect(["keys"], 0, "finest_cm = 0.104167", "stdout")
    expect(["check", template], 2, "time.end_s: missing")
    expect(["check", root_case, "--set", "grid.finnest_cm=0.1"], 2, "did you mean 'finest_cm'?")
    expect(["check", root_case, "--set", "element.arteries.Rp_mmHg_s_ml=-1"], 2, "element.arteries.Rp_mmHg_s_ml")
    expect(["run", root_case, "-o", occupied], 2, "is not empty")
    expect(["run", root_case, "-o", occupied, "--force"], 2, "holds no run of Valsalva")
    if not (occupied / "thesis.tex").exists():
        found.append("--force removed a folder that is not the output of a run")

print("\n".join(found))
sys.exit(1 if found else 0)
