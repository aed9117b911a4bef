"""Converts models to meshes of Blender."""

import os
import tempfile

import bpy
import numpy as np


def set_mesh(thing, model):
    """Replaces the mesh of an object by a model, with its texture, normals, and a vertex group for each
    part. Contours have a material of their own. The front faces -Y."""
    mesh = thing.data
    mesh.clear_geometry()
    x, y, z = model.vertices.T
    mesh.vertices.add(len(model.vertices))
    mesh.vertices.foreach_set("co", np.stack([x, -z, y], 1).ravel())
    corners = model.faces.ravel()
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(model.faces))
    starts = np.arange(0, len(corners), 3, dtype=np.int32)
    mesh.polygons.foreach_set("loop_start", starts)
    if bpy.app.version < (4, 1):
        mesh.polygons.foreach_set("loop_total", np.full(len(starts), 3, np.int32))
        mesh.use_auto_smooth = True
    mesh.polygons.foreach_set("use_smooth", np.ones(len(starts), bool))
    is_ink = np.arange(len(starts)) >= len(starts) - model.ink_faces
    mesh.polygons.foreach_set("material_index", is_ink.astype(np.int32))
    layer = mesh.uv_layers.new(name="drawing")
    layer.data.foreach_set("uv", model.uvs[corners].astype(np.float32).ravel())
    mesh.validate(clean_customdata=False)
    mesh.update(calc_edges=True)
    a, b, c = model.normals.T
    mesh.normals_split_custom_set_from_vertices(np.stack([a, -c, b], 1))
    set_groups(thing, model.parts)
    set_materials(thing, model)


def set_materials(thing, model):
    """Gives the model's picture to the materials of an object. Materials that are missing are made."""
    if not model.picture:
        return
    materials = thing.data.materials
    picture = picture_of(thing.name, model.picture)
    for material in materials:
        if material:
            replace_picture(material, picture)
    if not materials:
        materials.append(textured(thing.name, picture, model.pixel_art))
    if model.ink_faces and len(materials) < 2:
        materials.append(inked(thing.name + " ink", picture))


def set_groups(thing, parts):
    thing.vertex_groups.clear()
    begin = 0
    for name, count in parts:
        thing.vertex_groups.new(name=name).add(list(range(begin, begin + count)), 1.0, "REPLACE")
        begin += count


def picture_of(name, png):
    """Loads a PNG file as an image packed into the .blend file."""
    handle, path = tempfile.mkstemp(suffix=".png")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(png)
        picture = bpy.data.images.load(path)
        picture.pack()
    finally:
        os.unlink(path)
    picture.name = name
    return picture


def textured(name, picture, pixel_art):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    texture = nodes.new("ShaderNodeTexImage")
    texture.image = picture
    if pixel_art:
        texture.interpolation = "Closest"
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Roughness"].default_value = 0.9
    links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    return material


def inked(name, picture):
    """Returns a material without light that shows from one side alone and casts no shadow."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.use_backface_culling = True
    if hasattr(material, "shadow_method"):
        material.blend_method, material.shadow_method = "CLIP", "NONE"
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    texture, light, glass = (nodes.new("ShaderNode" + kind) for kind in ("TexImage", "Emission", "BsdfTransparent"))
    texture.image = picture
    links.new(texture.outputs["Color"], light.inputs["Color"])
    # Transparent from behind, and for all rays but the camera's.
    side, ray = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeLightPath")
    seen = nodes.new("ShaderNodeMath")
    seen.operation = "SUBTRACT"
    seen.use_clamp = True
    links.new(ray.outputs["Is Camera Ray"], seen.inputs[0])
    links.new(side.outputs["Backfacing"], seen.inputs[1])
    mix, output = nodes.new("ShaderNodeMixShader"), nodes.new("ShaderNodeOutputMaterial")
    links.new(seen.outputs["Value"], mix.inputs["Fac"])
    links.new(glass.outputs["BSDF"], mix.inputs[1])
    links.new(light.outputs["Emission"], mix.inputs[2])
    links.new(mix.outputs["Shader"], output.inputs["Surface"])
    return material


def replace_picture(material, picture):
    for node in material.node_tree.nodes if material.use_nodes else []:
        if node.type == "TEX_IMAGE":
            old, node.image = node.image, picture
            if old and not old.users:
                bpy.data.images.remove(old)
