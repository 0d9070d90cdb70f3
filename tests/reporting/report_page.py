#!/usr/bin/python3
"""The report of a synthetic run is complete and self-contained and shows the numbers of the run.

    report_page.py VALSALVA ROOT
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path

program, root = sys.argv[1], Path(sys.argv[2])
sys.path[:0] = [str(root / "scripts"), str(root / "tests" / "reporting")]
import example_run  # noqa: E402
from drawing import centre_line  # noqa: E402

found = []


def expect(truth, words):
    if not truth:
        found.append(words)


class Page(HTMLParser):
    """Collects what a page would load, and the balance of its opening and closing tags."""

    def __init__(self, text):
        super().__init__()
        self.sources, self.depth = [], 0
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.depth += tag not in ("meta", "img", "input", "path", "br")
        self.sources += [value for name, value in attributes
                         if name in ("src", "href", "srcset", "data", "action", "poster")]

    def handle_endtag(self, tag):
        self.depth -= tag != "path"


def page_of(out, code=0):
    """The text of the report that `valsalva report out` writes."""
    run = subprocess.run([program, "report", str(out)], capture_output=True, text=True)
    expect(run.returncode == code, f"report of {out.name}: exit code {run.returncode}\n{run.stdout}{run.stderr}")
    return (out / "report.html").read_text() if (out / "report.html").is_file() else ""


with tempfile.TemporaryDirectory() as scratch:
    whole, running, lumped = (Path(scratch, name) for name in ("whole", "running", "lumped"))
    example_run.write(whole)
    text = page_of(whole)
    page = Page(text)
    expect(page.depth == 0, f"{page.depth} elements of the page are not closed")
    expect(len(page.sources) >= 12, f"only {len(page.sources)} pictures")
    expect(all(s.startswith("data:image/") for s in page.sources), "a picture is not inside the page")
    expect(not re.search(r"https?://|url\(|@import|fetch\(|XMLHttp", text), "the page refers to an outside resource")
    frames = json.loads(re.search(r'id="frames">(.*?)</script>', text, re.DOTALL).group(1))
    expect(len(frames["times"]) == example_run.FRAMES, f"the scrubber has {len(frames['times'])} frames")
    for view in ("above", "side", "plane"):
        expect(len(set(frames[view])) > 6, f"the images of {view} do not move")
    expect(f"{example_run.FORWARD_ML - example_run.CLOSING_ML:.1f} ml" in text, "the stroke volume is missing")
    expect("Made up &lt;b&gt;&amp; more" in text, "the title is not escaped")
    for words in ("From the aorta", "Passive markers", "boxes of every refined level", "Computing time", "spread", "finest_cm = 0.1"):
        expect(words in text, f"'{words}' is missing")
    gif = (whole / "pictures" / "valve.gif").read_bytes()
    expect(gif[:6] == b"GIF89a", "valve.gif is no GIF")

    z, p = centre_line.read_line(whole / "fields" / "fields_0000.hdf")
    expect(len(z) == 20 and abs(p - 10 * z).max() < 1e-4, "the centre line is not the pressure 10 z of the finest level")

    example_run.write(running, outcome="running")
    text = page_of(running)
    expect("Still running" in text, "a running run is not reported as running")
    expect(f"{example_run.FORWARD_ML:.1f} ml" in text, "no statistics during the first beat")

    example_run.write(lumped)
    for name in ("fields", "structure"):
        shutil.rmtree(lumped / name)
    for name in ("probes.csv", "step.csv", "log.txt"):
        (lumped / name).unlink()
    text = page_of(lumped)
    expect("Pressures and flow" in text and "From the aorta" not in text, "the page of a 0D run is wrong")

    empty = Path(scratch, "empty")
    empty.mkdir()
    page_of(empty, code=4)

print("\n".join(found))
sys.exit(1 if found else 0)
