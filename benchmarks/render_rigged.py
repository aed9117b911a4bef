#!/usr/bin/python3
"""Renders a rigged glTF character of one mesh and flat materials as a drawing, with the truth of its parts, order, depth and normals.

render_rigged.py CHARACTER.glb CLIP TIME YAW OUT [--lines parts|depth] [--px 800]

Parts are what bones move: head with neck, trunk, each ear, arm, leg and wing, tail. With `--lines parts` a line runs
between any two parts, with `depth` only where one hides another, so that legs grow out of the trunk without a line. TIME is a share of the
clip, YAW degrees. Writes the files of the shared tool render_truth.py, whose folder PYTHONPATH must name, for score_truth.py. Needs numpy and Pillow.
"""
import argparse
import json
import re
from pathlib import Path

import numpy as np
from PIL import Image
from render_truth import Glb, dilate, globals_of, raster

LIMBS = ("Ear", "Wing", "Tail", "Weapon")


def part_of_bone(name):
    """The part that a bone moves; sides are told by a last letter, as in `UpperArm.L`."""
    side = re.search(r"\.([LR])", name)
    side = side.group(1) if side else ""
    for limb in LIMBS:
        if name.startswith(limb):
            return limb + side
    if re.search("Arm|Hand|Palm|Finger|Thumb|Index|Middle|Ring|Pinky", name):
        return "Arm" + side
    if re.search("Leg|Foot|FF|FrontShoulder|BackShoulder|BackHip", name):
        ends = "Front" if "Front" in name or name.startswith("FF.") else "Back"
        return f"{ends}Leg{side}"
    return "Head" if re.search("Head|Neck|Mouth|Eye", name) else "Trunk"


def posed_mesh(glb, world):
    """Vertices, normals, material of each vertex, faces, part of each face, names of parts."""
    names, vertices, normals, materials, faces, owners = [], [], [], [], [], []
    count = 0
    for node in (n for n in glb.j["nodes"] if "mesh" in n and "skin" in n):
        skin = glb.j["skins"][node["skin"]]
        bind = glb.acc(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
        pose = np.stack([world[j] @ bind[k] for k, j in enumerate(skin["joints"])])
        parts = [part_of_bone(glb.j["nodes"][j]["name"]) for j in skin["joints"]]
        names += [p for p in dict.fromkeys(parts) if p not in names]
        for primitive in glb.j["meshes"][node["mesh"]]["primitives"]:
            has = primitive["attributes"]
            joints, weights = glb.acc(has["JOINTS_0"]).astype(int), glb.acc(has["WEIGHTS_0"])
            weights = weights / weights.sum(1, keepdims=True)
            moved = np.einsum("vk,vkab->vab", weights, pose[joints])
            position = glb.acc(has["POSITION"])
            vertices.append(np.einsum("vab,vb->va", moved, np.c_[position, np.ones(len(position))])[:, :3])
            normals.append(np.einsum("vab,vb->va", moved[:, :3, :3], glb.acc(has["NORMAL"])))
            materials.append(np.full(len(position), primitive["material"]))
            share = np.zeros((len(position), len(names)))
            number = np.array([names.index(p) for p in parts])
            for k in range(joints.shape[1]):
                np.add.at(share, (np.arange(len(position)), number[joints[:, k]]), weights[:, k])
            corners = glb.acc(primitive["indices"])[:, 0].reshape(-1, 3).astype(int)
            owners.append(share[corners].sum(1).argmax(1))
            faces.append(corners + count)
            count += len(position)
    return *map(np.concatenate, (vertices, normals, materials, faces, owners)), names


def back_to_front(ahead):
    order, left = [], list(range(len(ahead)))
    while left:
        k = min(left, key=lambda i: sum(max(0, ahead[i, j] - ahead[j, i]) for j in left))
        order.append(k)
        left.remove(k)
    return order


def colours(glb):
    linear = np.array([m.get("pbrMetallicRoughness", {}).get("baseColorFactor", [0.8, 0.8, 0.8, 1])[:3] for m in glb.j["materials"]])
    return np.round(255 * np.clip(linear, 0, 1) ** (1 / 2.2)).astype(np.uint8)


def lines_of(label, depth, px, between_parts):
    edge = np.zeros(label.shape, bool)
    ground = (label > 0).astype(int)
    for axis in (0, 1):
        jump = np.diff(ground if not between_parts else label.astype(int), axis=axis) != 0
        jump |= np.abs(np.diff(depth, axis=axis)) > 0.02 * px
        edge |= np.pad(jump, [(0, 1), (0, 0)] if axis == 0 else [(0, 0), (0, 1)])
    return dilate(edge, 2)


def render(args):
    glb = Glb(args.character)
    x, n, material, faces, owner, names = posed_mesh(glb, globals_of(glb, args.clip, args.time))
    yaw = np.radians(args.yaw)
    turn = np.array([[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]])
    x, n = x @ turn.T, n @ turn.T
    low, high = x.min(0), x.max(0)
    scale = (args.px - 80) / max(high[:2] - low[:2])
    w, h = ((high[:2] - low[:2]) * scale + 80).astype(int)
    x = np.c_[(x[:, 0] - low[0]) * scale + 40, h - ((x[:, 1] - low[1]) * scale + 40), x[:, 2] * scale]
    uv = np.c_[material, material].astype(float)
    layers = [(names[k], *raster(x, n, uv, faces[owner == k], w, h)) for k in np.unique(owner)]
    seen = [np.isfinite(layer[1]) for layer in layers]
    ahead = np.array([[int((a[1] > b[1])[p & q].sum()) for b, q in zip(layers, seen)] for a, p in zip(layers, seen)])
    order = back_to_front(ahead)
    layers, ahead = [layers[k] for k in order], ahead[np.ix_(order, order)]
    heights = np.stack([layer[1] for layer in layers])
    top, figure = heights.argmax(0), np.isfinite(heights.max(0))
    take = lambda k: np.take_along_axis(np.stack([layer[k] for layer in layers]), top[None, ..., None], 0)[0]
    normal = take(2)
    normal = np.where(normal[..., 2:] < 0, -normal, normal)
    paint = colours(glb)[np.clip(take(3)[..., 0].round().astype(int), 0, len(glb.j["materials"]) - 1)]
    depth = np.where(figure, heights.max(0), 0)
    write(args, layers, ahead, np.where(figure, top + 1, 0).astype(np.uint8), depth, normal, paint)


def write(args, layers, ahead, label, depth, normal, paint):
    out, figure = Path(args.out), label > 0
    (out / "parts").mkdir(parents=True, exist_ok=True)
    ink = lines_of(label, depth, args.px, args.lines == "parts")
    drawing = np.where(figure[..., None], paint, 255).astype(np.uint8)
    drawing[ink] = (35, 30, 40)
    near, far = depth[figure].max(), depth[figure].min()
    deep = np.where(figure, 1 + (depth - far) / (near - far) * 65534, 0).astype(np.uint16)
    pictures = {"drawing": drawing, "lineart": np.where(ink, 0, 255).astype(np.uint8), "labels": label, "depth_front_u16": deep,
                "normals": np.where(figure[..., None], (normal + 1) * 127.5, 0).round().astype(np.uint8)}
    for name, picture in pictures.items():
        Image.fromarray(picture).save(out / f"{name}.png")
    for k, layer in enumerate(layers):
        Image.fromarray((np.isfinite(layer[1]) * 255).astype(np.uint8)).save(out / "parts" / f"{k + 1:02d}_{layer[0]}.png")
    pairs = [(i + 1, j + 1, ahead[i, j], ahead[j, i]) for i in range(len(ahead)) for j in range(len(ahead)) if ahead[i, j] > ahead[j, i]]
    rows = ["front\tback\tpx\tpx_reverse"] + ["\t".join(map(str, pair)) for pair in pairs]
    (out / "pairs.tsv").write_text("\n".join(rows) + "\n")
    (out / "camera.json").write_text(json.dumps({"character": Path(args.character).name, "clip": args.clip, "time": args.time, "yaw": args.yaw}))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, kind in (("character", str), ("clip", str), ("time", float), ("yaw", float), ("out", str)):
        parser.add_argument(name, type=kind)
    parser.add_argument("--lines", choices=("parts", "depth"), default="parts")
    parser.add_argument("--px", type=int, default=800)
    render(parser.parse_args())
