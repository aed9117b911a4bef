"""The add-on inside Blender, without windows: blender -b --factory-startup --python addon_test.py --
module|program DRAWING PICTURE. The program is on the path, the module on PYTHONPATH. Renders PICTURE."""

import math
import os
import pathlib
import sys

import bpy
import numpy as np

WAY, DRAWING, PICTURE = sys.argv[sys.argv.index("--") + 1 :]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings/blender"))
if WAY == "program":
    sys.modules["relievo"] = None  # as where it is not installed

import relievo_addon  # noqa: E402


def positions(thing):
    values = np.empty(3 * len(thing.data.vertices), np.float32)
    thing.data.vertices.foreach_get("co", values)
    return values.reshape(-1, 3)


def import_drawing():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    assert bpy.ops.import_scene.relievo(filepath=DRAWING, vertices=5000) == {"FINISHED"}
    wolf = bpy.context.object
    assert wolf.name == "wolf" and len(wolf.data.polygons) > 5000
    assert {"body", "near-ear", "tail"} <= {group.name for group in wolf.vertex_groups}
    assert all(len(vertex.groups) == 1 for vertex in wolf.data.vertices)
    extent = np.ptp(positions(wolf), axis=0)
    assert abs(extent.max() - 2) < 1e-3 and extent[0] > extent[2] > extent[1]
    picture = next(n for n in wolf.data.materials[0].node_tree.nodes if n.type == "TEX_IMAGE").image
    assert picture.packed_file and picture.size[0] > 500
    uv = np.empty(2 * len(wolf.data.loops), np.float32)
    wolf.data.uv_layers[0].data.foreach_get("uv", uv)
    assert 0 <= uv.min() and uv.max() <= 1 and uv.std() > 0.1
    front = np.array([p.normal.y for p in wolf.data.polygons])
    assert (front < 0).mean() > 0.6
    return wolf


def move_sliders(wolf):
    before, mesh = positions(wolf), wolf.data
    wolf.location.x = 1
    wolf.relievo.own_shape = False
    wolf.relievo.c = 1
    shallow = positions(wolf)
    assert wolf.data == mesh and wolf.location.x == 1 and len(mesh.materials) == 2
    wolf.relievo.c = 9
    deep = positions(wolf)
    assert np.ptp(deep[:, 1]) > 1.5 * np.ptp(shallow[:, 1])
    wolf.relievo.own_shape = True
    assert np.abs(positions(wolf) - before).max() < 1e-4
    wolf.relievo.vertices = 2000
    assert len(wolf.data.vertices) < 0.7 * len(before)
    assert len([i for i in bpy.data.images if i.packed_file]) == 1
    wolf.relievo.vertices = 20000
    wolf.location.x = 0


def ring(layer, middle, radius):
    stroke = (layer.frames[0] if len(layer.frames) else layer.frames.new(1)).strokes.new()
    stroke.points.add(48)
    for i, point in enumerate(stroke.points):
        turn = 2 * math.pi * i / 48
        point.co = (middle[0] + radius * math.cos(turn), 0, middle[1] + radius * math.sin(turn))


def draw_strokes():
    pencil = bpy.data.objects.new("pencil", bpy.data.grease_pencils.new("pencil"))
    bpy.context.collection.objects.link(pencil)
    colour = bpy.data.materials.new("red")
    bpy.data.materials.create_gpencil_data(colour)
    colour.grease_pencil.show_fill = True
    colour.grease_pencil.fill_color = (0.6, 0.05, 0.05, 1)
    pencil.data.materials.append(colour)
    for name, middle, radius in (("ball", (0, 0), 1), ("nose", (0.2, -0.1), 0.3)):
        layer = pencil.data.layers.new(name)
        ring(layer, middle, radius)
    pencil.location = (3, 0, 0.5)
    bpy.context.view_layer.update()
    bpy.context.view_layer.objects.active = pencil
    return pencil


def relief_of_strokes():
    pencil = draw_strokes()
    assert bpy.ops.object.relievo_strokes() == {"FINISHED"}
    relief = bpy.context.object
    assert [group.name for group in relief.vertex_groups] == ["ball 1", "nose 2"]
    bpy.context.view_layer.update()
    world = positions(relief) + np.array(relief.location)
    # The strokes' circle, to a chord of the polygon.
    np.testing.assert_allclose(world[:, [0, 2]].min(0), [2, -0.5], atol=0.01)
    np.testing.assert_allclose(world[:, [0, 2]].max(0), [4, 1.5], atol=0.01)
    assert 0.9 < -positions(relief)[:, 1].min() < 1.6
    ring(pencil.data.layers[1], (-0.5, 0.5), 0.2)
    assert bpy.ops.object.relievo_rebuild() == {"FINISHED"}
    assert len(relief.vertex_groups) == 3


def failures_are_told():
    before = len(bpy.data.objects), len(bpy.data.meshes)
    for name, text in (("nothing.svg", None), ("bad.svg", "no drawing")):
        path = pathlib.Path(bpy.app.tempdir, name)
        if text:
            path.write_text(text)
        try:
            bpy.ops.import_scene.relievo(filepath=str(path))
        except RuntimeError as error:
            assert name in str(error), error
        else:
            raise AssertionError(f"{name} was taken")
    assert (len(bpy.data.objects), len(bpy.data.meshes)) == before


def render():
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 64, False
    scene.render.resolution_x, scene.render.resolution_y = 720, 400
    scene.render.filepath = PICTURE
    scene.view_settings.view_transform = "Standard"
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.rotation_euler = 2, (math.radians(60), 0, math.radians(-50))
    camera.location, camera.rotation_euler = (-1.6, -7, 0.9), (math.radians(85), 0, math.radians(-24))
    for thing in (camera, sun):
        scene.collection.objects.link(thing)
    scene.camera = camera
    scene.world = scene.world or bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.5, 0.5, 0.5, 1)
    bpy.data.objects["pencil"].hide_render = True
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(PICTURE)
    pixels = np.array(picture.pixels[:]).reshape(400, 720, 4)[..., :3]
    assert pixels.std() > 0.05
    assert (pixels[..., 0] - pixels[..., 2] > 0.15).mean() > 0.01, "no red ball"
    assert (pixels[..., 2] - pixels[..., 0] > 0.05).mean() > 0.02, "no blue wolf"


try:
    relievo_addon.register()
    move_sliders(import_drawing())
    relief_of_strokes()
    failures_are_told()
    render()
    relievo_addon.unregister()
except BaseException:
    import traceback

    traceback.print_exc()
    sys.stdout.flush()
    os._exit(1)
print(f"blender: by the {WAY}: works")
