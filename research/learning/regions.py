#!/usr/bin/python3
"""Learns which regions are one part, and which belong to the figure: regions.py PROGRAM FOLDER TABLES.

FOLDER holds pictures of paint.py, PROGRAM is relievo-regions. Fits boosted trees to its rows and writes
them to the folder TABLES, where region_features.cpp includes them. Every tenth figure is kept apart,
and the reliability on these is printed.
"""

import argparse
import concurrent.futures
import pathlib
import subprocess

import numpy as np
from sklearn.ensemble import HistGradientBoostingClassifier

TABLES = {"pair": "one_part_trees.inc", "region": "figure_trees.inc"}
SIZES = {"pair": (120, 8), "region": (40, 8)}  # trees, and leaves of each
MOST_ROWS = 400  # of one picture
APART = 10


def lines_of(program, pictures):
    """Returns the words of each line that relievo-regions writes of pictures."""
    names = "".join(f"{file}\t{file.with_suffix('.parts.png')}\n" for file in pictures)
    done = subprocess.run([program], input=names, capture_output=True, text=True, check=True)
    return [line.split("\t") for line in done.stdout.splitlines()]


def rows_of(program, pictures, jobs=2):
    """Returns {kind: rows of picture, weight, truth and features} of all pictures."""
    starts = np.linspace(0, len(pictures), jobs + 1, dtype=int)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        written = pool.map(lambda k: lines_of(program, pictures[starts[k] : starts[k + 1]]), range(jobs))
        chunks = list(zip(starts, written))
    rng = np.random.default_rng(0)
    tables = {}
    for kind in TABLES:
        rows = np.array(
            [[start + int(line[1]), *map(float, line[2:])] for start, lines in chunks for line in lines if line[0] == kind]
        )
        kept = [
            rng.permutation(np.flatnonzero(rows[:, 0] == picture))[:MOST_ROWS]
            for picture in np.unique(rows[:, 0])
        ]
        tables[kind] = rows[np.concatenate(kept)]
    return tables


def nodes_of(tree):
    """Returns the lines of a tree, each node before its left and then its right branch."""
    lines = []

    def add(index):
        node = tree[index]
        at = len(lines)
        lines.append(None)
        if node["is_leaf"]:
            lines[at] = (-1, 0, float(node["value"]))
            return
        add(node["left"])
        right = len(lines)
        add(node["right"])
        lines[at] = (int(node["feature_idx"]), right, float(node["num_threshold"]))

    add(0)
    return lines


def literal(value):
    """Returns a float of C++."""
    text = f"{np.float32(value):.9g}"
    return (text if "." in text or "e" in text else text + ".0") + "F"


def write_table(model, file):
    """Writes {feature, right branch, threshold or log-odds} of all nodes; the first leaf is the prior."""
    first = float(model._baseline_prediction.ravel()[0])
    lines = [(-1, 0, first)]
    for (predictor,) in model._predictors:
        start = len(lines)
        lines += [(f, start + right if f >= 0 else 0, value) for f, right, value in nodes_of(predictor.nodes)]
    with file.open("w") as table:
        for feature, right, value in lines:
            print(f"{{{feature}, {right}, {literal(value)}}},", file=table)
    return len(lines)


def print_reliability(odds, truth, weights):
    print(f"{'stated':>10s}{'true':>10s}{'share':>10s}")
    stated = 1 / (1 + np.exp(-odds))
    for low in np.arange(0, 1, 0.1):
        here = (stated >= low) & (stated < low + 0.1)
        if weights[here].sum() > 0:
            true = np.average(truth[here], weights=weights[here])
            mean = np.average(stated[here], weights=weights[here])
            print(f"{mean:10.3f}{true:10.3f}{weights[here].sum() / weights.sum():10.3f}")


def learn(kind, rows, apart, file):
    """Fits trees to the rows of a kind, but for those apart, on which the reliability is printed."""
    weights, truth, features = rows[:, 1], rows[:, 2], rows[:, 3:]
    trees, leaves = SIZES[kind]
    model = HistGradientBoostingClassifier(
        max_iter=trees, max_leaf_nodes=leaves, learning_rate=0.15, min_samples_leaf=60, l2_regularization=1.0
    )
    model.fit(features[~apart], truth[~apart], sample_weight=weights[~apart])
    odds = model.decision_function(features[apart])
    right = np.average((odds > 0) == (truth[apart] > 0), weights=weights[apart])
    print(f"{kind}: {len(rows)} rows, {right:.3f} right of those apart, {write_table(model, file)} nodes")
    print_reliability(odds, truth[apart], weights[apart])


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    words.add_argument("program")
    words.add_argument("folder", type=pathlib.Path)
    words.add_argument("tables", type=pathlib.Path)
    given = words.parse_args()
    pictures = sorted(file for file in given.folder.glob("*.png") if ".parts" not in file.name)
    names = [file.name.split("-")[0] for file in pictures]
    figures = {name: k for k, name in enumerate(sorted(set(names)))}
    for kind, rows in rows_of(given.program, pictures).items():
        figure = np.array([figures[names[int(k)]] for k in rows[:, 0]])
        learn(kind, rows, figure % APART == 0, given.tables / TABLES[kind])


if __name__ == "__main__":
    main()
