#!/bin/sh
# Makes the picture of docs/sequence.md, with ImageMagick. Usage: walk-picture.sh [RELIEVO]
set -eu
cd "$(dirname "$0")/.."
relievo="${1:-build/release/apps/cli/relievo}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scripts/walk-frames.sh "$work"
for k in 0 1 2 3 4 5 6 7 8 9; do
  "$relievo" render "$work/walk-$k.svg" -o "$work/walk-$k.png" --view front --size 360 \
    --light $((k * 36 - 180)) 35 --vertices 20000 > /dev/null
done
convert -delay 10 -loop 0 "$work"/walk-?.png +dither -colors 96 -layers optimize docs/pictures/walk.gif
