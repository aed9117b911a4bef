"""Fronts of models (GLB), and how far they are from paintings of the same drawing."""

import io
import json
import struct

import numpy as np
from PIL import Image, ImageChops, ImageDraw, ImageFilter

# Longest side of the pictures that are compared, px.
SIDE = 200
# Alpha of 255 up to which nothing is painted, and from which on something is.
UNPAINTED = 16
PAINTED = 128
# Difference of a channel that a person sees side by side, of 255.
TELLING = 48
# Difference of a channel within the ground, of 255.
SAME_GROUND = 24
# Reach of the tolerance at edges, px.
EDGE = 2


def texture_of(model):
    """Returns the texture of a model (GLB)."""
    data = model.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    stated, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    view = stated["bufferViews"][stated["images"][0]["bufferView"]]
    begin = view.get("byteOffset", 0)
    return Image.open(io.BytesIO(binary[begin : begin + view["byteLength"]])).convert("RGB")


def silhouette_of(parts, scale, size):
    covered = Image.new("L", size, 0)
    for part in parts:
        one = Image.new("L", size, 0)
        for ring in part["outline"]:
            filled = Image.new("L", size, 0)
            places = [(x * scale - 0.5, y * scale - 0.5) for x, y in ring]
            ImageDraw.Draw(filled).polygon(places, fill=255)
            one = ImageChops.difference(one, filled)
        covered = ImageChops.lighter(covered, one)
    return covered


def front_of(scene, model=None):
    """Returns the front of a model, RGBA, its longest side SIDE px: the outlines of the scene's
    parts, filled with the texture of the model, or with grey where none is given.
    """
    stated = json.loads(scene.read_text())
    width, height = stated["canvas"]["width"], stated["canvas"]["height"]
    scale = SIDE / max(width, height)
    size = max(1, round(width * scale)), max(1, round(height * scale))
    front = Image.new("RGB", size, (128, 128, 128))
    if model:
        # What nobody sees from the front lies below the drawing.
        texture = texture_of(model)
        drawing = 0, 0, texture.width, round(texture.width * height / width)
        front = texture.resize(size, Image.Resampling.BOX, box=drawing)
    front.putalpha(silhouette_of(stated["parts"], scale, size))
    return front


def grown(mask, reach):
    """Returns a mask with all that is within `reach` px of it, along both axes."""
    picture = Image.fromarray(mask.astype(np.uint8) * 255)
    return np.asarray(picture.filter(ImageFilter.MaxFilter(2 * reach + 1))) > 0


def reached(mask, seeds):
    """Returns the part of a mask that is connected to the seeds."""
    found = mask & seeds
    while True:
        wider = grown(found, 1) & mask
        if (wider == found).all():
            return found
        found = wider


def rim_of(shape):
    rim = np.ones(shape, bool)
    rim[1:-1, 1:-1] = False
    return rim


def is_ground(paint, uncovered):
    """Returns where uncovered paint is ground: it reaches the edge, or looks as what does."""
    ground = reached(uncovered, rim_of(uncovered.shape))
    if not ground.any():
        return ground
    colour = np.median(paint[ground][:, :3], axis=0)
    alike = (np.abs(paint[:, :, :3] - colour) <= SAME_GROUND).all(axis=2)
    return ground | (uncovered & alike)


def flat_colours(picture):
    """Returns the blurred colours of a picture."""
    soft = picture.convert("RGB").filter(ImageFilter.BoxBlur(1))
    return np.asarray(soft).astype(int)


def over_white(picture):
    ground = Image.new("RGBA", picture.size, "white")
    return Image.alpha_composite(ground, picture)


def compare(painting, front, colours=True):
    """Returns the shares by which a front differs from a painting of the same size, both RGBA.

    `colours` says whether the front has any.
    """
    paint = np.asarray(painting).astype(int)
    covered = np.asarray(front)[:, :, 3] > 0
    painted = paint[:, :, 3] >= PAINTED
    touched = paint[:, :, 3] > UNPAINTED
    uncovered = painted & ~covered
    ground = is_ground(paint, uncovered)
    loose = uncovered & ~ground & ~grown(covered, EDGE)
    bare = covered & ~grown(touched, EDGE)
    around = reached(~touched, rim_of(touched.shape))
    both = ~grown(~(covered & painted), 1)
    gap = np.abs(flat_colours(over_white(painting)) - flat_colours(front)).max(axis=2)
    area = max(1, int((covered | (painted & ~ground)).sum()))
    return {
        "bare": (bare & around).sum() / area,
        "loose": loose.sum() / area,
        "colour": (both & (gap > TELLING)).sum() / area if colours else 0,
        "filled": (bare & ~around).sum() / area,
        "ground": ground.sum() / ground.size,
    }
