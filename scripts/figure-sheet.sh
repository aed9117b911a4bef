#!/bin/sh
# Puts the figures of drawings on one sheet, a row of four views for each of two drawings beside each
# other: from the front, from the side, half from behind and from behind. With ImageMagick.
# Usage: figure-sheet.sh RELIEVO SHEET.jpg DRAWING...
set -eu
relievo=$1
sheet=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

row=0
for drawing in "$@"; do
  row=$((row + 1))
  cell=$work/$(printf '%03d' "$row")
  if ! "$relievo" build "$drawing" --quiet --profile figure -o "$cell.glb"; then
    echo "$drawing: no figure"
    continue
  fi
  for yaw in 000 090 155 180; do
    "$relievo" render "$cell.glb" --quiet --yaw "$yaw" --pitch 0 --size 300 -o "$cell-$yaw.png"
  done
done
montage "$work"/*.png -tile 8x -geometry 150x150 -background '#dcdcdc' -quality 85 "$sheet"
