"""Where the tests find the program and the samples."""

import os
import pathlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def examples():
    return ROOT / "examples"


@pytest.fixture(scope="session")
def data():
    return ROOT / "tests" / "data"


@pytest.fixture(scope="session")
def program():
    """The program of the same build, named by RELIEVO."""
    if "RELIEVO" not in os.environ:
        pytest.skip("RELIEVO does not name the program")
    return os.environ["RELIEVO"]


@pytest.fixture(autouse=True)
def apart(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
