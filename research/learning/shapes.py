"""Makes figures of simple shapes, as a child draws them, whose parts are known: bodies, heads, limbs."""

import pathlib
import sys

import numpy as np
from PIL import Image, ImageDraw
from scipy import ndimage

sys.path.append(str(pathlib.Path(__file__).parent.parent / "corpus"))
import manners


def oval(centre, radii, angle):
    turns = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    x, y = radii[0] * np.cos(turns), radii[1] * np.sin(turns)
    c, s = np.cos(angle), np.sin(angle)
    return np.column_stack([centre[0] + c * x - s * y, centre[1] + s * x + c * y])


def box(centre, radii, angle):
    x, y = radii[0] * np.array([-1, 1, 1, -1]), radii[1] * np.array([-1, -1, 1, 1])
    c, s = np.cos(angle), np.sin(angle)
    return np.column_stack([centre[0] + c * x - s * y, centre[1] + s * x + c * y])


def limb(start, angle, length, widths, bend):
    """Returns a tube and the cap at its end; it begins at `start` and bends by an angle on its way."""
    turns = angle + bend * np.linspace(0, 1, 20)
    steps = length / 20 * np.column_stack([np.cos(turns), np.sin(turns)])
    middle = start + np.cumsum(steps, axis=0)
    across = np.column_stack([-np.sin(turns), np.cos(turns)]) * np.linspace(*widths, 20)[:, None]
    cap = oval(middle[-1], (widths[1], widths[1]), 0)
    return [np.vstack([middle + across, (middle - across)[::-1]]), cap]


def polygons(rng):
    """Returns the parts of a figure, back to front, each a list of polygons in the unit square."""
    centre = rng.uniform(0.42, 0.58, 2)
    radii = rng.uniform(0.12, 0.28, 2)
    body = (oval if rng.random() < 0.75 else box)(centre, radii, rng.uniform(-0.3, 0.3))
    behind, before = [], []
    for _ in range(int(rng.integers(0, 6))):
        way = rng.uniform(0, 2 * np.pi)
        start = centre + 0.75 * radii * [np.cos(way), np.sin(way)]
        wide = rng.uniform(0.015, 0.06)
        widths = wide, wide * rng.uniform(0.5, 1.2)
        arm = limb(start, way + rng.normal(0, 0.4), rng.uniform(0.1, 0.35), widths, rng.normal(0, 0.8))
        (behind if rng.random() < 0.5 else before).append(arm)
    if rng.random() < 0.7:
        add_head(centre, radii, behind, before, rng)
    return [*behind, [body], *before]


def add_head(centre, radii, behind, before, rng):
    """Adds a head at the upper side of a body, some with ears or eyes."""
    way = rng.uniform(-np.pi, 0)
    middle = centre + radii * [np.cos(way), np.sin(way)]
    size = rng.uniform(0.07, 0.18)
    if rng.random() < 0.6:
        for turn in (-2.2, -0.9):
            tip = middle + size * np.array([np.cos(turn), np.sin(turn)])
            behind.append([oval(tip, rng.uniform(0.2, 0.6, 2) * size, turn)])
    before.append([oval(middle, (size, size * rng.uniform(0.8, 1.2)), 0)])
    if rng.random() < 0.5:
        eyes = [middle + [side * 0.4 * size, -0.1 * size] for side in (-1, 1)]
        before.extend([oval(eye, (0.15 * size, 0.2 * size), 0)] for eye in eyes)


def figure(rng, side):
    """Returns a manners.Figure of the given side, with or without outlines."""
    shapes = polygons(rng)
    parts = np.zeros((side, side), int)
    rgb = np.full((side, side, 3), 255.0)
    pen = rng.choice([0, 0, 0.006, 0.012]) * side
    tint = rng.uniform(0, 255, 3)
    for k, shape in enumerate(shapes):
        drawn = Image.new("1", (side, side))
        for outline in shape:
            ImageDraw.Draw(drawn).polygon([(side * x, side * y) for x, y in outline], fill=1)
        inside = np.asarray(drawn)
        colour = np.clip(tint + rng.normal(0, 60, 3), 0, 255) if rng.random() < 0.8 else rng.uniform(0, 255, 3)
        if rng.random() < 0.1:
            colour = np.full(3, rng.uniform(225, 255))
        parts[inside] = k + 1
        rgb[inside] = colour
        if pen > 0:
            near = ndimage.distance_transform_edt(inside)
            rgb[inside & (near <= pen)] = manners.INK
    # Parts that are hidden leave no number behind.
    _, parts = np.unique(np.append(parts.ravel(), 0), return_inverse=True)
    parts = parts[:-1].reshape(side, side)
    rows, columns = np.nonzero(parts)
    window = np.s_[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
    parts, rgb = parts[window], rgb[window]
    return manners.Figure(rgb, (parts > 0).astype(float), parts)
