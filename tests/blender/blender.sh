#!/bin/sh
# Whether the add-on works in the Blender that is installed, by the Python module in MODULES and by
# PROGRAM alone, and what it makes looks as the picture of its page does. Usage: blender.sh PROGRAM MODULES
set -eu
program=$(readlink -f "$1")
modules=$(readlink -f "$2")
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for way in module program; do
  PATH=$(dirname "$program"):$PATH PYTHONPATH=$modules \
    blender -b --factory-startup --python-use-system-env --python tests/blender/addon_test.py -- \
    "$way" examples/wolf.svg "$work/$way.png" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  grep '^blender:' "$work/log"
  /usr/bin/python3 - "$work/$way.png" docs/pictures/blender.png << 'END'
import sys
import numpy as np
from PIL import Image
made, kept = (np.asarray(Image.open(name).convert("RGB"), float) for name in sys.argv[1:])
assert made.shape == kept.shape and np.abs(made - kept).mean() < 3, "not the picture of docs/blender.md"
END
done
