"""The animation of the valve: small images of the leaflets from above and from the side and of the speed on the mid-plane.

Leaflet images follow the frames in structure/, speed images the less frequent ones in fields/. Each leaflet frame is shown
with the speed frame nearest in time.
"""
from dataclasses import dataclass, field

import matplotlib
import numpy as np
from matplotlib.colors import Normalize
from PIL import Image, ImageDraw, ImageFont

from drawing import style
from drawing.instants import main_flow
from drawing.midplane import cut_at, read_plane, structure_and_axis, wall_near
from drawing.run_output import Fibers, Missing, leaflet_frames, read_series, read_table, wall_points
from drawing.scene import VIEWS, Scene, leaflet_points

MOST_FRAMES = 120
WIDTH, PLANE_WIDTH = 340, 700    # pixels
GIF_FRAMES, GIF_WIDTH = 60, 560


@dataclass
class Movie:
    times: list = field(default_factory=list)        # s, one per frame of the leaflets
    views: dict = field(default_factory=dict)        # "above", "side" -> [Image], one per time
    plane: list = field(default_factory=list)        # [Image]
    plane_times: list = field(default_factory=list)
    nearest: list = field(default_factory=list)      # index into plane, one per time
    fastest: float = 0.0                             # cm/s at the end of the colour scale


def film(out):
    """The movie of the run in `out`, from all its frames or every n-th; Missing without leaflets."""
    frames = every_nth(leaflet_frames(out), MOST_FRAMES)
    fibers = [Fibers(path) for _, path in frames]
    if not len(leaflet_points(fibers[0])):
        raise Missing("the files in structure/ have no group named leaflet")
    wall = wall_points(out)
    movie = Movie(times=[t for t, _ in frames])
    for view in VIEWS:
        scene = Scene(view, fibers, wall)
        movie.views[view] = [scene.image(f, WIDTH) for f in fibers]
    try:
        _film_plane(out, movie)
    except Missing:
        pass
    return movie


def every_nth(items, most):
    return items[::-(-len(items) // most)]


def _film_plane(out, movie):
    frames = every_nth(read_series(out / "fields"), MOST_FRAMES)
    structure, y = structure_and_axis(out)
    wall = wall_near(out, y)
    movie.plane_times = [t for t, _ in frames]
    grids = [_uniform(read_plane(path, y)[0]) for _, path in frames]
    movie.fastest = float(max(np.percentile(speed, 99.9) for speed, _, _ in grids)) or 1.0
    shade = Normalize(0, movie.fastest, clip=True)
    for t, (speed, z, x) in zip(movie.plane_times, grids):
        low, high = (x[0], x[1]) if wall is None else (wall[:, 0].min() - 0.3, wall[:, 0].max() + 0.3)
        scale = PLANE_WIDTH / (z[1] - z[0])
        image = Image.fromarray((255 * style.SPEED(shade(speed[::-1]))[:, :, :3]).astype(np.uint8))
        image = image.resize((PLANE_WIDTH, round(scale * (x[1] - x[0]))), Image.BILINEAR)
        brush = ImageDraw.Draw(image)
        for points, reach, color in ((wall, 0.8, "#8a8a8a"), (cut_at(structure, t, y), 1.4, "#111111")):
            for px, pz in [] if points is None else points[:, [0, 2]]:
                at = np.array([pz - z[0], x[1] - px]) * scale
                brush.ellipse((*(at - reach), *(at + reach)), fill=color)
        movie.plane.append(image.crop((0, round(scale * (x[1] - high)), PLANE_WIDTH, round(scale * (x[1] - low)))))
    movie.nearest = [int(np.argmin(np.abs(np.array(movie.plane_times) - t))) for t in movie.times]


def _uniform(patches):
    """(speed [x, z], z range, x range) of all levels at the spacing of the finest."""
    z, x = ((min(getattr(p, d)[0] for p in patches), max(getattr(p, d)[1] for p in patches)) for d in "zx")
    h = min(p.h for p in patches)
    whole = np.zeros([round((b - a) / h) for a, b in (x, z)])
    for patch in patches:
        n = round(patch.h / h)
        i, k = round((patch.x[0] - x[0]) / h), round((patch.z[0] - z[0]) / h)
        fine = np.kron(patch.speed, np.ones((n, n)))
        whole[i:i + fine.shape[0], k:k + fine.shape[1]] = fine
    return whole, z, x


def save_gif(out, movie, path):
    """Writes an animated GIF: both views, the speed, and a marker on the flow curve."""
    table = read_table(out / "openings.csv")
    t, q = table["t_s"], main_flow(table)[1]
    font = ImageFont.truetype(matplotlib.get_data_path() + "/fonts/ttf/DejaVuSans.ttf", 13)
    images = [_still(movie, i, t, q, font) for i in every_nth(range(len(movie.times)), GIF_FRAMES)]
    palette = images[len(images) // 3].quantize(96)
    images = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    part = path.with_name("." + path.name)
    images[0].save(part, format="GIF", save_all=True, append_images=images[1:], duration=70, loop=0, optimize=True)
    part.replace(path)


def _still(movie, i, t, q, font):
    half, strip = GIF_WIDTH // 2, 70
    views = [_scaled(movie.views[v][i], half - 10) for v in ("above", "side")]
    plane = [_scaled(movie.plane[movie.nearest[i]], GIF_WIDTH)] if movie.plane else []
    top = max(v.height for v in views)
    canvas = Image.new("RGB", (GIF_WIDTH, 24 + top + sum(p.height for p in plane) + strip + 16), "white")
    brush = ImageDraw.Draw(canvas)
    brush.text((8, 6), f"{movie.times[i]:.2f} s", fill=style.INK, font=font)
    for k, view in enumerate(views):
        canvas.paste(view, (5 + k * half, 24 + (top - view.height) // 2))
    for image in plane:
        canvas.paste(image, (0, 24 + top))
    low, high = canvas.height - 6, canvas.height - 6 - strip
    place = lambda time, flow: (8 + (GIF_WIDTH - 16) * (time - t[0]) / (t[-1] - t[0]),  # noqa: E731
                                low + (high - low) * (flow - q.min()) / max(np.ptp(q), 1e-9))
    brush.line([place(t[0], 0), place(t[-1], 0)], fill="#cccccc")
    brush.line([place(*pair) for pair in zip(t, q)], fill=style.INK, width=2)
    x, y = place(movie.times[i], np.interp(movie.times[i], t, q))
    brush.ellipse((x - 5, y - 5, x + 5, y + 5), fill=style.VENTRICLE)
    return canvas


def _scaled(image, width):
    return image.resize((width, round(image.height * width / image.width)), Image.LANCZOS)
