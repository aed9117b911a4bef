"""Builds models of drawings, with the Python module if it is installed, else with the program."""

import pathlib
import shutil
import subprocess
import tempfile

from .glb import Model


class BuildError(Exception):
    """An error of Relievo."""


#: The reliefs of the module, by names of objects. A rebuild computes only what has changed.
sessions = {}


def build(key, source, settings, program=""):
    """Returns the model of the drawing `source`.

    `settings` has the keys vertices, method, rho, size and shape, which is (c, flat) for all parts, or
    None for the shapes of the drawing. `key` identifies the object of the model."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "model.glb")
        try:
            import relievo
        except ImportError:
            by_program(source, settings, file, program)
        else:
            by_module(relievo, key, source, settings, file)
        return Model(file.read_bytes())


def by_module(relievo, key, source, settings, file):
    options = {name: settings[name] for name in ("vertices", "method", "rho")}
    try:
        known = sessions.get(key)
        stamp = (source, pathlib.Path(source).stat().st_mtime_ns)
        if known is None or known[0] != stamp:
            relief = relievo.build(source, **options)
            known = sessions[key] = (stamp, relief, [(part.c, part.flat) for part in relief.scene.parts])
        _, relief, shapes = known
        for part, shape in zip(relief.scene.parts, shapes):
            part.c, part.flat = settings["shape"] or shape
        relief.rebuild(**options)
        relief.save(file, size=1000 * settings["size"])
    except (relievo.Error, OSError) as error:
        raise BuildError(str(error)) from error


def by_program(source, settings, file, program):
    program = program or shutil.which("relievo")
    if not program:
        raise BuildError("neither the Python module nor the program of Relievo was found; "
                         "install one, or set the program in the add-on's preferences")
    words = [program, "build", source, "-q", "-o", str(file), "--size", str(1000 * settings["size"]),
             "--vertices", str(settings["vertices"]), "--method", settings["method"],
             "--rho", str(settings["rho"])]
    if settings["shape"]:
        words += ["--c", str(settings["shape"][0]), "--flat", str(settings["shape"][1])]
    try:
        done = subprocess.run(words, capture_output=True, text=True)
    except OSError as error:
        raise BuildError(str(error)) from error
    if done.returncode != 0:
        raise BuildError(done.stderr.strip().splitlines()[-1] if done.stderr else "the program failed")
