"""The leaflets seen in parallel projection, as an image.

Every fibre is a broad pale stroke, which merges with its neighbours into a surface, and a thin line slightly nearer to the
eye. All strokes are drawn from far to near, so that near leaflets hide far ones.
"""
import numpy as np
from matplotlib.colors import to_rgb
from PIL import Image, ImageDraw

from . import style

MARGIN = 0.18  # cm around the drawing
SAMPLES = 2    # factor of supersampling, which smooths the edges

VIEWS = {  # name: right, up, towards the eye; distance of surfaces behind their lines in cm (more for steep ones)
    "above": ((1, 0, 0), (0, 1, 0), (0, 0, 1), 0.18),
    "side": ((1, 0, 0), (0, 0, 1), (0, -1, 0), 0.09),
}


def fit_annulus(fibers):
    """(centre (3), radius) of the circle through the attachment: the outline of the leaflets seen along the axis."""
    points = leaflet_points(fibers)
    middle = points[:, :2].mean(axis=0)
    angle = np.arctan2(*(points[:, :2] - middle).T[::-1])
    reach = np.linalg.norm(points[:, :2] - middle, axis=1)
    sector = np.digitize(angle, np.linspace(-np.pi, np.pi, 73))
    outline = np.array([points[sector == s][np.argmax(reach[sector == s]), :2] for s in np.unique(sector)])
    # x^2 + y^2 = 2 a x + 2 b y + c is linear in centre (a, b) and c = R^2 - a^2 - b^2
    a, b, c = np.linalg.lstsq(np.c_[2 * outline, np.ones(len(outline))], (outline ** 2).sum(axis=1), rcond=None)[0]
    return np.array([a, b, points[:, 2].min()]), float(np.sqrt(c + a * a + b * b))


def leaflet_points(fibers):
    return fibers.points[np.isin(fibers.group, fibers.groups_like("leaflet"))]


class Scene:
    """What the images of one view have in common: projection, limits in cm, annulus and a section of the wall."""

    def __init__(self, view, frames, wall):
        """`frames`: the structures to be shown; `wall`: its points (n, 3) or None."""
        self.right, self.up, self.eye = (np.array(v, float) for v in VIEWS[view][:3])
        self.delay = VIEWS[view][3]
        self.annulus, radius = fit_annulus(frames[0])
        moving = np.concatenate([leaflet_points(f) for f in frames])
        depth = moving @ self.eye
        self.far, self.depth = depth.min(), max(np.ptp(depth), 1e-9)
        angle = np.linspace(0, 2 * np.pi, 181)
        self.ring = self.annulus + radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
        self.section = np.zeros((0, 3))
        if view == "side" and wall is not None:
            at_valve = (wall[:, 2] > moving[:, 2].min() - MARGIN) & (wall[:, 2] < moving[:, 2].max() + 2 * MARGIN)
            self.section = wall[at_valve & (np.abs((wall - self.annulus) @ self.eye) < 0.05)]
        reach = self._flat(np.concatenate([moving, self.section, self.ring]))
        self.low = reach.min(axis=0) - [MARGIN, 2 * MARGIN]
        self.high = reach.max(axis=0) + MARGIN

    @property
    def size(self):
        return self.high - self.low

    @property
    def extent(self):
        return self.low[0], self.high[0], self.low[1], self.high[1]

    def image(self, fibers, width):
        """The leaflets as an RGB image of `width` pixels on white."""
        scale = SAMPLES * width / self.size[0]
        canvas = Image.new("RGB", tuple((self.size * scale).round().astype(int)), "white")
        brush = ImageDraw.Draw(canvas)
        hair = max(1, round(0.0035 * scale))
        for x, y in self._pixels(self.section, scale).tolist():
            brush.ellipse((x - 2 * hair, y - 2 * hair, x + 2 * hair, y + 2 * hair), fill="#a8a8a8")
        brush.line(self._pixels(self.ring, scale).ravel().tolist(), fill=style.GREY, width=3 * hair)
        broad = round(0.5 * self._spacing(fibers) * scale)
        for is_surface, color, (x0, y0, x1, y1) in self._strokes(fibers, scale):
            if is_surface:
                brush.line((x0, y0, x1, y1), fill=color, width=2 * broad)
                brush.ellipse((x0 - broad, y0 - broad, x0 + broad, y0 + broad), fill=color)
                brush.ellipse((x1 - broad, y1 - broad, x1 + broad, y1 + broad), fill=color)
            else:
                brush.line((x0, y0, x1, y1), fill=color, width=2 * hair)
        return canvas.resize((width, round(width * self.size[1] / self.size[0])), Image.LANCZOS)

    def _flat(self, points):
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def _pixels(self, points, scale):
        return self._flat(points) * [scale, -scale] + np.array([-self.low[0], self.high[1]]) * scale

    @staticmethod
    def _spacing(fibers):
        """Width of a broad stroke: the typical spacing of the fibres, cm."""
        ends = fibers.points[fibers.lines]
        return float(np.median(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))) if len(ends) else 0.0

    def _strokes(self, fibers, scale):
        """(whether it belongs to a surface, colour, ends in pixels) of every stroke, from far to near."""
        depths, colors, pixels = [], [], []
        for number, group in enumerate(fibers.groups_like("leaflet")):
            ends = fibers.points[fibers.lines_of(group)]
            depth = (ends @ self.eye).mean(axis=1)
            near = np.clip((depth - self.far) / self.depth, 0, 1)[:, None]
            ink = 1 - np.array(to_rgb(style.LEAFLETS[number % 3]))
            colors += [1 - (0.10 + 0.16 * near) * ink, 1 - (0.45 + 0.55 * near) * ink]
            depths += [depth, depth + self.delay]
            pixels += 2 * [self._pixels(ends, scale).reshape(-1, 4)]
        is_surface = np.concatenate([np.full(len(d), i % 2 == 0) for i, d in enumerate(depths)])
        order = np.argsort(np.concatenate(depths), kind="stable")
        colors = (255 * np.concatenate(colors)).round().astype(int)
        return zip(is_surface[order].tolist(), map(tuple, colors[order].tolist()),
                   np.concatenate(pixels)[order].tolist())
