"""Imports models into Blender and prints the box of every object, in Blender's units, as JSON.

Usage: blender --background --factory-startup --python blender_extents.py -- FILE...
"""

import json
import sys

import bpy
import numpy

# Debian's reader of glTF is older than its numpy, which dropped this name.
numpy.bool = bool

IMPORTERS = {
    "glb": lambda name: bpy.ops.import_scene.gltf(filepath=name),
    "obj": lambda name: bpy.ops.wm.obj_import(filepath=name),
    "stl": lambda name: bpy.ops.import_mesh.stl(filepath=name),
}


def boxes(name):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    IMPORTERS[name.rsplit(".", 1)[1]](name)
    found = {}
    for thing in bpy.context.scene.objects:
        if thing.type != "MESH":
            continue
        corners = [thing.matrix_world @ v.co for v in thing.data.vertices]
        found[thing.name] = [[f(c[k] for c in corners) for k in range(3)] for f in (min, max)]
    return found


for file in sys.argv[sys.argv.index("--") + 1 :]:
    print("BOXES " + json.dumps(boxes(file)))
