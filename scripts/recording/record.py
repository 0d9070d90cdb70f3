"""Runs the recipes on one build and keeps what they write and print.

    OUT/record.json              of what the recording was made
    OUT/<recipe>.ranks_<n>/      the output folders; for every command NN_<verb>.stdout, .stderr, .json (its exit code)
"""
import json
import os
import platform
import re
import shutil
import subprocess
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from fnmatch import fnmatch
from pathlib import Path

from recording.comparison import compare_folders
from recording.inputs import write_inputs
from recording.recipes import recipes

PATIENCE_S = 300
MPI = {"OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
       "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}


class Recording:
    def __init__(self, tree, out, program, measured, jobs):
        self.tree, self.out, self.program, self.measured, self.jobs = tree.resolve(), out, program.resolve(), measured, jobs
        self.said = threading.Lock()
        self.done, self.wrong = 0, []

    def prepare(self):
        """An empty folder, or one that a recording may replace."""
        if self.out.exists():
            if any(self.out.iterdir()) and not (self.out / "record.json").is_file():
                raise SystemExit(f"same_numbers: {self.out} holds something other than a recording; name another folder")
            shutil.rmtree(self.out)
        self.out.mkdir(parents=True)
        (self.out / "tree").symlink_to(self.tree)
        write_inputs(self.out / "inputs", self.measured)

    def run(self, only, rank_counts):
        begun = time.time()
        self.prepare()
        work = [(recipe, n) for n in rank_counts for recipe in recipes(self.tree, n, self.measured is not None)
                if fnmatch(recipe.name, only)]
        self.total = len(work)
        self.write_record(begun, work)
        for n in rank_counts:  # recipes of few ranks beside each other
            with ThreadPoolExecutor(max(1, self.jobs // n)) as pool:
                list(pool.map(lambda one: self.run_recipe(*one), [w for w in work if w[1] == n]))
        self.write_record(begun, work)
        print(f"{self.total} recipes recorded in {time.time() - begun:.0f} s; {len(self.wrong)} did not end as they should")
        return 1 if self.wrong else 0

    def write_record(self, begun, work):
        commit = subprocess.run(["git", "-C", self.tree, "rev-parse", "HEAD"], capture_output=True, text=True).stdout.strip()
        (self.out / "record.json").write_text(json.dumps({
            "program": str(self.program), "tree": str(self.tree), "commit": commit, "host": platform.node(),
            "begun": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(begun)), "seconds": round(time.time() - begun),
            "recipes": [f"{recipe.name}.ranks_{n}" for recipe, n in work], "wrong": self.wrong}, indent=1) + "\n")

    def run_recipe(self, recipe, ranks):
        folder = self.out / f"{recipe.name}.ranks_{ranks}"
        folder.mkdir()
        begun, wrong = time.time(), []
        for number, command in enumerate(recipe.commands, 1):
            code = self.run_command(folder, number, command, command.ranks or ranks)
            if code != command.exit_code:
                wrong.append(f"exit code {code} of {number:02}_{command.words[0]}, expected {command.exit_code}")
                break
            for file, pattern, replacement in recipe.edits if number == 1 else ():
                text, count = re.subn(pattern, replacement, (folder / file).read_text())
                (folder / file).write_text(text)
                wrong += [] if count else [f"no '{pattern}' in {file}"]
        if recipe.same and not wrong:
            found = compare_folders(*(folder / name for name in recipe.same), ignore=["log.txt"])
            differences = [f for f in found if f.fails]
            (folder / "continuation.json").write_text(json.dumps({"differences": len(differences)}) + "\n")
            wrong += [f"{recipe.same[1]} is not {recipe.same[0]}: {f}" for f in differences[:5]]
        with self.said:
            self.done += 1
            self.wrong += [f"{folder.name}: {what}" for what in wrong]
            print(f"[{self.done:3}/{self.total}] {folder.name:<44} {time.time() - begun:5.1f} s", flush=True)
            for what in wrong:
                print(f"          WRONG: {what}", flush=True)

    def run_command(self, folder, number, command, ranks):
        name = f"{number:02}_{command.words[0]}"
        launcher = ["mpirun", "-np", str(ranks), "--bind-to", "none", "--quiet"] if ranks > 1 else []
        with open(folder / f"{name}.stdout", "w") as out, open(folder / f"{name}.stderr", "w") as error:
            try:
                code = subprocess.run([*launcher, self.program, *command.words], cwd=folder, stdin=subprocess.DEVNULL,
                                      stdout=out, stderr=error, env={**os.environ, **MPI}, timeout=PATIENCE_S).returncode
            except subprocess.TimeoutExpired:
                code = -1
        (folder / f"{name}.json").write_text(json.dumps({"exit_code": code}) + "\n")
        return code


def record(tree, out, program=None, only="*", ranks=(1, 2), measured=None, jobs=None):
    """Records one build; 0 if every command ended as it should."""
    tree = Path(tree)
    program = Path(program) if program else tree / "build" / "release" / "valsalva"
    measured = Path(measured) if measured else tree.resolve().parent / "shared" / "data" / "human_type_a_beat.csv"
    for path in [tree / "cases", program]:
        if not path.exists():
            raise SystemExit(f"same_numbers: {path} does not exist")
    if not measured.is_file():
        print(f"no measured beat at {measured}: its fits are left out (--measured FILE)")
        measured = None
    return Recording(tree, Path(out), program, measured, jobs or os.cpu_count()).run(only, sorted(ranks))
