"""Reads models written by Relievo."""

import json
import struct

import numpy as np

KINDS = {5125: np.uint32, 5123: np.uint16, 5126: np.float32}
NEAREST = 9728
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


class Model:
    """A model as arrays.

    `vertices` is n x 3 in units (x right, y up, z to the viewer, the middle of the drawing at 0),
    `normals` n x 3, `uvs` n x 2 with v up, `faces` m x 3. `parts` lists the name and the number of
    vertices of each part, in order. `picture` is a PNG file or None; that of
    `pixel_art` is shown without smoothing. The last `ink_faces` faces are contours, seen from one side
    and without light; they are the last part. The canvas point (px, py), y down,
    is at (scale * (px - origin[0]), scale * (height - py - origin[1]))."""

    def __init__(self, data):
        length = struct.unpack_from("<I", data, 12)[0]
        self._tree = json.loads(data[20 : 20 + length])
        self._chunk = memoryview(data)[28 + length :]
        scene = self._tree["scenes"][0]["extras"]
        self.scale, self.origin = scene["scale"], scene["origin"]
        self.canvas = scene["canvas"]
        nodes = [node for node in self._tree["nodes"] if "mesh" in node]
        parts = [node for node in nodes if "part" in node["extras"]]
        ink = [node for node in nodes if "part" not in node["extras"]]
        meshes = [self._tree["meshes"][node["mesh"]]["primitives"][0] for node in parts + ink]
        columns = {name: [self._array(mesh["attributes"][name]) for mesh in meshes]
                   for name in ("POSITION", "TEXCOORD_0") if name in meshes[0]["attributes"]}
        counts = [len(part) for part in columns["POSITION"]]
        first = np.cumsum([0] + counts[:-1])
        self.parts = [(node["extras"].get("part", node["name"]), count)
                      for node, count in zip(parts + ink, counts)]
        self.vertices = np.concatenate(columns["POSITION"])
        self.normals = np.concatenate(
            [self._array(mesh["attributes"]["NORMAL"]) if "NORMAL" in mesh["attributes"]
             else np.tile(np.float32([0, 0, 1]), (count, 1)) for mesh, count in zip(meshes, counts)])
        self.uvs = np.zeros((len(self.vertices), 2), np.float32)
        if "TEXCOORD_0" in columns:
            self.uvs = np.concatenate(columns["TEXCOORD_0"]) * (1, -1) + (0, 1)
        self.faces = np.concatenate(
            [self._array(mesh["indices"]).reshape(-1, 3).astype(np.int32) + begin
             for mesh, begin in zip(meshes, first)])
        self.ink_faces = sum(self._tree["accessors"][mesh["indices"]]["count"] // 3
                             for mesh in meshes[len(parts):])
        images = self._tree.get("images")
        self.picture = bytes(self._view(images[0]["bufferView"])) if images else None
        samplers = self._tree.get("samplers", [{}])
        self.pixel_art = samplers[0].get("magFilter") == NEAREST

    def _view(self, index):
        view = self._tree["bufferViews"][index]
        begin = view.get("byteOffset", 0)
        return self._chunk[begin : begin + view["byteLength"]]

    def _array(self, index):
        accessor = self._tree["accessors"][index]
        kind, width = KINDS[accessor["componentType"]], WIDTHS[accessor["type"]]
        values = np.frombuffer(self._view(accessor["bufferView"]), kind, accessor["count"] * width,
                               accessor.get("byteOffset", 0))
        return values.reshape(-1, width) if width > 1 else values
