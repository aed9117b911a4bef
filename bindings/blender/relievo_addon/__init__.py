"""Turns drawings into reliefs: File > Import > Drawing as relief, and Object > Relief of strokes."""

import pathlib

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty
from bpy_extras.io_utils import ImportHelper
from mathutils import Vector

from . import builder, relief_mesh, strokes

bl_info = {
    "name": "Relievo",
    "description": "Drawings and Grease Pencil strokes as seamless high reliefs",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Import, Object, and the sidebar",
    "category": "Import-Export",
}

WAIT = 0.2  #: delay from the last change of a slider to the rebuild, s


def rebuild(thing):
    """Rebuilds the relief of an object in place. Raises builder.BuildError."""
    relief = thing.relievo
    source = bpy.path.abspath(relief.source)
    settings = {
        "vertices": relief.vertices,
        "method": relief.method,
        "rho": relief.rho,
        "size": relief.size,
        "shape": None if relief.own_shape else (relief.c, relief.flat),
    }
    addon = bpy.context.preferences.addons.get(__package__)
    program = addon.preferences.program if addon else ""
    if relief.strokes:
        model = build_strokes(thing, settings, program)
    else:
        model = builder.build(thing.name, source, settings, program)
    relief_mesh.set_mesh(thing, model)


def build_strokes(thing, settings, program):
    """Builds the model of the strokes, in their place and size."""
    try:
        text, (left, top, unit) = strokes.to_svg(thing.relievo.strokes)
    except ValueError as error:
        raise builder.BuildError(str(error)) from error
    file = pathlib.Path(bpy.app.tempdir, f"{thing.name_full}.svg".replace("/", "_"))
    if not file.exists() or file.read_text() != text:
        file.write_text(text)
    model = builder.build(thing.name, str(file), settings, program)
    model.vertices = model.vertices * (unit / model.scale)
    thing.location = Vector((left + unit * model.origin[0], thing.relievo.strokes.location.y,
                             top - unit * (model.canvas[1] - model.origin[1])))
    return model


def later(relief, context):
    """Rebuilds after a slider has rested; at once if Blender runs without windows."""
    thing = relief.id_data
    if not isinstance(thing, bpy.types.Object) or thing.type != "MESH" or relief.quiet:
        return
    if bpy.app.background:
        rebuild(thing)
        return
    name = thing.name

    def now():
        try:
            rebuild(bpy.data.objects[name])
        except (KeyError, builder.BuildError) as error:
            print(f"Relievo: {error}")

    old = waiting.get(name)
    if old and bpy.app.timers.is_registered(old):
        bpy.app.timers.unregister(old)
    waiting[name] = now
    bpy.app.timers.register(now, first_interval=WAIT)


#: The timers that wait for sliders to rest, by names of objects.
waiting = {}


class ReliefSettings(bpy.types.PropertyGroup):
    source: StringProperty(name="Drawing", subtype="FILE_PATH")
    strokes: PointerProperty(name="Strokes", type=bpy.types.Object)
    quiet: BoolProperty(options={"HIDDEN", "SKIP_SAVE"})
    vertices: IntProperty(name="Vertices", default=20000, min=100, max=1000000, update=later)
    method: EnumProperty(name="Method", update=later, items=[
        ("approximate", "Approximate", "Solves inflation, then depth order"),
        ("nonlinear", "Non-linear", "Solves both together")])
    rho: FloatProperty(name="Softness", description="Softness of ramps beside joins", default=0.25, min=0.01,
                       max=0.5, update=later)
    own_shape: BoolProperty(name="Shape from drawing", default=True, update=later)
    c: FloatProperty(name="Inflation", default=4, min=0.01, max=20, update=later)
    flat: FloatProperty(name="Flatness", default=0, min=0, max=1, update=later)
    size: FloatProperty(name="Size", default=2, min=0.001, subtype="DISTANCE", update=later)


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    program: StringProperty(name="Program", subtype="FILE_PATH",
                            description="The relievo program, used if the Python module is missing. Empty: search the path")

    def draw(self, context):
        self.layout.prop(self, "program")


def add_relief(operator, context, name, **settings):
    """Adds an object with the relief. Leaves none if it cannot be built."""
    thing = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    relief = thing.relievo
    relief.quiet = True
    for key, value in settings.items():
        setattr(relief, key, value)
    relief.quiet = False
    try:
        rebuild(thing)
    except builder.BuildError as error:
        mesh = thing.data
        bpy.data.objects.remove(thing)
        bpy.data.meshes.remove(mesh)
        operator.report({"ERROR"}, str(error))
        return {"CANCELLED"}
    context.collection.objects.link(thing)
    for other in context.selected_objects:
        other.select_set(False)
    thing.select_set(True)
    context.view_layer.objects.active = thing
    return {"FINISHED"}


class ImportRelief(bpy.types.Operator, ImportHelper):
    """Build the relief of a drawing"""

    bl_idname = "import_scene.relievo"
    bl_label = "Drawing as relief"
    bl_options = {"REGISTER", "UNDO"}
    filter_glob: StringProperty(default="*.svg;*.ora;*.psd;*.png;*.jpg;*.gif;*.relievo;*.json",
                                options={"HIDDEN"})
    vertices: IntProperty(name="Vertices", default=20000, min=100, max=1000000)

    def execute(self, context):
        path = pathlib.Path(self.filepath)
        return add_relief(self, context, path.stem, source=str(path), vertices=self.vertices)


class ReliefOfStrokes(bpy.types.Operator):
    """Build the relief of the active Grease Pencil object. Each stroke becomes a part"""

    bl_idname = "object.relievo_strokes"
    bl_label = "Relief of strokes"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "GPENCIL"

    def execute(self, context):
        return add_relief(self, context, context.object.name + " relief", strokes=context.object)


class RebuildRelief(bpy.types.Operator):
    """Rebuild the relief from its drawing or strokes"""

    bl_idname = "object.relievo_rebuild"
    bl_label = "Rebuild"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return is_relief(context.object)

    def execute(self, context):
        try:
            rebuild(context.object)
        except builder.BuildError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


def is_relief(thing):
    return thing is not None and thing.type == "MESH" and bool(thing.relievo.source or thing.relievo.strokes)


class ReliefPanel(bpy.types.Panel):
    bl_idname = "VIEW3D_PT_relievo"
    bl_label = "Relief"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Relievo"

    @classmethod
    def poll(cls, context):
        return is_relief(context.object)

    def draw(self, context):
        relief = context.object.relievo
        column = self.layout.column()
        column.prop(relief, "strokes" if relief.strokes else "source")
        for name in ("vertices", "method", "rho", "size", "own_shape"):
            column.prop(relief, name)
        shape = column.column()
        shape.enabled = not relief.own_shape
        shape.prop(relief, "c", slider=True)
        shape.prop(relief, "flat", slider=True)
        column.operator(RebuildRelief.bl_idname)


CLASSES = (ReliefSettings, Preferences, ImportRelief, ReliefOfStrokes, RebuildRelief, ReliefPanel)


def import_menu(self, context):
    self.layout.operator(ImportRelief.bl_idname)


def object_menu(self, context):
    self.layout.operator(ReliefOfStrokes.bl_idname)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Object.relievo = PointerProperty(type=ReliefSettings)
    bpy.types.TOPBAR_MT_file_import.append(import_menu)
    bpy.types.VIEW3D_MT_object.append(object_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(object_menu)
    bpy.types.TOPBAR_MT_file_import.remove(import_menu)
    del bpy.types.Object.relievo
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
    builder.sessions.clear()
