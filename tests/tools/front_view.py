"""Compares the fronts of models with the pictures that other programs paint of the same files.

Usage: front_view.py PROGRAM FILES TABLE [--sheets FOLDER] [--limit SECONDS] [--colours]

FILES is a text of lines `KIND<tab>FILE`. Finds the parts of every file with PROGRAM (relievo), and
paints the file anew: an SVG with Chromium, a painting of layers from the merged picture that it
holds (read by psd-tools), any other picture with Pillow. Writes TABLE, tab-separated, one line for
every file, and prints the distribution by kind. Shares are of the area of the model and the painted
figure:

bare     of the model, beside all paint
loose    of the paint that is in no part and is not ground
colour   where both are, in colours that a person tells apart
filled   of the model, where nothing is painted but paint is all around, as in a drawing of lines
ground   of the canvas: paint in no part that reaches the edge of the picture, or looks as it does

Colours are compared with --colours, which builds the models and takes several times as long. Needs
Pillow, NumPy, psd-tools and `chromium`.
"""

import argparse
import collections
import pathlib
import subprocess
import tempfile

from PIL import Image

import fronts
import painters

# Share of the area from which on a person sees that the front is not the drawing.
SEEN = 0.02
SHARES = ["bare", "loose", "colour", "filled", "ground"]
COLUMNS = ["kind", "file", "exit", *SHARES, "messages"]
# The table's word for a file that no second program paints.
UNPAINTED = "unpainted"


def run(program, words, limit):
    """Returns the exit code and the warnings, or the error."""
    try:
        ran = subprocess.run([program, *words], capture_output=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return "slow", ""
    lines = ran.stderr.decode(errors="replace").replace("\t", " ").splitlines()
    worth = [line for line in lines if ran.returncode or line.startswith("relievo: warning: ")]
    return ran.returncode, " | ".join(line.removeprefix("relievo: ") for line in worth)


def examine(kind, file, painter, folder, given):
    """Returns the row of a file, and the painting and the front that were compared."""
    scene, model = folder / "scene.json", folder / "model.glb"
    commands = [["check", file, "-o", scene]]
    if given.colours:
        commands.append(["build", file, "-o", model, "--vertices", "1500"])
    for command in commands:
        code, said = run(given.program, command, given.limit)
        if code != 0:
            break
    row = dict.fromkeys(COLUMNS, "") | {"kind": kind, "file": file, "exit": code, "messages": said}
    if code != 0:
        return row, None
    front = fronts.front_of(scene, model if given.colours else None)
    painting = painter.paint(file, front.size)
    if painting is None:
        return row | {"bare": UNPAINTED}, None
    shares = fronts.compare(painting, front, given.colours)
    return row | {name: f"{shares[name]:.4f}" for name in SHARES}, (painting, front)


def difference(row):
    """Returns the share of the area in which the front departs from the painting."""
    return sum(float(row[name]) for name in SHARES[:3])


def distribution(rows):
    """Returns lines: for every kind the number of files, of models, of those that differ."""
    kinds = collections.defaultdict(collections.Counter)
    for row in rows:
        for kind in (row["kind"], "all"):
            count = kinds[kind]
            count["files"] += 1
            if row["exit"] != 0:
                continue
            count["models"] += 1
            if row["bare"] == UNPAINTED:
                count["unpainted"] += 1
            elif difference(row) > SEEN:
                count["differ"] += 1
                count["silent"] += not row["messages"]
    names = ["files", "models", "unpainted", "differ", "silent"]
    lines = ["\t".join(["kind", *names])]
    for kind, count in sorted(kinds.items(), key=lambda one: (one[0] == "all", one[0])):
        lines.append("\t".join([kind, *(str(count[name]) for name in names)]))
    return lines


def save_pair(pair, file):
    """Saves painting and front side by side on a chequered ground."""
    width, height = pair[0].size
    sheet = Image.new("RGB", (2 * width + 4, height), "black")
    for index, picture in enumerate(pair):
        ground = Image.new("RGB", picture.size, (205, 225, 205))
        ground.paste(picture, mask=picture.getchannel("A"))
        sheet.paste(ground, (index * (width + 4), 0))
    sheet.save(file)


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    words.add_argument("program")
    words.add_argument("files", type=pathlib.Path)
    words.add_argument("table", type=pathlib.Path)
    words.add_argument("--sheets", type=pathlib.Path, help="folder for pictures of what differs")
    words.add_argument("--limit", type=float, default=20, help="seconds a file may take")
    words.add_argument("--colours", action="store_true", help="compare colours too")
    given = words.parse_args()
    if given.sheets:
        given.sheets.mkdir(parents=True, exist_ok=True)
    rows = []
    with (
        tempfile.TemporaryDirectory() as folder,
        painters.Painter() as painter,
        given.table.open("w") as table,
    ):
        table.write("\t".join(COLUMNS) + "\n")
        for number, line in enumerate(given.files.read_text().splitlines()):
            kind, file = line.split("\t")
            row, pair = examine(kind, pathlib.Path(file), painter, pathlib.Path(folder), given)
            rows.append(row)
            table.write("\t".join(str(row[name]) for name in COLUMNS) + "\n")
            table.flush()
            if given.sheets and pair and difference(row) > SEEN:
                save_pair(pair, given.sheets / f"{number:05}.png")
    print("\n".join(distribution(rows)))


if __name__ == "__main__":
    main()
