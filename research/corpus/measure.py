"""Measures what was understood of a flat picture against what is known of its figure."""

import manners
import numpy as np
from scipy import ndimage

LEAST_PART = 0.004  # of the figure's area; smaller parts do not count
CONTOUR_REACH = 2 / 800  # of the size
LEAST_SHARED = 0.01  # of the size: border of a pair that counts
LEAST_OVERLAP = 0.1  # of the smaller whole part: overlap that shows which of a pair is in front


def filled(outline, scale, size):
    """Returns the pixels whose centres lie inside a region, rings by the even-odd rule."""
    crossings = np.zeros((size[1], size[0] + 1), np.uint8)
    for ring in outline:
        x, y = np.asarray(ring, float).T * scale - 0.5
        next_x, next_y = np.roll(x, -1), np.roll(y, -1)
        first = np.ceil(np.minimum(y, next_y)).clip(0, size[1]).astype(int)
        rows = np.ceil(np.maximum(y, next_y)).clip(0, size[1]).astype(int) - first
        edge = np.repeat(np.arange(len(x)), rows)
        row = np.arange(len(edge)) - np.repeat(np.cumsum(rows) - rows, rows) + first[edge]
        share = (row - y[edge]) / (next_y - y)[edge]
        column = np.ceil(x[edge] + share * (next_x - x)[edge]).clip(0, size[0]).astype(int)
        np.add.at(crossings, (row, column), 1)
    return np.cumsum(crossings, 1, np.uint8)[:, :-1] % 2 == 1


def whole_parts(scene, side):
    """Returns the whole parts of a scene, back to front, in a picture of the given longest side."""
    width, height = scene["canvas"]["width"], scene["canvas"]["height"]
    scale = side / max(width, height)
    size = max(1, round(width * scale)), max(1, round(height * scale))
    return [filled(part["outline"], scale, size) for part in scene["parts"]]


def visible_parts(wholes, shape):
    """Returns the map of visible parts: 0 none, k + 1 part k."""
    parts = np.zeros(shape, int)
    for k, whole in enumerate(wholes):
        parts[whole] = k + 1
    return parts


def pairs_of(scene):
    """Returns the joined pairs and those whose order is stated otherwise, by index."""
    index = {part["id"]: k for k, part in enumerate(scene["parts"])}
    joins = {(index[one["upper"]], index[one["lower"]]) for one in scene.get("joins", [])}
    level = set()
    for one in scene.get("relations", []):
        pair = index[one["upper"]], index[one["lower"]]
        (joins if one["relation"] == "joined" else level).add(pair)
    return joins, level


def fitted(parts, shape):
    rows = ((np.arange(shape[0]) + 0.5) * parts.shape[0] / shape[0]).astype(int)
    columns = ((np.arange(shape[1]) + 0.5) * parts.shape[1] / shape[1]).astype(int)
    return parts[rows][:, columns]


def pieces(parts):
    """Returns the map of the connected pieces of visible parts: a drawing does not show that two eyes,
    or the ends of a belt on both sides of an arm, are one part."""
    found = np.zeros(parts.shape, int)
    for part in np.unique(parts[parts > 0]):
        label, _ = ndimage.label(parts == part)
        found = np.where(label > 0, label + found.max(), found)
    return found


def matches(true, found):
    """Returns {found part: true part} of parts that share half of their union, and both counts."""
    figure = (true > 0).sum()
    sizes = [np.bincount(parts.ravel(), minlength=2) for parts in (true, found)]
    large = [{k for k in np.flatnonzero(size) if k and size[k] > LEAST_PART * figure} for size in sizes]
    shared = np.zeros((len(sizes[0]), len(sizes[1])), int)
    np.add.at(shared, (true.ravel(), found.ravel()), 1)
    pairs = {}
    for t in large[0]:
        for f in large[1]:
            if 2 * shared[t, f] >= sizes[0][t] + sizes[1][f] - shared[t, f]:
                pairs[f] = t
    return pairs, len(large[0]), len(large[1])


def f1(hits, wanted, got):
    return 2 * hits / (wanted + got) if wanted + got else 1.0


def variation_of_information(true, found):
    """Returns the variation of information inside the true figure, bits."""
    inside = true > 0
    _, joint = np.unique(true[inside] * 100003 + found[inside], return_counts=True)
    entropies = []
    for parts in (true, found):
        _, counts = np.unique(parts[inside], return_counts=True)
        share = counts / counts.sum()
        entropies.append(-(share * np.log2(share)).sum())
    share = joint / joint.sum()
    return 2 * -(share * np.log2(share)).sum() - sum(entropies)


def contour_f1(true, found, pixel):
    reach = max(1.5, CONTOUR_REACH * max(true.shape), pixel)
    edges = [manners.borders(true), manners.borders(found)]
    far = [ndimage.distance_transform_edt(~one) for one in edges]
    hit = [(far[1 - k][edges[k]] <= reach).mean() if edges[k].any() else 0.0 for k in range(2)]
    return 2 * hit[0] * hit[1] / (hit[0] + hit[1]) if sum(hit) else 0.0


def neighbours(parts):
    """Returns {(a, b), a < b: length of the border that two parts share, px}."""
    lengths = {}
    for a, b in ((parts[:-1], parts[1:]), (parts[:, :-1], parts[:, 1:])):
        differ = (a != b) & (a > 0) & (b > 0)
        low, high = np.minimum(a, b)[differ], np.maximum(a, b)[differ]
        keys, counts = np.unique(low * 100003 + high, return_counts=True)
        for key, count in zip(keys, counts):
            pair = int(key // 100003), int(key % 100003)
            lengths[pair] = lengths.get(pair, 0) + int(count)
    return lengths


def ordered_pairs(scene, wholes, parts, least):
    """Returns the pairs (upper, lower) of parts that border on each other and overlap by more than a
    share of the smaller one, numbered from 1, without those on one level."""
    level = pairs_of(scene)[1]
    found = set()
    for (a, b), length in neighbours(parts).items():
        lower, upper = a - 1, b - 1
        if length < LEAST_SHARED * max(parts.shape) or {(upper, lower), (lower, upper)} & level:
            continue
        smaller = min(wholes[upper].sum(), wholes[lower].sum())
        if (wholes[upper] & wholes[lower]).sum() > least * smaller:
            found.add((b, a))
    return found


def renamed(pairs, names):
    return {(names[a], names[b]) for a, b in pairs if a in names and b in names}


def compare(true, found, pixel):
    """Returns the figures of merit of one picture. `true` and `found`: (map of visible parts, whole
    parts, scene). `pixel`: side of the picture's pixels in the true map."""
    parts, seen = true[0], fitted(found[0], true[0].shape)
    pairs = matches(parts, seen)[0]
    true_pieces, seen_pieces = pieces(parts), pieces(seen)
    same, wanted, got = matches(true_pieces, seen_pieces)
    truth = ordered_pairs(true[2], true[1], visible_parts(true[1], true[1][0].shape), LEAST_OVERLAP)
    known = set(pairs.values())
    truth = {pair for pair in truth if set(pair) <= known}
    ordered = {frozenset(pair) for pair in truth}
    in_pairs = renamed(ordered_pairs(found[2], found[1], found[0], 0), pairs)
    in_pairs = {pair for pair in in_pairs if frozenset(pair) in ordered}
    joins = {(a + 1, b + 1) for a, b in pairs_of(true[2])[0]}
    joins = {pair for pair in joins if set(pair) <= known}
    in_joins = renamed({(a + 1, b + 1) for a, b in pairs_of(found[2])[0]}, pairs)
    union = ((parts > 0) | (seen > 0)).sum()
    return {
        "figure": ((parts > 0) & (seen > 0)).sum() / max(1, union),
        "parts": f1(len(same), wanted, got),
        "information": variation_of_information(true_pieces, seen_pieces),
        "contours": contour_f1(parts, seen, pixel),
        "pairs": f1(len(in_pairs & truth), len(truth), len(in_pairs)),
        "joins": f1(len(in_joins & joins), len(joins), len(in_joins)),
    }
