#!/bin/sh
# Puts the models of all layered drawings of a folder (SVG, OpenRaster, folders of layers) on one
# sheet, each from the front, from 45 and in clay from 45 and 75 degrees, with ImageMagick: whether
# parts hold together is only seen when they are turned.
# Usage: layered-sheet.sh DRAWINGS SHEET.png [RELIEVO]
set -eu
drawings=$1
sheet=$2
relievo=${3:-build/release/apps/cli/relievo}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for drawing in "$drawings"/*; do
  [ -d "$drawing" ] || case $drawing in *.svg | *.ora) ;; *) continue ;; esac
  name=$(basename "$drawing")
  draw() {
    "$relievo" render "$drawing" --quiet --pitch 0 --size 200 --yaw "$1" -o "$work/$name-$2.png" \
      $3 || echo "$name: no picture"
  }
  draw 0 1 ""
  draw 45 2 ""
  draw 45 3 "--clay --light -60 30"
  draw 75 4 "--clay --light -60 30"
done
montage "$work"/*.png -tile 8x -geometry 200x200+2+2 -background white "$sheet"
