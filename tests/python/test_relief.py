"""The Python module, from outside."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import relievo

TURN = np.linspace(0, 2 * np.pi, 60, endpoint=False)
CIRCLE = np.stack([np.cos(TURN), np.sin(TURN)], 1)


def two_discs():
    return relievo.Scene(
        200,
        160,
        [relievo.Part("ball", [(90, 80) + 60 * CIRCLE]), relievo.Part("nose", [(100, 90) + 20 * CIRCLE])],
    )


@pytest.fixture(scope="module")
def discs():
    return relievo.build(two_discs(), vertices=3000)


def test_a_disc_becomes_a_hemisphere():
    scene = relievo.Scene(200, 200, [relievo.Part("ball", [(100, 100) + 80 * CIRCLE])])
    heights = relievo.build(scene, vertices=8000).maps(200).heights
    y, x = np.mgrid[0:200, 0:200] + 0.5
    square = 80**2 - (x - 100) ** 2 - (y - 100) ** 2
    inner = square > 20**2
    assert np.abs(heights - np.sqrt(np.maximum(square, 0)))[inner].max() < 1
    assert np.isnan(heights[square < -400]).all()


def test_arrays_are_the_models_memory(discs):
    model = discs.model()
    assert model.vertices.shape == (len(model.normals), 3)
    assert model.faces.dtype == np.int32 and model.faces.max() < len(model.vertices)
    for name in ("vertices", "normals", "uvs", "faces"):
        first, second = getattr(model, name), getattr(model, name)
        assert np.shares_memory(first, second) and not first.flags.owndata
    maps = discs.maps(64)
    assert np.shares_memory(maps.normals, maps.normals)
    assert maps.heights.shape == (51, 64) and maps.normals.shape == (51, 64, 3)


def test_arrays_outlive_their_owners(discs):
    model = discs.model()
    vertices, before = model.vertices, model.vertices.copy()
    heights = discs.maps(64).heights
    kept = heights.copy()
    del model
    gc.collect()
    np.testing.assert_array_equal(vertices, before)
    np.testing.assert_array_equal(heights, kept)


def test_what_is_written_to_vertices_is_saved(discs, tmp_path):
    model = discs.model()
    plain = model.render(width=64, height=64, view="side")
    model.save(tmp_path / "a.ply")
    model.vertices[:, 2] *= 2
    model.save(tmp_path / "b.ply")
    assert (tmp_path / "a.ply").read_bytes() != (tmp_path / "b.ply").read_bytes()
    assert (model.render(width=64, height=64, view="side") != plain).any()


def test_faces_of_parts_are_disjoint_runs(discs):
    model = discs.model(visible="all")
    runs = [(part.first_face, part.first_face + part.face_count) for part in model.parts]
    assert [part.id for part in model.parts] == ["ball", "nose"]
    assert runs[0][1] == runs[1][0] and runs[1][1] == len(model.faces)


def assert_built_alike(program, drawing, files, *options):
    """The program makes the same of a drawing, to the last byte."""
    built = files[0].parent / "program"
    built.mkdir()
    outputs = [word for file in files for word in ("-o", built / file.name)]
    subprocess.run([program, "build", drawing, "-q", "--vertices", "4000", *options, *outputs], check=True)
    for file in built.iterdir():
        assert (files[0].parent / file.name).read_bytes() == file.read_bytes(), file.name


@pytest.mark.parametrize("ending", ["glb", "stl", "3mf"])
def test_inked_rims_are_those_of_the_program(program, data, tmp_path, ending):
    """Nothing is hidden in this drawing, but its outline is a broad black stroke."""
    file = tmp_path / f"a.{ending}"
    relievo.build(data / "inked_circle.svg", vertices=4000).save(file)
    assert_built_alike(program, data / "inked_circle.svg", [file])


@pytest.mark.parametrize("ending", ["glb", "obj", "ply", "stl", "usdz", "html"])
def test_files_are_those_of_the_program(program, examples, tmp_path, ending):
    file = tmp_path / f"a.{ending}"
    relievo.build(examples / "wolf.svg", vertices=4000).save(file)
    assert_built_alike(program, examples / "wolf.svg", [file])


def test_solids_are_those_of_the_program(program, examples, tmp_path):
    file = tmp_path / "a.3mf"
    relievo.build(examples / "wolf.svg", vertices=4000).save(file, size=60)
    assert_built_alike(program, examples / "wolf.svg", [file], "--profile", "solid", "--size", "60")


def test_standing_figures_are_those_of_the_program(program, examples, tmp_path):
    figure = relievo.build(examples / "wolf.svg", vertices=4000).solid(back="drawing", base="round")
    files = [tmp_path / f"a.{ending}" for ending in ("3mf", "stl", "glb")]
    for file in files:
        figure.save(file, filaments=6, slicer="bambu")
    options = ["--profile", "figure", "--base", "round", "--filaments", "6", "--slicer", "bambu"]
    assert_built_alike(program, examples / "wolf.svg", files, *options)


def test_figures_on_a_base_are_printed_standing(examples, tmp_path):
    figure = relievo.build(examples / "wolf.svg", vertices=2000).solid(back="drawing", base="plate")
    figure.save(tmp_path / "a.stl")
    triangles = np.frombuffer((tmp_path / "a.stl").read_bytes()[84:], np.uint8).reshape(-1, 50)
    places = triangles[:, 12:48].copy().view("<f4").reshape(-1, 3)
    lying = figure.vertices.max(0) - figure.vertices.min(0)
    np.testing.assert_allclose(places.max(0) - places.min(0), lying[[0, 2, 1]], rtol=1e-5)


def test_a_changed_relief_is_as_one_built_so(discs, tmp_path):
    relief = relievo.build(two_discs(), vertices=3000)
    before = relief.maps(64).heights.copy()
    relief.scene["nose"].c = 9
    relief.rebuild()
    changed = relief.maps(64).heights
    assert np.nanmax(np.abs(changed - before)) > 1
    fresh_scene = two_discs()
    fresh_scene["nose"].c = 9
    fresh = relievo.build(fresh_scene, vertices=3000)
    np.testing.assert_allclose(changed, fresh.maps(64).heights, atol=1e-4)
    relief.make_exact()
    np.testing.assert_array_equal(relief.model().vertices, fresh.model().vertices)


def test_options_that_are_not_named_stay():
    relief = relievo.build(two_discs(), vertices=1000)
    few = relief.report.vertices
    relief.rebuild(rho=0.4)
    assert relief.report.vertices == few
    assert relief.rebuild(vertices=4000).vertices > 2 * few


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (lambda r: r.rebuild(vertexes=5), TypeError, "vertexes.*did you mean vertices"),
        (lambda r: r.rebuild(rho="much"), TypeError, "rho"),
        (lambda r: r.rebuild(rho=-1), relievo.UsageError, "rho"),
        (lambda r: r.rebuild(method="fast"), relievo.UsageError, "approximate, nonlinear"),
        (lambda r: r.solid(base="square"), relievo.UsageError, "none, outline, plate, round"),
        (lambda r: r.solid(size=0), relievo.UsageError, "size"),
        (lambda r: r.model(visible="some"), relievo.UsageError, "relief, orbit, all"),
        (lambda r: r.render(samples=0), relievo.UsageError, "samples"),
        (lambda r: r.render(view="back"), ValueError, "three-quarter"),
        (lambda r: r.model().save("surface.3mf"), relievo.UsageError, "surface.3mf"),
        (lambda r: r.solid().save("a.3mf", filaments=17), relievo.UsageError, "filaments"),
        (lambda r: r.solid().save("a.3mf", slicer="cura"), relievo.UsageError, "slicer"),
        (lambda r: r.save("model.xyz"), relievo.UsageError, "model.xyz"),
        (lambda r: r.save("no/such/folder/a.glb"), relievo.FileError, "no/such/folder"),
        (lambda r: relievo.build("no-such-file.svg"), relievo.FileError, "no-such-file.svg"),
        (lambda r: relievo.build("wolf.svg", picture=np.zeros((4, 4, 4), np.uint8)), TypeError, "scene"),
        (lambda r: relievo.save_picture("a.png", np.zeros((4, 4))), relievo.UsageError, "picture"),
    ],
)
def test_wrong_calls_are_refused_by_name(discs, call, kind, text):
    relief = relievo.build(two_discs(), vertices=500)
    with pytest.raises(kind, match=text):
        call(relief)
    assert not os.path.exists("a.png")


def spoil(change):
    scene = two_discs()
    change(scene)
    return scene


@pytest.mark.parametrize(
    "change, where",
    [
        (lambda s: setattr(s["nose"], "outline", [np.zeros((3, 2))]), "parts[1].outline"),
        (lambda s: setattr(s["nose"], "outline", [np.zeros((3, 3))]), "parts[1].outline[0]"),
        (lambda s: setattr(s["nose"], "c", "round"), "parts[1].c"),
        (lambda s: setattr(s["nose"], "id", "ball"), "parts[1].id"),
        (lambda s: s.joins.append(relievo.Join("ear", "ball", CIRCLE)), "joins[0].upper"),
        (lambda s: s.relations.append(relievo.Relation("nose", "ball", "beside")), "relations[0].kind"),
        (lambda s: s.cues.append(relievo.Cue("nose", "bulge", [[1]], 2)), "cues[0].line"),
        (lambda s: setattr(s, "width", float("nan")), "canvas"),
    ],
)
def test_errors_name_the_culprit(change, where):
    with pytest.raises(relievo.BadInputError) as caught:
        relievo.build(spoil(change), vertices=500)
    assert caught.value.where.startswith(where)
    assert isinstance(caught.value, (relievo.Error, ValueError))


@pytest.mark.parametrize("sample, kinds", [("griffin", ["cues"]), ("bunny", ["joins", "relations"])])
def test_scenes_come_back_as_they_went(examples, sample, kinds):
    relief = relievo.build(examples / f"{sample}.svg", vertices=2000)
    assert all(getattr(relief.scene, kind) for kind in kinds)
    again = relievo.build(relief.scene, vertices=2000)
    np.testing.assert_array_equal(again.model().vertices, relief.model().vertices)
    with pytest.raises(KeyError):
        relief.scene["nothing"]
    with pytest.raises(ValueError):
        relief.scene.parts[0].outline[0][0, 0] = 1


def test_limbs_behind_are_joined_along_the_outline_in_front():
    def box(x0, y0, x1, y1):
        return [np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], float)]

    scene = relievo.Scene(100, 120)
    scene.parts = [relievo.Part("leg", box(40, 40, 56, 110)), relievo.Part("body", box(10, 10, 90, 70))]
    scene.joins = [relievo.Join("leg", "body", [[40, 70], [56, 70]])]
    relief = relievo.build(scene, vertices=1000)
    model = relief.model().vertices
    rim = model[(np.abs(model[:, 1] - 50) < 1e-9) & (model[:, 0] > 41) & (model[:, 0] < 55)]
    heights = {}
    for x, _, z in np.round(rim, 6):
        heights.setdefault(x, set()).add(z)
    assert len(heights) > 2 and all(len(z) == 1 for z in heights.values())


def test_flat_pictures_are_understood(examples):
    relief = relievo.build(examples / "bear.png", vertices=2000)
    assert relief.proposed and len(relief.scene.parts) > 3
    assert relief.drawing.shape[2] == 4


def test_pictures_go_in_and_lie_on_the_model():
    picture = np.zeros((16, 20, 3), np.uint8)
    picture[..., 0] = 200
    relief = relievo.build(two_discs(), picture=picture, vertices=1000)
    assert relief.drawing.shape == (16, 20, 4)
    assert (relief.drawing[..., :3] == picture).all() and (relief.drawing[..., 3] == 255).all()
    shown = relief.render("front", width=64, height=48, shading="textured", background="white")
    middle = shown[24, 32].astype(int)
    assert middle[0] > middle[1] + 40


def test_pixel_art_is_told_or_named(tmp_path):
    sprite = np.zeros((24, 24, 4), np.uint8)
    sprite[4:20, 6:18] = (200, 60, 40, 255)
    sprite[8:12, 9:15] = (250, 220, 60, 255)
    relievo.save_picture("sprite.png", sprite)
    nearest = b'"magFilter":9728'
    for says, is_sharp in ((None, True), (True, True), (False, False)):
        relief = relievo.build("sprite.png", pixel_art=says, vertices=1000)
        relief.save("sprite.glb")
        assert (nearest in (tmp_path / "sprite.glb").read_bytes()) == is_sharp
        assert relief.maps().heights.shape == (2040 if is_sharp else 2048,) * 2


def test_a_solid_is_closed_and_as_large_as_said(discs, tmp_path):
    solid = discs.solid(size=50, base="plate")
    extent = np.ptp(solid.vertices, axis=0)
    assert abs(extent.max() - 50) < 1e-6 and solid.solid.pieces == 1
    a, b, c = (solid.vertices[solid.faces[:, i]] for i in range(3))
    volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6
    assert volume == pytest.approx(solid.solid.volume, rel=1e-9)
    solid.save(tmp_path / "plaque.stl")
    triangles = np.frombuffer((tmp_path / "plaque.stl").read_bytes()[84:], np.uint8).reshape(-1, 50)
    corners = np.ascontiguousarray(triangles[:, 12:48]).view(np.float32).reshape(-1, 3)
    assert np.ptp(corners, axis=0).max() == pytest.approx(50, rel=1e-5)


def test_inputs_are_not_overwritten(examples, tmp_path):
    drawing = tmp_path / "wolf.glb"
    drawing.write_bytes((examples / "wolf.svg").read_bytes())
    relief = relievo.build(drawing, vertices=1000)
    with pytest.raises(relievo.UsageError):
        relief.save(drawing)
    assert drawing.read_bytes() == (examples / "wolf.svg").read_bytes()


def test_others_run_while_a_relief_is_built():
    relief = relievo.build(two_discs(), vertices=500)
    worker = threading.Thread(target=relief.rebuild, kwargs={"vertices": 60000})
    worker.start()
    turns = 0
    while worker.is_alive():
        turns += 1
        time.sleep(0)
    assert turns > 100


def test_threads_take_turns():
    relief = relievo.build(two_discs(), vertices=2000)
    wanted = relief.maps(64).heights.copy()
    found = []
    threads = [threading.Thread(target=lambda: found.append(relief.maps(64).heights)) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for heights in found:
        np.testing.assert_array_equal(heights, wanted)


INTERRUPTED = """
import relievo, sys
relief = relievo.build(sys.argv[1], vertices=1000)
print("begun", flush=True)
try:
    while True:
        relief.rebuild(vertices=100000)
        relief.rebuild(vertices=120000)
except KeyboardInterrupt:
    print("stopped", flush=True)
print(relief.rebuild(vertices=1000).vertices > 500)
"""


def test_ctrl_c_stops_a_build(examples):
    # Background jobs of a shell ignore interrupts, and their children would too.
    child = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, examples / "wolf.svg"],
        stdout=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    try:
        assert child.stdout.readline() == "begun\n"
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        out, _ = child.communicate(timeout=60)
    finally:
        child.kill()
    assert out == "stopped\nTrue\n"
    assert child.returncode == 0
