"""docs/python.md: its examples run, and made the pictures that it shows."""

import re
import shutil

import numpy as np
from conftest import ROOT
from PIL import Image

PAGE = (ROOT / "docs/python.md").read_text()


def run_page(folder, examples):
    for file in examples.glob("*.svg"):
        shutil.copy(file, folder)
    spoken = []
    names = {"__name__": "page", "print": lambda *words: spoken.append(" ".join(map(str, words)))}
    for block in re.findall(r"```python\n(.*?)```", PAGE, re.S):
        exec(compile(block, "docs/python.md", "exec"), names)
    return spoken


def test_the_page_says_and_shows_what_happens(tmp_path, examples):
    spoken = run_page(tmp_path, examples)
    assert "there is no option 'vertexes'; did you mean vertices?" in spoken
    assert spoken[-1] == "parts[1].outline[0]"
    shown = re.findall(r"\(pictures/(python-.*?\.png)\)", PAGE)
    assert len(shown) >= 4
    for name in shown:
        made = np.asarray(Image.open(tmp_path / name).convert("RGB"), float)
        kept = np.asarray(Image.open(ROOT / "docs/pictures" / name).convert("RGB"), float)
        assert made.shape == kept.shape and np.abs(made - kept).mean() < 1, name
    for file in ("wolf.glb", "deeper.obj", "plaque.stl", "plaque.3mf", "figure.3mf", "wolf-depth.png"):
        assert (tmp_path / file).stat().st_size > 1000
