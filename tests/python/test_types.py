"""The types that the package tells are those that it has."""

import ast
import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

import relievo
from relievo import _core

CONFIG = pathlib.Path(__file__).with_name("mypy.ini")

SOUND = """
import relievo
relief = relievo.build("wolf.svg", vertices=500, method="nonlinear")
heights = relief.maps(64).heights
relief.solid(base="plate").save("a.stl", size=3.0)
volume: float = relief.report.max_violation
"""
WRONG = {
    'relievo.build("wolf.svg", vertexes=500)': "vertexes",
    'relievo.build("wolf.svg", method="fast")': "method",
    'relievo.build("wolf.svg").solid(base=3)': "base",
    "relievo.Part(1, [])": "Part",
}


def check(*words):
    package = pathlib.Path(relievo.__file__).parents[1]
    return subprocess.run(
        [sys.executable, "-m", *words],
        env={**os.environ, "MYPYPATH": str(package)},
        capture_output=True,
        text=True,
    )


@pytest.fixture
def needs_mypy():
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is not installed")


@pytest.mark.usefixtures("needs_mypy")
def test_the_package_is_sound():
    done = check("mypy", "--config-file", CONFIG, "-p", "relievo")
    assert done.returncode == 0, done.stdout


def public(names):
    return {name for name in names if not name.startswith("_")}


def names_in(body):
    """What a stub says there is in a module or a class, underscores aside."""
    targets = [node.target for node in body if isinstance(node, ast.AnnAssign)]
    defined = [node.name for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))]
    return public([target.id for target in targets] + defined)


def test_stubs_tell_what_the_module_has():
    stub = ast.parse(pathlib.Path(relievo.__file__).with_name("_core.pyi").read_text())
    assert names_in(stub.body) == public(vars(_core))
    for node in stub.body:
        if not isinstance(node, ast.ClassDef) or node.name.startswith("_"):
            continue
        members = vars(getattr(_core, node.name))
        if "__members__" not in members:
            assert names_in(node.body) == public(members), node.name


@pytest.mark.usefixtures("needs_mypy")
def test_callers_are_checked(tmp_path):
    (tmp_path / "sound.py").write_text(SOUND)
    done = check("mypy", "--config-file", CONFIG, "sound.py")
    assert done.returncode == 0, done.stdout
    for call, culprit in WRONG.items():
        (tmp_path / "wrong.py").write_text("import relievo\n" + call + "\n")
        done = check("mypy", "--config-file", CONFIG, "wrong.py")
        assert done.returncode == 1 and culprit in done.stdout, call + done.stdout
