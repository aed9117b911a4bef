"""Converts Grease Pencil strokes to a drawing. Each stroke is a part in the colour of its material."""

from xml.sax.saxutils import quoteattr

import numpy as np

SIDE = 1000.0  #: longer side of the strokes on the canvas, px
MARGIN = 20.0  #: around the strokes, px


def outlines(thing):
    """Returns (name, colour, points) of every stroke, back to front. Points are n x 2, world x and z."""
    found = []
    for layer in thing.data.layers:
        frame = layer.active_frame or (layer.frames[0] if len(layer.frames) else None)
        if layer.hide or frame is None:
            continue
        for stroke in frame.strokes:
            if len(stroke.points) < 3:
                continue
            world = [thing.matrix_world @ point.co for point in stroke.points]
            found.append((f"{layer.info} {len(found) + 1}", fill_of(thing, stroke),
                          np.array([(p.x, p.z) for p in world])))
    return found


def fill_of(thing, stroke):
    slots = thing.material_slots
    material = slots[stroke.material_index].material if stroke.material_index < len(slots) else None
    style = material.grease_pencil if material else None
    if style is None:
        return "#b0a090"
    colour = style.fill_color if style.show_fill else style.color
    # Blender's colours are linear, those of SVG are sRGB.
    srgb = [12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in colour[:3]]
    return "#" + "".join(f"{round(255 * min(max(c, 0), 1)):02x}" for c in srgb)


def to_svg(thing):
    """Returns the text of a layered SVG, and (x, z, units per px) of the upper left corner of its canvas."""
    shapes = outlines(thing)
    if not shapes:
        raise ValueError("no stroke has three points or more")
    points = np.concatenate([shape[2] for shape in shapes])
    low, high = points.min(0), points.max(0)
    unit = float((high - low).max()) / SIDE
    if unit == 0:
        raise ValueError("all points of the strokes are in the same place")
    left, top = low[0] - MARGIN * unit, high[1] + MARGIN * unit
    width, height = (high - low) / unit + 2 * MARGIN
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.3f}" height="{height:.3f}">']
    for name, colour, stroke in shapes:
        path = " ".join(f"{(x - left) / unit:.3f},{(top - z) / unit:.3f}" for x, z in stroke)
        lines.append(f'<g data-relievo="part" id={quoteattr(name)}><path d="M {path} Z" fill="{colour}"/></g>')
    return "\n".join(lines + ["</svg>"]), (left, top, unit)
