#!/usr/bin/env python3
"""Draws what a printer lays, layer over layer, from above at an angle.

Usage: draw-layers.py FILE.gcode OUT.png
"""

import math
import sys

from PIL import Image, ImageDraw

SIDE = 720
TURN, TILT = math.radians(-25), math.radians(40)
LINE_MM = 0.45
COLOURS = {"External perimeter": (214, 122, 60), "Top solid infill": (236, 168, 96)}
INNER = (150, 140, 128)


def strokes(gcode):
    """Layer height, kind and the points of every line that is extruded."""
    z, kind, place, line = 0.0, "", None, []
    for text in gcode:
        if text.startswith(";Z:"):
            z = float(text[3:])
        elif text.startswith(";TYPE:"):
            kind = text[6:].strip()
        if not text.startswith("G1 "):
            continue
        words = {word[0]: word[1:] for word in text.split(";")[0].split()[1:]}
        if "X" not in words and "Y" not in words:
            continue
        old = place or (0.0, 0.0)
        place = (float(words.get("X", old[0])), float(words.get("Y", old[1])))
        extruded = "E" in words and float(words["E"]) > 0
        if extruded:
            line = line or [old]
            line.append(place)
        elif line:
            yield z, kind, line
            line = []
    if line:
        yield z, kind, line


def project(x, y, z):
    along = x * math.cos(TURN) - y * math.sin(TURN)
    away = x * math.sin(TURN) + y * math.cos(TURN)
    return along, -(away * math.sin(TILT) + z * math.cos(TILT))


def draw(lines):
    flat = [(z, kind, [project(x, y, z) for x, y in line]) for z, kind, line in lines]
    low = [min(p[k] for _, _, line in flat for p in line) for k in (0, 1)]
    high = [max(p[k] for _, _, line in flat for p in line) for k in (0, 1)]
    scale = 2 * SIDE / max(high[0] - low[0], high[1] - low[1])
    margin = 24
    size = [round(scale * (high[k] - low[k])) + 2 * margin for k in (0, 1)]
    picture = Image.new("RGB", size, "white")
    pen = ImageDraw.Draw(picture)
    top = max(z for z, _, _ in flat)
    for z, kind, line in flat:
        light = 0.55 + 0.45 * z / top
        colour = tuple(round(light * c) for c in COLOURS.get(kind, INNER))
        points = [tuple(margin + scale * (p[k] - low[k]) for k in (0, 1)) for p in line]
        pen.line(points, fill=colour, width=max(1, round(0.7 * scale * LINE_MM)))
    return picture.resize((size[0] // 2, size[1] // 2), Image.LANCZOS)


def main():
    with open(sys.argv[1], encoding="utf-8", errors="replace") as gcode:
        lines = [s for s in strokes(gcode) if "Skirt" not in s[1] and s[1] != "Custom"]
    draw(lines).convert("P", palette=Image.ADAPTIVE, colors=64).save(sys.argv[2])


main()
