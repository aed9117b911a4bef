#!/usr/bin/python3
"""What a build costs in Python over the program: processor time on one processor, least of several
turns, with and without starting Python. Usage: PYTHONPATH=... python_cost.py PROGRAM DRAWING..."""

import os
import sys
import tempfile

TURNS = 9
BUILD = "import relievo, sys; relievo.build(sys.argv[1]).save(sys.argv[2])"
START = "import relievo"


def seconds(words):
    """Processor time of a child."""
    child = os.posix_spawn(words[0], words, os.environ)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"failed: {' '.join(words)}")
    return usage.ru_utime + usage.ru_stime


def main(program, drawings):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    with tempfile.TemporaryDirectory() as folder:
        model = os.path.join(folder, "model.glb")
        for drawing in drawings:
            ways = {
                "program": [program, "build", drawing, "-q", "-o", model],
                "python": [sys.executable, "-c", BUILD, drawing, model],
                "start": [sys.executable, "-c", START],
            }
            least = {}
            for _ in range(TURNS):
                for name, words in ways.items():
                    least[name] = min(least.get(name, 1e9), seconds(words))
            built = least["python"] - least["start"]
            print(
                f"{os.path.basename(drawing)}: program {least['program']:.3f} s, "
                f"Python {built:.3f} s and {least['start']:.3f} s to start, "
                f"ratio {built / least['program']:.3f}"
            )


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
