#!/bin/sh
# Ten frames of the wolf walking: its legs turn about their roots. Usage: walk-frames.sh FOLDER [WOLF.svg]
set -eu
to="${1:?a folder is not given}"
wolf="${2:-$(dirname "$0")/../examples/wolf.svg}"
mkdir -p "$to"
for k in 0 1 2 3 4 5 6 7 8 9; do
  awk -v k="$k" '
    function turned(name, x, y, sign) {
      gsub("<g id=\"" name "\"", "& transform=\"rotate(" \
        sprintf("%.3f", sign * 10 * sin(2 * atan2(0, -1) * k / 10)) " " x " " y ")\"")
    }
    { turned("near-front-leg", 448, 430, 1); turned("far-front-leg", 360, 470, -1)
      turned("near-hind-leg", 700, 400, -1); turned("far-hind-leg", 650, 450, 1); print }' \
    "$wolf" > "$to/walk-$k.svg"
done
