#!/usr/bin/python3
"""Prints how well flat drawings are understood: table.py PROGRAM CORPUS SPLIT [--each N].

The corpus is a folder of gather.py. Each figure is painted in N manners, chosen by its id, and read
back. The table has a row for each manner and one for each hand.
"""

import argparse
import collections
import concurrent.futures
import csv
import ctypes
import json
import pathlib
import subprocess
import tempfile

import manners
import measure
import numpy as np
import sources
from PIL import Image

SIDE = 800
LIMIT = 60  # seconds
MEASURES = ("figure", "parts", "information", "contours", "pairs", "joins")
# What a figure with nothing bad has at least.
LEAST = {"figure": 0.9, "parts": 0.6, "contours": 0.65}


def figures_of(corpus, split, most=0):
    """Returns the rows of a split in an order that has nothing to do with their artists."""
    with (corpus / "figures.tsv").open() as file:
        rows = [row for row in csv.DictReader(file, delimiter="\t") if row["split"] == split]
    rows.sort(key=lambda row: sources.number_of("order " + row["id"]))
    return rows[: most or None]


def keep_memory():
    """Lets the C library keep freed memory for the next images, here and in processes that are started
    from here. Half of the time goes into giving it back otherwise."""
    trim_threshold, top_pad, mmap_threshold = -1, -2, -3
    library = ctypes.CDLL(None)
    for parameter, value in ((mmap_threshold, 1 << 25), (trim_threshold, 1 << 30), (top_pad, 1 << 26)):
        library.mallopt(parameter, value)


def painting_of(file, width, height):
    """Paints a drawing on transparency."""
    words = ["rsvg-convert", "-w", str(width), "-h", str(height), file]
    done = subprocess.run(words, capture_output=True, check=True)
    with tempfile.NamedTemporaryFile(suffix=".png") as picture:
        picture.write(done.stdout)
        picture.flush()
        return np.asarray(Image.open(picture.name).convert("RGBA")).astype(float)


def figure_of(corpus, one, side=SIDE):
    """Returns a figure of the given longest side with its truth: (whole parts, scene)."""
    scene = json.loads((corpus / "figures" / f"{one}.json").read_text())
    wholes = measure.whole_parts(scene, side)
    parts = measure.visible_parts(wholes, wholes[0].shape)
    painting = painting_of(corpus / "figures" / f"{one}.svg", *parts.shape[::-1])
    # Where the painting ends, so do the parts.
    parts = np.where(painting[..., 3] > 100, parts, 0)
    figure = manners.Figure(painting[..., :3], painting[..., 3] / 255 * (parts > 0), parts)
    return figure, (wholes, scene)


def understood(program, picture, folder):
    """Returns (map of visible parts, whole parts, scene) that a program finds in a picture."""
    file, scene_file = folder / "picture.png", folder / "scene.json"
    Image.fromarray(picture).save(file)
    scene_file.unlink(missing_ok=True)
    words = [program, "check", file, "-o", scene_file, "--threads", "1"]
    try:
        subprocess.run(words, capture_output=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        pass
    if not scene_file.exists():
        return None
    scene = json.loads(scene_file.read_text())
    wholes = measure.whole_parts(scene, SIDE)
    return measure.visible_parts(wholes, wholes[0].shape), wholes, scene


def results_of(program, corpus, row, each):
    """Returns rows {id, artist, manner, measures} of one figure."""
    try:
        figure, (wholes, scene) = figure_of(corpus, row["id"])
    except (subprocess.CalledProcessError, IndexError):
        return []
    names = sorted(manners.MANNERS, key=lambda name: sources.number_of(row["id"] + name))[:each]
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            rng = np.random.default_rng(sources.number_of(row["id"] + name))
            picture, parts = manners.MANNERS[name](figure, rng)
            found = understood(program, picture, pathlib.Path(folder))
            result = {"id": row["id"], "artist": row["artist"], "manner": name}
            if found is None:
                result |= dict.fromkeys(MEASURES, 0.0) | {"information": np.nan}
            else:
                pixel = max(parts.shape) / max(picture.shape[:2])
                result |= measure.compare((parts, wholes, scene), found, pixel)
            results.append(result)
    return results


def means(results):
    values = {name: np.nanmean([one[name] for one in results]) for name in MEASURES}
    good = [all(one[name] >= least for name, least in LEAST.items()) for one in results]
    wide = [one["figure"] >= 0.97 for one in results]
    return values | {"figure .97": np.mean(wide), "good": np.mean(good)}


def print_table(title, results, key):
    groups = collections.defaultdict(list)
    for one in results:
        groups[one[key]].append(one)
    columns = [*MEASURES, "figure .97", "good"]
    print(f"{title:24s}{'n':>6s}" + "".join(f"{name:>12s}" for name in columns))
    for name, rows in [*sorted(groups.items()), ("all", results)]:
        values = means(rows)
        print(f"{name[:23]:24s}{len(rows):6d}" + "".join(f"{values[c]:12.3f}" for c in columns))


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    words.add_argument("program")
    words.add_argument("corpus", type=pathlib.Path)
    words.add_argument("split", choices=sources.SPLITS)
    words.add_argument("--each", type=int, default=3, help="manners of each figure")
    words.add_argument("--most", type=int, default=0, help="figures, at most")
    words.add_argument("--jobs", type=int, default=2)
    words.add_argument("--rows", type=pathlib.Path, help="file for all results (.tsv)")
    given = words.parse_args()
    keep_memory()
    figures = figures_of(given.corpus, given.split, given.most)
    with concurrent.futures.ProcessPoolExecutor(given.jobs) as pool:
        work = [pool.submit(results_of, given.program, given.corpus, row, given.each) for row in figures]
        results = [one for done in work for one in done.result()]
    if given.rows:
        with given.rows.open("w") as file:
            writer = csv.DictWriter(file, ["id", "artist", "manner", *MEASURES], delimiter="\t")
            writer.writeheader()
            writer.writerows(results)
    print_table("manner", results, "manner")
    print()
    print_table("hand", results, "artist")


if __name__ == "__main__":
    main()
