"""Renders a page in headless Chromium: its width against that of the window, and whether all pictures load."""
import json
import re
import shutil
import subprocess
from pathlib import Path

PROBE = """<script>addEventListener("load", () => setTimeout(() => parent.postMessage({
  wide: document.documentElement.scrollWidth, broken: [...document.images].filter(i => !i.naturalWidth).length,
  pictures: document.images.length, time: document.getElementById("time")?.textContent ?? ""}, "*"), 300));</script>"""
FRAME = """<body style="margin:0"><iframe src="{page}" style="border:0;width:{width}px;height:{height}px"></iframe>
<pre id="answer"></pre><script>addEventListener("message", e => {{
document.getElementById("answer").textContent = JSON.stringify(e.data); }});</script></body>"""


def executable():
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def look(page, width, scratch, screenshot=None, height=4000):
    """{wide, broken, pictures, time} of `page` in a frame of `width` pixels; Chromium has a minimum window width, frames do not."""
    probed, frame = Path(scratch, "probed.html"), Path(scratch, "frame.html")
    probed.write_text(page.read_text().replace("</body>", PROBE + "</body>"))
    frame.write_text(FRAME.format(page=probed.as_uri(), width=width, height=height))
    command = [executable(), "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
               f"--user-data-dir={scratch}/profile", f"--window-size={max(width, 520)},{height}",
               "--virtual-time-budget=8000"]
    if screenshot:
        subprocess.run([*command, f"--screenshot={screenshot}", frame.as_uri()], capture_output=True, timeout=120)
    dom = subprocess.run([*command, "--dump-dom", frame.as_uri()], capture_output=True, text=True, timeout=120).stdout
    answer = re.search(r'id="answer">(.*?)</pre>', dom)
    return json.loads(answer.group(1)) if answer and answer.group(1) else {}
