"""HTML of a report: one self-contained file that loads nothing from outside."""
import base64
import html
import io
import json
from pathlib import Path

import numpy as np
from matplotlib.colors import to_hex
from PIL import Image

from drawing import style

HERE = Path(__file__).resolve().parent


def text(words):
    return html.escape(str(words))


def data_uri(image, quality=82):
    """An image or a picture file as a data: URI; SVG stays SVG, everything else becomes WebP."""
    if isinstance(image, Path) and image.suffix == ".svg":
        return "data:image/svg+xml;base64," + base64.b64encode(image.read_bytes()).decode()
    if isinstance(image, Path):
        image = Image.open(image).convert("RGB")
    buffer = io.BytesIO()
    image.save(buffer, format="WEBP", quality=quality, method=4)
    return "data:image/webp;base64," + base64.b64encode(buffer.getvalue()).decode()


def figure(image, title, caption):
    """A picture with title and caption below it."""
    return (f'<figure><img alt="{text(title)}" src="{data_uri(image)}">'
            f"<figcaption><b>{text(title)}.</b> {text(caption)}</figcaption></figure>")


def grid(parts):
    return f'<div class="grid">{"".join(parts)}</div>' if parts else ""


def columns(figures):
    """Figures of different heights, set in columns."""
    return f'<div class="columns">{"".join(figures)}</div>' if figures else ""


def section(title, *parts):
    """A section, or nothing if all its parts are empty."""
    body = "".join(parts)
    return f"<section><h2>{text(title)}</h2>{body}</section>" if body else ""


def sentences(said, style_name=""):
    return f'<p class="{style_name}">{text(" ".join(said))}</p>' if said else ""


def table(head, rows, style_name=""):
    """`rows` of cells; a cell is text, or (text, class)."""
    def cell(value):
        words, mark = value if isinstance(value, tuple) else (value, "")
        return f'<td class="{mark}">{text(words)}</td>'
    top = "".join(f"<th>{text(h)}</th>" for h in head)
    body = "".join("<tr>" + "".join(map(cell, row)) + "</tr>" for row in rows)
    return f'<div class="wide"><table class="{style_name}"><tr>{top}</tr>{body}</table></div>'


def bars(rows):
    """[(label, share from 0 to 1, words)] as horizontal bars."""
    return '<div class="split">' + "".join(
        f'<span>{text(label)}</span><div><div class="bar" style="width:{100 * share:.1f}%"></div></div>'
        f"<span>{text(words)}</span>" for label, share, words in rows) + "</div>"


def movie_player(movie, t, q):
    """The player: images of every frame, and the flow q(t) with a cursor; starts at peak flow."""
    start = int(np.argmax(np.interp(movie.times, t, q)))
    across = 1000 * (np.array(movie.times) - t[0]) / (t[-1] - t[0])
    data = {"times": movie.times, "plane_times": movie.plane_times, "nearest": movie.nearest,
            "x": across.round(1).tolist(), "plane": [data_uri(i, 74) for i in movie.plane]}
    data |= {view: [data_uri(i, 74) for i in images] for view, images in movie.views.items()}
    shown = {view: data[view][start] for view in movie.views}
    thin = np.unique(np.linspace(0, len(t) - 1, 900).astype(int))
    height = 92 - 84 * (q - q.min()) / max(np.ptp(q), 1e-9)
    curve = "M" + "L".join(f"{1000 * (t[i] - t[0]) / (t[-1] - t[0]):.1f} {height[i]:.1f}" for i in thin)
    zero = 92 - 84 * (0 - q.min()) / max(np.ptp(q), 1e-9)
    plane = ""
    if movie.plane:
        plane = (f'<figure><img id="plane" alt="speed on the mid-plane" src="{data["plane"][movie.nearest[start]]}">'
                 '<div class="scale"></div>'
                 f'<div class="ends"><span>0</span><span>speed</span><span>{movie.fastest:.0f} cm/s</span></div>'
                 '<figcaption>Mid-plane, flow from left to right, at <span id="plane_time"></span></figcaption>'
                 "</figure>")
    return f"""<div id="movie"><div class="views">
<figure><img id="above" alt="leaflets from above" src="{shown["above"]}">
<figcaption>From the aorta</figcaption></figure>
<figure><img id="side" alt="leaflets from the side" src="{shown["side"]}">
<figcaption>From the side</figcaption></figure>
{plane}</div>
<svg viewBox="0 0 1000 100" preserveAspectRatio="none" role="img" aria-label="flow over time">
<path d="M0 {zero:.1f}H1000" stroke="#ccc" fill="none" vector-effect="non-scaling-stroke"/>
<path d="{curve}" stroke="#222" stroke-width="1.6" fill="none" vector-effect="non-scaling-stroke"/>
<path id="cursor" d="M{across[start]:.1f} 0V100" stroke="#c8443c" stroke-width="2" fill="none"
 vector-effect="non-scaling-stroke"/></svg>
<div class="control"><button id="play" type="button">Play</button><input id="frame" type="range" min="0"
 max="{len(movie.times) - 1}" value="{start}" aria-label="frame">
<output id="time">{movie.times[start]:.3f} s</output></div>
</div><script type="application/json" id="frames">{json.dumps(data)}</script>
<script>{(HERE / "movie.js").read_text()}</script>"""


def page(title, body):
    stops = ", ".join(to_hex(style.SPEED(v)) for v in np.linspace(0, 1, 9))
    css = (HERE / "style.css").read_text().replace("SPEED_STOPS", stops)
    return (f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><title>{text(title)}</title>'
            f"<style>{css}</style></head><body>{body}</body></html>\n")


def write(path, content):
    """Writes under a temporary name and renames, so that a browser never sees an incomplete page."""
    part = path.with_name(f".{path.name}.part")
    part.write_text(content)
    part.replace(path)
