"""Manners in which a figure is painted as a flat drawing.

A manner takes a Figure and a random generator and returns a picture (uint8, H x W x 3 or 4) and the
map of visible parts that belongs to it (0: none, k + 1: part k).
"""

import dataclasses
import io

import numpy as np
from PIL import Image, ImageDraw
from scipy import ndimage

MARGIN = 0.08  # of paper around the figure, of its longest side
INK = np.array([28.0, 26.0, 30.0])


@dataclasses.dataclass
class Figure:
    rgb: np.ndarray  # H x W x 3, 0 to 255
    alpha: np.ndarray  # H x W, 0 to 1
    parts: np.ndarray  # H x W, 0: none, k + 1: part k

    @property
    def size(self):
        return max(self.parts.shape)


def with_margin(figure):
    border = round(MARGIN * figure.size)
    pad = [(border, border), (border, border)]
    return Figure(
        np.pad(figure.rgb, [*pad, (0, 0)], constant_values=255),
        np.pad(figure.alpha, pad),
        np.pad(figure.parts, pad),
    )


def over(ground, colour, cover):
    return ground * (1 - cover[..., None]) + colour * cover[..., None]


def as_picture(values):
    return np.clip(np.round(values), 0, 255).astype(np.uint8)


def noise(shape, scale, rng):
    """Returns smooth noise of unit deviation."""
    values = ndimage.gaussian_filter(rng.standard_normal(shape), scale)
    return values / max(values.std(), 1e-9)


def borders(parts):
    """Returns where a pixel differs from the one to the right or below."""
    edges = np.zeros(parts.shape, bool)
    edges[:-1] |= np.diff(parts, axis=0) != 0
    edges[:, :-1] |= np.diff(parts, axis=1) != 0
    return edges


def strokes(edges, width, wobble, rng):
    """Returns the cover, 0 to 1, of a pen of `width` px that follows edges, unsteady by `wobble` px."""
    far = ndimage.distance_transform_edt(~edges)
    if wobble > 0:
        shape = edges.shape
        rows, columns = np.mgrid[: shape[0], : shape[1]].astype(float)
        rows += wobble * noise(shape, shape[0] / 40, rng)
        columns += wobble * noise(shape, shape[0] / 40, rng)
        far = ndimage.map_coordinates(far, [rows, columns], order=1, mode="nearest")
    return np.clip(0.5 * width + 0.5 - far, 0, 1)


def pen_of(figure, share):
    return max(1.5, share * figure.size)


def with_line(parts, width):
    """Returns parts to which the outer half of a line of `width` px around the figure belongs."""
    far, nearest = ndimage.distance_transform_edt(parts == 0, return_indices=True)
    return np.where(far <= width / 2, parts[tuple(nearest)], 0)


def white(figure):
    return np.full(figure.rgb.shape, 255.0)


def painted(figure, _):
    figure = with_margin(figure)
    return as_picture(over(white(figure), figure.rgb, figure.alpha)), figure.parts


def mean_colours(figure):
    """Returns the picture in which each part has the mean of its colours."""
    flat = np.zeros(figure.rgb.shape)
    labels = np.arange(1, figure.parts.max() + 1)
    for channel in range(3):
        means = ndimage.mean(figure.rgb[..., channel], figure.parts, labels)
        flat[..., channel] = np.concatenate([[255], np.nan_to_num(means)])[figure.parts]
    return flat


def plain(figure, rng):
    """Paints parts in their mean colours, a little apart from each other, without outlines."""
    figure = with_margin(figure)
    flat = mean_colours(figure)
    shades = np.concatenate([[0], rng.uniform(-18, 18, figure.parts.max())])
    flat += shades[figure.parts][..., None]
    flat[figure.parts == 0] = 255
    return as_picture(flat), figure.parts


def inked(figure, share, rng, wobble=0.0, ground=None):
    cover = strokes(borders(figure.parts), pen_of(figure, share), wobble * figure.size, rng)
    return over(white(figure) if ground is None else ground, INK, cover)


def outlined(figure, ground, rng):
    """Draws a usual pen's outlines on a ground, with the parts that hold their line."""
    parts = with_line(figure.parts, pen_of(figure, 0.005))
    return as_picture(inked(figure, 0.005, rng, 0.001, ground)), parts


def line_of(share):
    def line(figure, rng):
        figure = with_margin(figure)
        parts = with_line(figure.parts, pen_of(figure, share))
        return as_picture(inked(figure, share, rng, 0.001)), parts

    return line


def gaps(figure, rng):
    """Draws lines with gaps of up to 1.6 % of the size."""
    figure = with_margin(figure)
    edges = borders(figure.parts)
    rows, columns = np.nonzero(edges)
    for one in rng.choice(len(rows), 8):
        reach = round(rng.uniform(0.004, 0.008) * figure.size)
        y, x = rows[one], columns[one]
        edges[max(0, y - reach) : y + reach, max(0, x - reach) : x + reach] = False
    pen = pen_of(figure, 0.005)
    cover = strokes(edges, pen, 0.001 * figure.size, rng)
    return as_picture(over(white(figure), INK, cover)), with_line(figure.parts, pen)


def double(figure, rng):
    """Draws every line twice, each time unsteadily, as in a sketch."""
    figure = with_margin(figure)
    ground = white(figure)
    for _ in range(2):
        cover = 0.75 * strokes(borders(figure.parts), pen_of(figure, 0.003), 0.004 * figure.size, rng)
        ground = over(ground, INK + 40, cover)
    return as_picture(ground), figure.parts


def hatched(figure, rng):
    """Draws lines, and hatching in the darker half of the parts."""
    figure = with_margin(figure)
    rows, columns = np.indices(figure.parts.shape)
    light = mean_colours(figure).mean(axis=2)
    known = light[figure.parts > 0]
    dark = (figure.parts > 0) & (light < np.median(known))
    pitch = 0.018 * figure.size
    phase = (columns + 0.7 * rows + 0.15 * pitch * noise(rows.shape, 12, rng)) % pitch
    cover = np.clip(0.0018 * figure.size + 0.5 - np.abs(phase - pitch / 2), 0, 1) * dark
    ground = over(white(figure), INK, 0.9 * cover)
    return outlined(figure, ground, rng)


def crayon(figure, rng):
    """Colours the parts with grain that lets the paper through, and outlines them."""
    figure = with_margin(figure)
    grain = noise(figure.parts.shape, 1.2, rng)
    cover = np.clip(0.8 + 0.3 * grain, 0.25, 1) * figure.alpha
    ground = over(white(figure) - [5, 9, 23], figure.rgb, cover)
    pen = pen_of(figure, 0.006)
    line = strokes(borders(figure.parts), pen, 0.002 * figure.size, rng)
    drawn = over(ground, INK + 30, line * np.clip(0.85 + 0.3 * grain, 0.2, 1))
    return as_picture(drawn), with_line(figure.parts, pen)


def pencil(figure, rng):
    """Draws grey, uneven lines."""
    figure = with_margin(figure)
    grain = noise(figure.parts.shape, 0.8, rng)
    pen = pen_of(figure, 0.004)
    line = strokes(borders(figure.parts), pen, 0.002 * figure.size, rng)
    cover = line * np.clip(0.65 + 0.25 * grain, 0.1, 1)
    drawn = over(white(figure) - [4, 6, 12], INK + 55, cover)
    return as_picture(drawn), with_line(figure.parts, pen)


def ruled(figure, rng):
    """Draws lines on ruled paper."""
    figure = with_margin(figure)
    rows = np.indices(figure.parts.shape)[0]
    pitch = rng.uniform(0.03, 0.05) * figure.size
    rule = np.clip(1.2 - np.abs(rows % pitch - pitch / 2), 0, 1) * 0.6
    ground = over(white(figure), np.array([150, 180, 225.0]), rule)
    return outlined(figure, ground, rng)


def warped(values, corners, order):
    """Returns an image seen in perspective; `corners` are shifts of its corners, in sizes."""
    height, width = values.shape[:2]
    rows, columns = np.mgrid[:height, :width]
    u, v = columns / (width - 1), rows / (height - 1)
    weights = [(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v]
    size = max(height, width)
    x = columns + size * sum(w * shift[0] for w, shift in zip(weights, corners))
    y = rows + size * sum(w * shift[1] for w, shift in zip(weights, corners))
    channels = values[..., None] if values.ndim == 2 else values
    moved = [
        ndimage.map_coordinates(channels[..., c], [y, x], order=order, mode="nearest")
        for c in range(channels.shape[2])
    ]
    return moved[0] if values.ndim == 2 else np.dstack(moved)


def far_from_lamp(shape, rng):
    """Returns the distances of pixels, per longer side, from a place at random."""
    rows, columns = np.indices(shape) / max(shape)
    at = rng.uniform(0.2, 0.8, 2)
    return np.hypot(rows - at[0], columns - at[1])


def photograph(figure, rng):
    """Photographs a crayon drawing: in perspective, under a lamp, with noise, as JPEG."""
    picture, parts = crayon(figure, rng)
    corners = rng.uniform(-0.03, 0.03, (4, 2))
    seen = warped(picture.astype(float), corners, 1)
    parts = warped(parts, corners, 0)
    lamp = 1.05 - 0.45 * far_from_lamp(parts.shape, rng)
    seen = seen * lamp[..., None] * [1.0, 0.97, 0.9] + rng.normal(0, 2.5, seen.shape)
    return as_jpeg(as_picture(seen), 80), parts


def shaded(figure, rng):
    """Draws lines on coloured paper with a soft shadow across it."""
    figure = with_margin(figure)
    colour = rng.uniform(190, 245, 3)
    shade = 1 - 0.25 / (1 + np.exp(-noise(figure.parts.shape, figure.size / 5, rng) * 4))
    drawn = inked(figure, 0.005, rng, 0.001, np.broadcast_to(colour, figure.rgb.shape).astype(float))
    parts = with_line(figure.parts, pen_of(figure, 0.005))
    return as_picture(drawn * shade[..., None]), parts


def scenery(figure, rng):
    """Paints the figure before sky, ground and sun."""
    figure = with_margin(figure)
    rows, columns = np.indices(figure.parts.shape) / figure.size
    height = rng.uniform(0.5, 0.8) * rows.max()
    horizon = rows + 0.01 * noise(rows.shape, figure.size / 10, rng) > height
    ground = np.where(horizon[..., None], rng.uniform(90, 200, 3), rng.uniform(150, 240, 3))
    sun = np.hypot(rows - 0.1, columns - rng.uniform(0.1, 0.9) * columns.max()) < 0.07
    ground = np.where(sun[..., None], [250, 220, 90], ground)
    return as_picture(over(ground.astype(float), figure.rgb, figure.alpha)), figure.parts


def tile(figure, rng):
    """Paints the figure before a rounded tile with a gradient."""
    figure = with_margin(figure)
    height, width = figure.parts.shape
    rows, columns = np.indices(figure.parts.shape)
    inset, corner = 0.02 * figure.size, 0.12 * figure.size
    dx = np.maximum(np.abs(columns - width / 2) - (width / 2 - inset - corner), 0)
    dy = np.maximum(np.abs(rows - height / 2) - (height / 2 - inset - corner), 0)
    inside = np.clip(corner + 0.5 - np.hypot(dx, dy), 0, 1)
    top, bottom = rng.uniform(60, 235, 3), rng.uniform(60, 235, 3)
    share = (rows / height)[..., None]
    ground = over(white(figure), top * (1 - share) + bottom * share, inside)
    return as_picture(over(ground, figure.rgb, figure.alpha)), figure.parts


def scattered(shape, count, rng):
    """Returns `count` centres in a picture."""
    return zip(rng.integers(0, shape[0], count), rng.integers(0, shape[1], count))


def stroke_image(shape, starts, lengths, angles, width):
    """Returns the cover of short straight strokes."""
    drawn = Image.new("L", shape[::-1])
    pen = ImageDraw.Draw(drawn)
    for (y, x), length, angle in zip(starts, lengths, angles):
        ends = [x, y, x + length * np.cos(angle), y + length * np.sin(angle)]
        pen.line([float(value) for value in ends], fill=255, width=max(1, round(width)))
    return ndimage.gaussian_filter(np.asarray(drawn) / 255.0, 0.6)


def marked(figure, rng):
    """Draws lines, and short strokes inside the parts: fur, wrinkles, folds."""
    figure = with_margin(figure)
    count = int(rng.integers(15, 120))
    lengths = figure.size * rng.uniform(0.01, 0.08, count)
    angles = rng.uniform(0, 2 * np.pi) + rng.normal(0, rng.uniform(0.2, 2), count)
    starts = scattered(figure.parts.shape, count, rng)
    cover = stroke_image(figure.parts.shape, starts, lengths, angles, 0.004 * figure.size)
    inside = ndimage.binary_erosion(figure.parts > 0, iterations=4)
    ground = over(white(figure), INK, cover * inside)
    return outlined(figure, ground, rng)


def blotches(shape, size, share, rng):
    """Returns where a pattern of blotches or stripes lies, which covers a share of the picture."""
    longer = rng.uniform(1, 6)
    scales = (size, size * longer) if rng.random() < 0.5 else (size * longer, size)
    values = ndimage.gaussian_filter(rng.standard_normal(shape), scales)
    return values > np.quantile(values, 1 - share)


def pattern_of(figure, rng):
    """Returns where a pattern lies on about half of the parts."""
    blotch = blotches(figure.parts.shape, rng.uniform(0.01, 0.03) * figure.size, rng.uniform(0.2, 0.5), rng)
    patterned = np.concatenate([[False], rng.random(figure.parts.max()) < 0.6])
    return blotch & patterned[figure.parts]


def spotted(figure, rng):
    """Paints spots or stripes on the parts."""
    figure = with_margin(figure)
    shade = figure.rgb * rng.uniform(0.2, 0.7) if rng.random() < 0.7 else 255 - figure.rgb / 3
    cover = ndimage.gaussian_filter(pattern_of(figure, rng).astype(float), 0.7) * figure.alpha
    return as_picture(over(over(white(figure), figure.rgb, figure.alpha), shade, cover)), figure.parts


def patches(figure, rng):
    """Draws lines, and the outlines of patches on the parts."""
    figure = with_margin(figure)
    edges = borders(pattern_of(figure, rng).astype(int)) & (figure.parts > 0)
    cover = strokes(edges, pen_of(figure, 0.004), 0, rng)
    ground = over(white(figure), INK, cover)
    return outlined(figure, ground, rng)


def meadow(figure, rng):
    """Draws lines before a horizon, stones and grass."""
    figure = with_margin(figure)
    shape = figure.parts.shape
    drawn = Image.new("L", shape[::-1])
    pen = ImageDraw.Draw(drawn)
    width = max(2, round(pen_of(figure, 0.005)))
    height = rng.uniform(0.3, 0.8) * shape[0]
    wave = height + 0.02 * figure.size * np.sin(np.arange(shape[1]) / rng.uniform(20, 200))
    pen.line([(x, float(y)) for x, y in enumerate(wave)], fill=255, width=width)
    for y, x in scattered(shape, int(rng.integers(0, 6)), rng):
        a, b = figure.size * rng.uniform(0.02, 0.08, 2)
        if y > height:
            pen.ellipse([x - a, y - b, x + a, y + b], outline=255, width=width)
    count = int(rng.integers(0, 60))
    grass = [(y, x) for y, x in scattered(shape, count, rng) if y > height]
    lengths = figure.size * rng.uniform(0.01, 0.04, len(grass))
    angles = -np.pi / 2 + rng.normal(0, 0.3, len(grass))
    cover = np.maximum(np.asarray(drawn) / 255.0, stroke_image(shape, grass, lengths, angles, 0.7 * width))
    outside = with_line(figure.parts, pen_of(figure, 0.005)) == 0
    return outlined(figure, over(white(figure), INK, cover * outside), rng)


def shadow(figure, rng):
    """Paints the figure with the shadow that it casts, soft or hard, on the page or on transparency."""
    figure = with_margin(figure)
    height, width = figure.parts.shape
    rows, columns = np.indices(figure.parts.shape)
    foot = np.nonzero((figure.parts > 0).any(axis=1))[0][-1] if figure.parts.any() else height // 2
    across, down = rng.uniform(0.15, 0.4) * width, rng.uniform(0.02, 0.06) * height
    reach = np.hypot((columns - width / 2) / across, (rows - foot) / down)
    cover = rng.uniform(0.2, 0.6) * np.clip((1 - reach) * rng.choice([2.0, 20.0]), 0, 1)
    if rng.random() < 0.4:
        alpha = np.maximum(figure.alpha, cover)
        colour = np.where((figure.alpha > 0)[..., None], figure.rgb, 0)
        return np.dstack([as_picture(colour), as_picture(255 * alpha)]), figure.parts
    ground = over(white(figure), np.array([40.0, 40, 50]), cover)
    return as_picture(over(ground, figure.rgb, figure.alpha)), figure.parts


def page(figure, rng):
    """Photographs a drawing on a page that lies on a table."""
    manner = [crayon, pencil, line_of(0.005), ruled][int(rng.integers(4))]
    picture, parts = manner(figure, rng)
    border = round(rng.uniform(0.04, 0.15) * figure.size)
    picture = np.pad(picture, [(border, border), (border, border), (0, 0)]).astype(float)
    paper = np.pad(np.ones(parts.shape), border)
    parts = np.pad(parts, border)
    grain = noise((paper.shape[0], 1), 2, rng) + 0.3 * noise(paper.shape, 3, rng)
    table = rng.uniform(40, 200, 3) + rng.uniform(2, 12) * grain[..., None]
    seen = np.where(paper[..., None] > 0, picture, table)
    corners = rng.uniform(-0.04, 0.04, (4, 2))
    seen, parts = warped(seen, corners, 1), warped(parts, corners, 0)
    far = far_from_lamp(parts.shape, rng)
    lamp = 1.0 - rng.uniform(0.1, 0.4) * far
    return as_jpeg(as_picture(seen * lamp[..., None] + rng.normal(0, 2, seen.shape)), 85), parts


def clear(figure, rng):
    """Draws lines on transparency."""
    figure = with_margin(figure)
    pen = pen_of(figure, 0.005)
    cover = strokes(borders(figure.parts), pen, 0.001 * figure.size, rng)
    ink = np.broadcast_to(as_picture(INK), figure.rgb.shape)
    return np.dstack([ink, as_picture(255 * cover)]), with_line(figure.parts, pen)


def cut_out(figure, _):
    """Paints the figure on transparency."""
    figure = with_margin(figure)
    return np.dstack([as_picture(figure.rgb), as_picture(255 * figure.alpha)]), figure.parts


def small_of(side):
    def small(figure, rng):
        picture, parts = painted(figure, rng)
        scale = side / max(parts.shape)
        size = [max(8, round(scale * length)) for length in parts.shape[::-1]]
        reduced = Image.fromarray(picture).resize(size, Image.Resampling.BOX)
        return np.asarray(reduced), parts

    return small


def as_jpeg(picture, quality):
    file = io.BytesIO()
    Image.fromarray(picture).save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file).convert("RGB"))


def jpeg(figure, rng):
    picture, parts = painted(figure, rng)
    return as_jpeg(picture, int(rng.integers(40, 75))), parts


MANNERS = {
    "painted": painted,
    "plain": plain,
    "line fine": line_of(0.0025),
    "line": line_of(0.005),
    "line broad": line_of(0.011),
    "gaps": gaps,
    "double": double,
    "hatched": hatched,
    "crayon": crayon,
    "pencil": pencil,
    "ruled": ruled,
    "shaded": shaded,
    "photograph": photograph,
    "scenery": scenery,
    "tile": tile,
    "marked": marked,
    "spotted": spotted,
    "patches": patches,
    "meadow": meadow,
    "shadow": shadow,
    "page": page,
    "clear": clear,
    "cut out": cut_out,
    "small 32": small_of(32),
    "small 64": small_of(64),
    "small 128": small_of(128),
    "jpeg": jpeg,
}
