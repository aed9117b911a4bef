#!/usr/bin/python3
"""Paints figures to learn from: paint.py CORPUS FOLDER SPLIT --each N --most M --shapes K.

Writes FOLDER/ID-K.png, a figure in one manner, and FOLDER/ID-K.parts.png, the visible part of each
pixel of the picture's box: 0 outside the figure, k + 1 on part k of the scene CORPUS/figures/ID.json,
which is copied to FOLDER/ID.json. Figures of simple shapes (see shapes.py) have the ids "shapesN" and
no scene; each part is in front of all that come before it.
"""

import argparse
import concurrent.futures
import pathlib
import shutil
import sys

import numpy as np
from PIL import Image

sys.path.append(str(pathlib.Path(__file__).parent.parent / "corpus"))
import manners
import shapes
import sources
import table


def paint(folder, one, figure, painters):
    """Writes the pictures of a figure. Returns their number."""
    for k, (name, painter) in enumerate(painters):
        rng = np.random.default_rng(sources.number_of("learn" + one + name))
        picture, parts = painter(figure, rng)
        Image.fromarray(picture).save(folder / f"{one}-{k}.png", compress_level=1)
        Image.fromarray(parts.astype(np.uint8)).save(folder / f"{one}-{k}.parts.png", compress_level=1)
    return len(painters)


def painters_of(one, each):
    """Returns some manners, chosen by a figure's id."""
    return sorted(manners.MANNERS.items(), key=lambda item: sources.number_of("learn" + one + item[0]))[:each]


def paint_drawing(corpus, folder, one, each, side):
    try:
        figure, _ = table.figure_of(corpus, one, side)
    except (OSError, IndexError, table.subprocess.CalledProcessError):
        return 0
    shutil.copy(corpus / "figures" / f"{one}.json", folder)
    return paint(folder, one, figure, painters_of(one, each))


def paint_shapes(folder, number, each, side):
    """Paints a figure of simple shapes, half of the pictures as shapes.drawn_by_hand."""
    one = f"shapes{number}"
    figure, *limbs = shapes.figure(np.random.default_rng(sources.number_of(one)), side)
    by_hand = [(f"hand{k}", lambda figure, rng: shapes.drawn_by_hand(figure, *limbs, rng)) for k in range(each // 2)]
    return paint(folder, one, figure, by_hand + painters_of(one, each - len(by_hand)))


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    words.add_argument("corpus", type=pathlib.Path)
    words.add_argument("folder", type=pathlib.Path)
    words.add_argument("split", choices=sources.SPLITS)
    words.add_argument("--each", type=int, default=3, help="manners of each figure")
    words.add_argument("--most", type=int, default=0, help="figures, at most")
    words.add_argument("--shapes", type=int, default=0, help="figures of simple shapes besides")
    words.add_argument("--side", type=int, default=table.SIDE, help="longest side of figures, px")
    words.add_argument("--jobs", type=int, default=2)
    given = words.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    table.keep_memory()
    with concurrent.futures.ProcessPoolExecutor(given.jobs) as pool:
        work = [
            pool.submit(paint_drawing, given.corpus, given.folder, row["id"], given.each, given.side)
            for row in table.figures_of(given.corpus, given.split, given.most)
        ]
        work += [
            pool.submit(paint_shapes, given.folder, number, given.each, given.side)
            for number in range(given.shapes)
        ]
        print(sum(done.result() for done in work), "pictures")


if __name__ == "__main__":
    main()
