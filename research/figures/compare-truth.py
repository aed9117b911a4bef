#!/usr/bin/python3
"""Measures all methods on rendered characters, whose depth and normals are known, and writes the
table into docs/figures.md.

Usage: compare-truth.py RELIEVO_COMPARE TRUTH PAGE METHOD...

TRUTH holds a folder for each picture: drawing.png; labels.png (0 background, k the k-th part); parts/
with the whole silhouette of each part, in the same order, back to front; lineart.png (dark where
ink is); depth_front_u16.png (near is bright) and normals.png (x right, y up, z to the viewer).
Every picture becomes a layered drawing without annotations.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image, ImageFilter

BEGIN, END = "<!-- truth -->\n", "<!-- end of truth -->\n"
INK_MARGIN = 9  # px, side of the square around ink that is not measured
RIM = 5  # px, likewise of the inked rim of a layer
VERTICES = 15000
LONGEST = 1024


def grey(path):
    return np.asarray(Image.open(path)).astype(float)


def write_layers(case, folder):
    """Whole layers: the drawing's colours where a part is seen, its median where it is not."""
    labels = grey(case / "labels.png")
    colours = np.asarray(Image.open(case / "drawing.png").convert("RGB"))
    rows = ["file\torder_back_to_front\tname"]
    for k, path in enumerate(sorted((case / "parts").iterdir())):
        whole = grey(path) > 0
        seen = (labels == k + 1) & whole
        layer = np.zeros(labels.shape + (4,), np.uint8)
        layer[..., :3] = np.median(colours[seen], axis=0) if seen.sum() > 50 else 128
        layer[seen, :3] = colours[seen]
        mask = Image.fromarray((whole * 255).astype(np.uint8))
        inner = np.asarray(mask.filter(ImageFilter.MinFilter(RIM))) > 0
        layer[whole & ~inner, :3] = (35, 30, 40)
        layer[..., 3] = whole * 255
        Image.fromarray(layer).save(folder / f"{k:02d}.png")
        rows.append(f"{k:02d}.png\t{k}\t{path.stem.split('_', 1)[-1]}")
    (folder / "layers.tsv").write_text("\n".join(rows) + "\n")


def resized(path, shape):
    """Nearest pixels."""
    picture = grey(path)
    rows, columns = (np.minimum(have - 1, ((np.arange(want) + 0.5) * have / want).astype(int))
                     for have, want in zip(picture.shape, shape))
    return picture[rows][:, columns]


def score(compare, case, layers, method, folder):
    """Median angle between normals (degrees), correlation of depths, IoU of contours, seconds."""
    made = subprocess.run(
        [compare, layers, "--as", method, "--vertices", str(VERTICES), "--quiet",
         "--map-size", str(LONGEST), "--normal-map", folder / "n.png", "--depth-map",
         folder / "d.png", "--report", folder / "r.json"], capture_output=True, text=True)
    if made.returncode != 0:
        print(f"{case.name}, {method}: {made.stderr.strip()}", file=sys.stderr)
        return None
    labels = grey(case / "labels.png")
    ink = Image.open(case / "lineart.png").convert("L").filter(ImageFilter.MinFilter(INK_MARGIN))
    depth = resized(folder / "d.png", labels.shape)
    measured = (labels > 0) & (depth > 0) & (np.asarray(ink) >= 128)
    normals = [picture[measured][:, :3] / 127.5 - 1 for picture in
               (grey(case / "normals.png"), resized(folder / "n.png", labels.shape))]
    true, found = (n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-9) for n in normals)
    angles = np.degrees(np.arccos(np.clip((true * found).sum(axis=1), -1, 1)))
    correlation = np.corrcoef(grey(case / "depth_front_u16.png")[measured], depth[measured])[0, 1]
    report = json.loads((folder / "r.json").read_text())
    return np.median(angles), correlation, report["contour_iou"], report["milliseconds"]["method"] / 1e3


def main():
    compare, truth, page = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    methods = sys.argv[4:]
    scores = {method: [] for method in methods}
    cases = sorted(path.parent for path in truth.glob("*/drawing.png"))
    for case in cases:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            layers = folder / "layers"
            layers.mkdir()
            write_layers(case, layers)
            for method in methods:
                found = score(compare, case, layers, method, folder)
                if found is not None:
                    scores[method].append(found)
    rows = [f"| method | pictures of {len(cases)} | normals off by, degrees | depth correlates by |"
            " contour IoU | time, s |", "|---|---|---|---|---|---|"]
    for method, found in scores.items():
        if found:
            normal, depth, contour, time = np.mean(found, axis=0)
            rows.append(f"| `{method}` | {len(found)} | {normal:.1f} | {depth:.2f} | {contour:.3f} |"
                        f" {time:.2f} |")
    text = page.read_text()
    head, rest = text.split(BEGIN)
    page.write_text(head + BEGIN + "\n" + "\n".join(rows) + "\n\n" + END + rest.split(END)[1])


main()
