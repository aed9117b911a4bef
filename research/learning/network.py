#!/usr/bin/python3
"""Trains the network that perceives figures and contours: network.py FOLDER WEIGHTS --steps N.

FOLDER holds pictures of paint.py. The network sees a picture on white with its alpha, and tells for
each cell of 2 x 2 pixels the log-odds that it belongs to the figure and that a contour of a visible
part runs through it, and the way across that contour to the part in front. WEIGHTS is the file that
the core decodes (see perception/network.h). It is written from time to time; training can go on from it.
"""

import argparse
import json
import math
import pathlib
import struct
import sys

import numpy as np
import torch
import torch.nn.functional as F
from PIL import Image
from torch import nn

sys.path.append(str(pathlib.Path(__file__).parent.parent / "corpus"))
import measure
import table

SIDE = 512
CHANNELS = (8, 16, 32, 48, 80)
BATCH = 8
FASTEST = 3e-3  # learning rate
GOING_ON = 1e-3  # the same where training goes on
SAVED = 1000  # steps after which the weights are written
# Sides of the pictures in training, from the share of the steps on.
SIDES = ((0, 256), (0.35, 384), (0.75, SIDE))


def layer(inputs, outputs, side=3, stride=1, dilation=1):
    convolution = nn.Conv2d(inputs, outputs, side, stride, dilation * (side // 2), dilation, bias=False)
    return nn.Sequential(convolution, nn.BatchNorm2d(outputs), nn.ReLU6())


class Network(nn.Module):
    """A U: each level halves the resolution, and is joined with the one below on the way back."""

    def __init__(self):
        super().__init__()
        inputs = (4, *CHANNELS)
        self.down = nn.ModuleList()
        for level, channels in enumerate(CHANNELS):
            first = layer(inputs[level], channels, 5 if level == 0 else 3, 2)
            self.down.append(nn.Sequential(first, layer(channels, channels, dilation=1 + level // 4)))
        self.deepest = layer(CHANNELS[-1], CHANNELS[-1], dilation=4)
        self.context = nn.Conv2d(CHANNELS[-1], CHANNELS[-1], 1)
        pairs = list(zip(CHANNELS[1:], CHANNELS))[::-1]
        self.up = nn.ModuleList(layer(deeper, channels, 1) for deeper, channels in pairs)
        self.merge = nn.ModuleList(layer(2 * channels, channels) for _, channels in pairs)
        self.head = nn.Conv2d(CHANNELS[0], 4, 1)

    def forward(self, image):
        levels = []
        for down in self.down:
            image = down(image)
            levels.append(image)
        image = self.deepest(levels.pop())
        image = F.relu6(image + self.context(image.mean((2, 3), keepdim=True)))
        for up, merge in zip(self.up, self.merge):
            raised = F.interpolate(up(image), scale_factor=2, mode="nearest")
            image = merge(torch.cat([levels.pop(), raised], 1))
        return self.head(image)

    def blocks(self):
        """Returns the layers in the order of the file."""
        blocks = [block for down in self.down for block in down] + [self.deepest, self.context]
        return blocks + [block for pair in zip(self.up, self.merge) for block in pair] + [self.head]

    def convolutions(self):
        """Yields the layers in the order of the file: weights, biases, and whether they are clamped."""
        for block in self.blocks():
            if isinstance(block, nn.Conv2d):
                yield block, block.weight, block.bias, False
            else:
                convolution, norm, _ = block
                gain = norm.weight / torch.sqrt(norm.running_var + norm.eps)
                weight = convolution.weight * gain[:, None, None, None]
                yield convolution, weight, norm.bias - norm.running_mean * gain, True


def write_weights(network, file):
    """Writes the weights with 8 bits each and a scale for each output."""
    layers = list(network.convolutions())
    data = b"RLVN" + struct.pack("<I", len(layers))
    for convolution, weight, bias, clamped in layers:
        values = weight.detach().permute(0, 2, 3, 1).numpy()
        scales = np.maximum(np.abs(values).reshape(len(values), -1).max(1), 1e-12) / 127
        rounded = np.clip(np.round(values / scales[:, None, None, None]), -127, 127)
        sizes = convolution.in_channels, convolution.out_channels, convolution.kernel_size[0]
        data += struct.pack("<6H", *sizes, convolution.stride[0], convolution.dilation[0], clamped)
        data += scales.astype("<f4").tobytes() + bias.detach().numpy().astype("<f4").tobytes()
        data += rounded.astype(np.int8).tobytes()
    file.write_bytes(data)


def read_weights(network, file, pictures):
    """Reads a file of write_weights. Each layer is normalised by the mean and variance of its outputs for
    some pictures, which changes nothing but how training goes on."""
    data, at = file.read_bytes(), 8

    def values(kind, *shape):
        nonlocal at
        array = np.frombuffer(data, kind, math.prod(shape), at).reshape(shape)
        at += array.nbytes
        return torch.from_numpy(array.astype(np.float32))

    def normalise(norm, outputs):
        norm.running_mean, norm.running_var = outputs.mean((0, 2, 3)), outputs.var((0, 2, 3))
        norm.bias += norm.running_mean
        norm.weight.copy_(torch.sqrt(norm.running_var + norm.eps))

    with torch.no_grad():
        handles = []
        for block in network.blocks():
            inputs, outputs, side, *_ = (int(size) for size in values("<u2", 6))
            scales, biases = values("<f4", outputs), values("<f4", outputs)
            weights = values(np.int8, outputs, side, side, inputs) * scales[:, None, None, None]
            convolution, biased = (block, block) if isinstance(block, nn.Conv2d) else block[:2]
            convolution.weight.copy_(weights.permute(0, 3, 1, 2))
            biased.bias.copy_(biases)
            if biased is not block:
                handles.append(
                    convolution.register_forward_hook(
                        lambda _, __, outputs, norm=biased: normalise(norm, outputs)
                    )
                )
        network.eval()(pictures)
        for handle in handles:
            handle.remove()


def in_square(image, side, mode):
    """Returns an image in the middle of a square."""
    pad = [(0, 0)] * image.ndim
    for axis in range(2):
        free = side - image.shape[axis]
        pad[axis] = free // 2, free - free // 2
    return np.pad(image, pad, mode=mode)


def example_of(file):
    """Returns a picture, SIDE x SIDE x 4, and its parts, half as large."""
    picture = Image.open(file).convert("RGBA")
    parts = np.asarray(Image.open(file.with_suffix(".parts.png")))
    scale = SIDE / max(picture.size)
    size = [max(8, round(scale * length)) for length in picture.size]
    picture = picture.resize(size, Image.Resampling.BILINEAR)
    parts = measure.fitted(parts, (size[1] // 2, size[0] // 2))
    return in_square(np.asarray(picture), SIDE, "edge"), in_square(parts, SIDE // 2, "constant")


def level_pairs(folder, one):
    """Returns the pairs of parts, numbered from 1, of which neither is in front."""
    scene = folder / f"{one}.json"
    level = np.zeros((64, 64), bool)
    if scene.exists():
        for a, b in measure.pairs_of(json.loads(scene.read_text()))[1]:
            if max(a, b) < 63:
                level[a + 1, b + 1] = level[b + 1, a + 1] = True
    return level


class Examples:
    """All pictures of a folder, in memory, and batches of them, changed at random."""

    def __init__(self, folder):
        files = sorted(file for file in folder.glob("*.png") if ".parts" not in file.name)
        self.pictures = np.zeros((len(files), SIDE, SIDE, 4), np.uint8)
        self.parts = np.zeros((len(files), SIDE // 2, SIDE // 2), np.uint8)
        for k, file in enumerate(files):
            self.pictures[k], self.parts[k] = example_of(file)
        self.level = np.stack([level_pairs(folder, file.name.split("-")[0]) for file in files])
        self.rng = np.random.default_rng(0)

    def batch(self, side):
        rng = self.rng
        chosen = np.sort(rng.choice(len(self.pictures), BATCH, replace=False))
        pictures = torch.from_numpy(self.pictures[chosen].astype(np.float32) / 255).permute(0, 3, 1, 2)
        colour, alpha = pictures[:, :3], pictures[:, 3:]
        pictures = torch.cat([colour * alpha + 1 - alpha, alpha], 1)
        parts = torch.from_numpy(self.parts[chosen].astype(np.float32))[:, None]
        turn = placements(rng)
        grid = F.affine_grid(turn, (BATCH, 4, side, side), align_corners=False)
        pictures = F.grid_sample(pictures, grid, padding_mode="border", align_corners=False)
        grid = F.affine_grid(turn, (BATCH, 1, side // 2, side // 2), align_corners=False)
        parts = F.grid_sample(parts, grid, mode="nearest", align_corners=False)[:, 0].long()
        for picture in pictures:
            recolour(picture, rng)
        return pictures, parts, torch.from_numpy(self.level[chosen])


def placements(rng):
    """Returns random mirrorings, rotations, scalings and shifts."""
    angle = rng.uniform(-0.2, 0.2, BATCH) * (rng.random(BATCH) < 0.5)
    scale = np.exp(rng.uniform(-0.45, 0.45, BATCH))
    mirror = np.where(rng.random(BATCH) < 0.5, -1, 1)
    turn = np.zeros((BATCH, 2, 3), np.float32)
    turn[:, 0, 0], turn[:, 0, 1] = mirror * scale * np.cos(angle), -scale * np.sin(angle)
    turn[:, 1, 0], turn[:, 1, 1] = mirror * scale * np.sin(angle), scale * np.cos(angle)
    turn[:, :, 2] = rng.uniform(-0.12, 0.12, (BATCH, 2))
    return torch.from_numpy(turn)


def recolour(picture, rng):
    """Changes the colours of a picture, in place."""
    if rng.random() < 0.3:
        picture[:3] = picture[:3][torch.from_numpy(rng.permutation(3))]
    if rng.random() < 0.4:
        picture[:3] = picture[:3].clamp(min=1e-4) ** math.exp(rng.uniform(-0.3, 0.3))
    if rng.random() < 0.3:
        picture[:3] *= torch.from_numpy(rng.uniform(0.85, 1, (3, 1, 1)).astype(np.float32))
    if rng.random() < 0.15:
        picture[:3] = picture[:3].mean(0, keepdim=True)


def moved(image, down, right):
    return torch.roll(image, (-down, -right), (-2, -1))


def contours_of(parts):
    """Returns where a cell differs from one of its four neighbours."""
    edges = torch.zeros(parts.shape, dtype=torch.bool)
    for axis in (1, 2):
        length = parts.shape[axis] - 1
        differ = parts.narrow(axis, 1, length) != parts.narrow(axis, 0, length)
        edges.narrow(axis, 0, length).logical_or_(differ)
        edges.narrow(axis, 1, length).logical_or_(differ)
    return edges.float()


def fronts_of(parts, level):
    """Returns unit vectors across contours to the parts in front, and their weights."""
    ways = torch.zeros(parts.shape[0], 2, *parts.shape[1:])
    between = torch.zeros(parts.shape, dtype=torch.bool)
    batch = torch.arange(len(parts))[:, None, None].expand_as(parts)
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1), (0, 2), (2, 0)):
        ahead, behind = moved(parts, down, right), moved(parts, -down, -right)
        known = ~level[batch, ahead.clamp(max=63), behind.clamp(max=63)]
        sign = torch.sign((ahead - behind).float()) * known / math.hypot(down, right)
        ways[:, 0] += sign * right
        ways[:, 1] += sign * down
        between |= (ahead != behind) & (ahead > 0) & (behind > 0)
    length = ways.norm(dim=1)
    # Contours of the figure itself are easily told.
    weights = (length > 0.5) * torch.where(between, 1.0, 0.1)
    return ways / length.clamp(min=1e-6)[:, None], weights


def loss_of(seen, parts, level):
    figure = F.binary_cross_entropy_with_logits(seen[:, 0], (parts > 0).float())
    edges = contours_of(parts)
    beside = F.max_pool2d(edges[:, None], 3, 1, 1)[:, 0] - edges
    weights = 3 * edges + (1 - edges) * (1 - beside)  # a contour may be a cell off
    contour = F.binary_cross_entropy_with_logits(seen[:, 1], edges, weights, reduction="sum") / weights.sum()
    ways, weights = fronts_of(parts, level)
    front = (((seen[:, 2:] - ways) ** 2).sum(1) * weights).sum() / weights.sum().clamp(min=1)
    return torch.stack([2 * figure, 2 * contour, 0.5 * front])


def train(network, examples, steps, fastest, file, report=200):
    optimizer = torch.optim.AdamW(network.parameters(), lr=fastest, weight_decay=1e-4)
    network.to(memory_format=torch.channels_last).train()
    mean = torch.zeros(3)
    for step in range(steps):
        done = step / steps
        rate = fastest * min(1, (step + 1) / 200) * (0.5 + 0.5 * math.cos(math.pi * done)) + 2e-5
        for group in optimizer.param_groups:
            group["lr"] = rate
        side = next(side for share, side in reversed(SIDES) if done >= share)
        pictures, parts, level = examples.batch(side)
        losses = loss_of(network(pictures.contiguous(memory_format=torch.channels_last)), parts, level)
        optimizer.zero_grad()
        losses.sum().backward()
        optimizer.step()
        mean += losses.detach() / report
        if step % report == report - 1:
            print(step + 1, *(f"{value:.4f}" for value in mean), flush=True)
            mean.zero_()
        if step % SAVED == SAVED - 1 or step == steps - 1:
            write_weights(network.eval(), file)
            network.train()


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    words.add_argument("folder", type=pathlib.Path)
    words.add_argument("weights", type=pathlib.Path)
    words.add_argument("--steps", type=int, default=9000)
    words.add_argument("--go-on", action="store_true", help="from WEIGHTS")
    given = words.parse_args()
    table.keep_memory()
    torch.manual_seed(0)
    network = Network()
    examples = Examples(given.folder)
    if given.go_on:
        read_weights(network, given.weights, torch.cat([examples.batch(SIDE)[0] for _ in range(4)]))
    train(network, examples, given.steps, GOING_ON if given.go_on else FASTEST, given.weights)


if __name__ == "__main__":
    main()
