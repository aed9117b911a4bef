#!/usr/bin/python3
"""Lays pictures on coloured paper, or pages on tables, as a camera sees them, and tells how well their figures are found.

photographed.py RELIEVO FOLDER [--limit 100]

FOLDER has PNG files whose transparency tells the figure. Each is laid on paper of one colour, and on a white page that lies
turned on a table of one colour; light falls off to a side by up to 35 %, with grain of up to 5 of 255, stored as JPEG. On
paper it is taken whole and cut by the lower edge. Prints the overlap (intersection over union) of figures on paper with the
true ones, how many are off by more than 10 %, and on how many tables a part lies. Needs numpy and Pillow.
"""
import argparse
import colorsys
import io
import json
import random
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw


def colour(rng):
    """Of paper or a table: kraft, or any hue from dark to pale."""
    if rng.random() < 0.2:
        return np.array([184.0, 148.0, 107.0])
    return 255 * np.array(colorsys.hsv_to_rgb(rng.random(), rng.uniform(0.15, 0.8), rng.uniform(0.2, 0.9)))


def photographed(rgb, rng):
    """With light, grain and the losses of a codec."""
    h, w = rgb.shape[:2]
    x, y = np.meshgrid(np.linspace(-1, 1, w), np.linspace(-1, 1, h))
    turn = rng.uniform(0, 2 * np.pi)
    light = 1 - rng.choice([0, 0.1, 0.2, 0.35]) * (0.5 + 0.35 * (x * np.cos(turn) + y * np.sin(turn)))
    grain = np.random.default_rng(rng.randrange(1 << 30)).normal(0, rng.choice([0, 1.5, 3, 5]), (h, w, 1))
    data = io.BytesIO()
    Image.fromarray(np.clip(rgb * light[..., None] + grain, 0, 255).astype(np.uint8)).save(data, "JPEG", quality=85)
    return Image.open(data)


def on_paper(picture, rng, kept):
    """The photograph and the true figure; `kept` is the share of the picture's height above the edge."""
    rgba = np.asarray(picture).astype(float)
    margin = round(picture.width * rng.uniform(0.1, 0.4))
    rgba = np.pad(rgba, ((margin, margin), (margin, margin), (0, 0)))[: margin + round(kept * picture.height) if kept < 1 else None]
    share = rgba[..., 3:] / 255
    return photographed(colour(rng) * (1 - share) + rgba[..., :3] * share, rng), share[..., 0] > 0.5


def on_table(picture, rng):
    """The photograph and the true page."""
    page = Image.new("RGBA", (picture.width + 80, picture.height + 80), (250, 248, 244, 255))
    page.alpha_composite(picture, (40, 40))
    turned = page.rotate(rng.uniform(-8, 8), Image.BICUBIC, expand=True)
    return on_paper(turned, rng, 1)


def found(relievo, photo):
    """1 where a part is, as far as it is seen or completed; nowhere where the picture is refused."""
    with tempfile.TemporaryDirectory() as folder:
        photo.save(f"{folder}/photo.png")
        done = subprocess.run([relievo, "segment", f"{folder}/photo.png", "-o", f"{folder}/scene.json", "-q"], capture_output=True)
        parts = json.loads(Path(f"{folder}/scene.json").read_text())["parts"] if done.returncode == 0 else []
    whole = np.zeros(photo.size[::-1], bool)
    for part in parts:
        inside = np.zeros_like(whole)
        for ring in part["outline"]:
            mask = Image.new("1", photo.size)
            ImageDraw.Draw(mask).polygon([tuple(p) for p in ring], fill=1)
            inside ^= np.asarray(mask)
        whole |= inside
    return whole


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("relievo")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--limit", type=int, default=100)
    args = parser.parse_args()
    pictures = sorted(args.folder.glob("*.png"))
    pictures = random.Random(1).sample(pictures, min(args.limit, len(pictures)))
    for name, kept in (("on paper", 1.0), ("cut by the edge", 0.7)):
        overlaps = []
        for path in pictures:
            photo, truth = on_paper(Image.open(path).convert("RGBA"), random.Random(path.stem + name), kept)
            figure = found(args.relievo, photo)
            overlaps.append((figure & truth).sum() / (figure | truth).sum())
        print(f"{name}: {len(overlaps)} pictures, overlap {np.mean(overlaps):.3f}, {sum(o < 0.9 for o in overlaps)} below 0.9")
    spoilt = 0
    for path in pictures:
        photo, page = on_table(Image.open(path).convert("RGBA"), random.Random(path.stem))
        spoilt += (found(args.relievo, photo) & ~page).sum() > 0.001 * page.sum()
    print(f"page on a table: {len(pictures)} pictures, parts on the table of {spoilt}")


if __name__ == "__main__":
    main()
