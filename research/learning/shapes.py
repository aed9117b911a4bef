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


def stick_figure(rng):
    """Returns the limbs, as one part, and the head of a figure whose limbs are single strokes."""
    neck = np.array([0.5, 0.3])
    wide = rng.uniform(0.003, 0.012)
    hip = neck + [rng.normal(0, 0.03), rng.uniform(0.15, 0.35)]
    size = rng.uniform(0.05, 0.12)

    def stroke(start, way, length):
        return limb(start, way, length, (wide, wide), rng.normal(0, 0.6))

    limbs = limb(neck, np.arctan2(*(hip - neck)[::-1]), np.hypot(*(hip - neck)), (wide, wide), 0)
    shoulder = neck + rng.uniform(0.1, 0.4) * (hip - neck)
    for side in (0, np.pi):
        limbs += stroke(shoulder, side + rng.uniform(-1.2, 1.2), rng.uniform(0.15, 0.3))
        limbs += stroke(hip, np.pi / 2 + (side - np.pi / 2) * rng.uniform(0.2, 0.6), rng.uniform(0.2, 0.35))
    return limbs, [oval(neck - [0, size], (size, size * rng.uniform(0.9, 1.2)), 0)]


def polygons(rng):
    """Returns the parts of a figure, back to front, each a list of polygons in the unit square, and the
    roots of limbs in front: pairs of a point and half of the limb's width."""
    centre = rng.uniform(0.42, 0.58, 2)
    radii = rng.uniform(0.12, 0.28, 2)
    body = (oval if rng.random() < 0.75 else box)(centre, radii, rng.uniform(-0.3, 0.3))
    behind, before, roots = [], [], []
    for _ in range(int(rng.integers(0, 6)) if rng.random() < 0.8 else 0):
        way = rng.uniform(0, 2 * np.pi)
        start = centre + 0.75 * radii * [np.cos(way), np.sin(way)]
        wide = rng.uniform(0.015, 0.06)
        widths = wide, wide * rng.uniform(0.5, 1.2)
        arm = limb(start, way + rng.normal(0, 0.4), rng.uniform(0.1, 0.35), widths, rng.normal(0, 0.8))
        if rng.random() < 0.5:
            behind.append(arm)
        else:
            before.append(arm)
            roots.append((start, wide))
    if rng.random() < 0.65:
        add_head(centre, radii, behind, before, rng)
    return [*behind, [body], *before], roots


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


def numbered(parts):
    """Numbers parts from 1 on. Those that are hidden leave no number behind."""
    _, numbers = np.unique(np.append(parts.ravel(), 0), return_inverse=True)
    return numbers[:-1].reshape(parts.shape)


def figure(rng, side):
    """Returns a manners.Figure of the given side, with or without outlines, the roots of its limbs, px, and
    whether its limbs are single strokes."""
    is_stick = rng.random() < 0.15
    shapes, roots = (stick_figure(rng), []) if is_stick else polygons(rng)
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
        if is_stick and k == 0:
            colour = manners.INK
        parts[inside] = k + 1
        rgb[inside] = colour
        if pen > 0:
            near = ndimage.distance_transform_edt(inside)
            rgb[inside & (near <= pen)] = manners.INK
    rows, columns = np.nonzero(parts)
    first = np.array([columns.min(), rows.min()])
    window = np.s_[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
    parts, rgb = numbered(parts[window]), rgb[window]
    roots = [(side * point - first, side * wide) for point, wide in roots]
    return manners.Figure(rgb, (parts > 0).astype(float), parts), roots, is_stick


def erase(edges, point, reach):
    rows, columns = np.indices(edges.shape)
    edges[np.hypot(columns - point[0], rows - point[1]) < reach] = False


def on_larger(picture, parts, rng):
    """Lays a page on a larger white or transparent canvas."""
    pads = [tuple(rng.integers(0, round(0.4 * length) + 1, 2)) for length in parts.shape]
    alpha = np.pad(np.full(parts.shape, 255, np.uint8), pads)
    picture = np.pad(picture, [*pads, (0, 0)], constant_values=255)
    return picture if rng.random() < 0.5 else np.dstack([picture, alpha]), np.pad(parts, pads)


def drawn_by_hand(figure, roots, is_stick, rng):
    """Draws a figure with any pen on any paper. Limbs are open where they begin, and lines have gaps."""
    figure = manners.with_margin(figure)
    border = round(manners.MARGIN * max(figure.parts.shape) / (1 + 2 * manners.MARGIN))
    pen = manners.pen_of(figure, np.exp(rng.uniform(np.log(0.003), np.log(0.04))))
    edges = manners.borders(figure.parts)
    inside = ndimage.binary_erosion(figure.parts > 0, iterations=2)
    if rng.random() < 0.5:
        for point, wide in roots:
            open_root = edges.copy()
            erase(open_root, point + border, 1.1 * wide)
            edges = np.where(inside, open_root, edges)
    rows, columns = np.nonzero(edges)
    for one in rng.choice(len(rows), 0 if is_stick else int(rng.integers(0, 4))):
        reach = max(pen, rng.uniform(0.005, 0.05) * figure.size)
        erase(edges, (columns[one], rows[one]), reach)
    if is_stick:
        edges |= figure.parts == 1
    cover = manners.strokes(edges, pen, rng.uniform(0, 0.003) * figure.size, rng)
    parts = manners.with_line(figure.parts, pen)
    if rng.random() < 0.2:
        ink = np.full(figure.rgb.shape, rng.choice([0, 30, 255]))
        return np.dstack([manners.as_picture(ink), manners.as_picture(255 * cover)]), parts
    paper = np.full(figure.rgb.shape, 255.0) * (rng.uniform(0.7, 1, 3) if rng.random() < 0.4 else 1)
    if rng.random() < 0.3:
        paper = manners.over(paper, figure.rgb, figure.alpha)
    picture = manners.as_picture(manners.over(paper, rng.uniform(0, 90, 3), cover))
    if rng.random() < 0.15:
        return on_larger(np.minimum(picture, int(rng.integers(215, 250))), parts, rng)
    return picture, parts
