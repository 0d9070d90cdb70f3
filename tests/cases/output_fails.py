#!/usr/bin/python3
"""Output that cannot be written ends a run with one sentence that names the file, exit code 4, and a record that says so.

    output_fails.py VALSALVA ROOT full_disk     a 3D run on a file system of a few MB; skipped (77) where none can be mounted
    output_fails.py VALSALVA ROOT limited       files that may not outgrow a limit; log and terminal on a full device
    output_fails.py VALSALVA ROOT one_rank      what fails on one of two ranks
"""
import contextlib
import json
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

program, root, scenario = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
SKIPPED = 77
ON_TWO_RANKS = ["mpirun", "-np", "2", "--bind-to", "none"]
COARSE = {"grid.finest_cm": 0.25, "output.fields_every_s": 0, "output.structure_every_s": 0, "checkpoint.every_wall_s": 0,
          "time.end_s": 0.03, "time.period_s": 0.8}
FIT = """extends = "{}/cases/lumped_heart/case.toml"
[fit]
data = "beat.csv"
[[fit_parameter]]
name = "Rp"
parameter = "arteries.Rp_mmHg_s_ml"
[[fit_signal]]
name = "p_ao_mmHg"
observable = "p_ao_mmHg"
"""
found = []


def words(case, out, changes=()):
    given = [program, "run", str(root / "cases" / case), "-o", str(out)]
    for key, value in {"output.pictures": "false", **dict(changes)}.items():
        given += ["--set", f"{key}={value}"]
    return given


def expect(holds, message):
    if not holds:
        found.append(message)


def run(command, stdout=subprocess.PIPE):
    return subprocess.run(command, stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=100)


def run_limited(command, out, largest_file):
    """Once it is under way no file may grow beyond `largest_file` bytes (MPI needs larger ones to start)."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    while not (out / "run.json").exists() and process.poll() is None:
        time.sleep(0.001)
    resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (largest_file, largest_file))
    said = process.communicate(timeout=100)[1]
    return subprocess.CompletedProcess(command, process.returncode, "", said)


def expect_failure(done, said, out=None):
    """One sentence with the words `said`, exit code 4, and nothing left that is torn or out of date."""
    sentences = [line for line in done.stderr.splitlines() if line.startswith("valsalva: ")]
    expect(done.returncode == 4, f"exit code {done.returncode}\n{done.stderr}")
    expect(len(sentences) == 1 and said in sentences[0], f"not one sentence with '{said}':\n{done.stderr}")
    expect("Segmentation" not in done.stderr, done.stderr)
    if out is None or not (out / "run.json").exists():
        expect(out is None, "no run.json")
        return
    outcome = json.loads((out / "run.json").read_text())["outcome"]
    expect(outcome == "failed", f"run.json says {outcome}")
    expect(not list(out.rglob("*.part")), f"left behind: {list(out.rglob('*.part'))}")
    for table in out.glob("*.csv"):
        lines = table.read_text().split("\n")
        expect(lines[-1] == "" and len({line.count(",") for line in lines[:-1]}) == 1, f"{table.name} ends in a torn row")


@contextlib.contextmanager
def small_disk(folder, kilobytes):
    folder.mkdir(exist_ok=True)
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", folder],
                             capture_output=True, text=True)
    if mounted.returncode != 0:
        print(f"skipped: a small file system cannot be mounted here: {mounted.stderr.strip()}")
        sys.exit(SKIPPED)
    try:
        yield folder
    finally:
        subprocess.run(["umount", folder], check=True)


def full_disk(scratch):
    """Wherever the disk runs full: in run.json, in a field, in a checkpoint; on one rank and on two; in a fit."""
    fields = COARSE | {"output.fields_every_s": 0.001, "time.end_s": 0.002}
    for kilobytes, changes, what in [(40, fields, "run.json"), (1000, fields, "/fields_000"),
                                     (4000, COARSE | {"time.end_s": 0.002, "grid.finest_cm": 0.208333}, "/checkpoint_")]:
        for launcher in [[], ON_TWO_RANKS]:
            with small_disk(scratch / "disk", kilobytes) as disk:
                expect_failure(run(launcher + words("aortic_root", disk / "out", changes)), what, disk / "out")
    (scratch / "beat.csv").write_text("t_s,p_ao_mmHg\n" + "".join(f"{0.01 * n:.2f},{90 + n}\n" for n in range(80)))
    (scratch / "fit.toml").write_text(FIT.format(root))
    for kilobytes, what in [(8, "case.resolved.toml"), (24, "fit.json"), (28, "fit.csv"), (32, "log.txt")]:
        with small_disk(scratch / "disk", kilobytes) as disk:
            expect_failure(run([program, "fit", str(scratch / "fit.toml"), "-o", str(disk / "fit")]),
                           f"cannot write '{disk}/fit/{what}': No space left on device")


def limited(scratch):
    """Files that may not outgrow a limit; a terminal and a log on a device that is full."""
    out = scratch / "heart"
    done = run_limited(words("lumped_heart", out, {"time.end_s": 4000}), out, 40000)
    expect_failure(done, f"cannot write '{out}/openings.csv': File too large", out)
    with open("/dev/full", "w") as full:
        expect_failure(run(words("lumped_heart", scratch / "mute", {"time.end_s": 0.8}), stdout=full),
                       "cannot write to the terminal: No space left on device", scratch / "mute")
        for command in ["check", str(root / "cases" / "lumped_heart")], ["keys"]:
            expect_failure(run([program, *command], stdout=full), "No space left on device")

    out = scratch / "root"
    for changes, what in [({"output.fields_every_s": 0.001}, "/fields_"), ({}, "/checkpoint_")]:
        shutil.rmtree(out, ignore_errors=True)
        expect_failure(run_limited(words("aortic_root", out, COARSE | changes), out, 100000), what, out)
    done = run(words("aortic_root", out, COARSE | {"time.end_s": 0.001}) + ["--force"])
    expect(done.returncode == 0, done.stderr)
    (out / "log.txt").unlink()
    (out / "log.txt").symlink_to("/dev/full")
    expect_failure(run(words("aortic_root", out, COARSE) + ["--restart", "latest"]),
                   f"cannot write '{out}/log.txt': No space left on device", out)


def one_rank(scratch):
    """Rank 0 alone makes folders; a rank that cannot read the case leaves the others in vain."""
    out = scratch / "out"
    case = words("aortic_root", out, COARSE | {"time.end_s": 0.001})
    expect(run(ON_TWO_RANKS + case).returncode == 0, "no run to continue")
    for folder in ["fields", "checkpoints"]:
        kept = out / f"{folder}.kept"
        (out / folder).rename(kept)
        (out / folder).write_text("no folder")
        last = max((kept if folder == "checkpoints" else out / "checkpoints").glob("*.h5"))
        expect_failure(run(ON_TWO_RANKS + case + ["--restart", str(last)]), f"{out}/{folder}]")
        (out / folder).unlink()
        kept.rename(out / folder)
    missing = words("aortic_root/missing.toml", scratch / "other")
    other = words("aortic_root", scratch / "other", COARSE)
    for a, b in [(other, missing), (missing, other)]:
        expect_failure(run(["mpirun", "--bind-to", "none", "-np", "1", *a, ":", "-np", "1", *b]), "missing.toml")


with tempfile.TemporaryDirectory() as folder:
    {"full_disk": full_disk, "limited": limited, "one_rank": one_rank}[scenario](pathlib.Path(folder))
print("\n".join(found))
sys.exit(1 if found else 0)
