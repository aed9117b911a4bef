#!/usr/bin/python3
"""Gathers layered drawings whose parts, order and joins are known: gather.py PROGRAM FOLDER.

Writes FOLDER/figures/ID.svg with the scene ID.json that was read of it, and FOLDER/figures.tsv. A
drawing is kept where the layered reader takes it as such, without a warning, with enough parts. A
run that was stopped goes on where it was.
"""

import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import subprocess

import sources

LEAST_PARTS = 3
MOST_PARTS = 60
LIMIT = 20  # seconds

COLUMNS = ("id", "split", "artist", "name", "parts")


def parts_of(program, file, scene):
    """Writes the scene of a drawing and returns the number of its parts, or None where it is no layered drawing."""
    words = [program, "check", file, "-o", scene, "--threads", "1"]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return None
    if done.returncode != 0 or "warning:" in done.stderr:
        return None
    return len(json.loads(scene.read_text())["parts"])


def digest(svg):
    return hashlib.sha256(svg.encode()).hexdigest()[:16]


def keep(program, folder, drawing):
    """Returns the row of a drawing that is kept, or None."""
    split, artist, name, svg = drawing
    one = digest(svg)
    file, scene = folder / f"{one}.svg", folder / f"{one}.json"
    if scene.exists():
        parts = len(json.loads(scene.read_text())["parts"])
    else:
        file.write_text(svg)
        parts = parts_of(program, file, scene)
    if parts is not None and LEAST_PARTS <= parts <= MOST_PARTS:
        return dict(zip(COLUMNS, (one, split, artist, name, parts)))
    file.unlink()
    scene.unlink(missing_ok=True)
    return None


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    words.add_argument("program")
    words.add_argument("folder", type=pathlib.Path)
    words.add_argument("--share", type=float, default=1, help="of the drawings, always the same ones")
    words.add_argument("--jobs", type=int, default=2)
    given = words.parse_args()
    figures = given.folder / "figures"
    figures.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        drawings = {digest(one[3]): one for one in sources.all_drawings(given.folder / "sources")}
        chosen = sorted(drawings)[: round(given.share * len(drawings))]
        kept = pool.map(lambda one: keep(given.program, figures, drawings[one]), chosen)
        rows = [row for row in kept if row]
    with (given.folder / "figures.tsv").open("w") as table:
        print(*COLUMNS, sep="\t", file=table)
        for row in sorted(rows, key=lambda row: (row["split"], row["artist"], row["id"])):
            print(*row.values(), sep="\t", file=table)
    for split in sources.SPLITS:
        of_split = [row for row in rows if row["split"] == split]
        print(split, len(of_split), "figures by", len({row["artist"] for row in of_split}), "hands")


if __name__ == "__main__":
    main()
