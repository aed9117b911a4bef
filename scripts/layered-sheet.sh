#!/bin/sh
# Puts the models of all layered drawings of a folder (SVG, OpenRaster, folders of layers) on one
# sheet, each from the front, from 45 and in clay from 45 and 75 degrees, with ImageMagick: whether
# parts hold together is only seen when they are turned. What an SVG says of joins and relations is
# left out, so that they are guessed.
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
  if [ -f "$drawing" ] && [ "$drawing" != "${drawing%.svg}" ]; then
    sed -E 's/<path class="join"[^>]*>//g; s/ data-relation="[a-z]*"//g' "$drawing" > "$work/$name"
    drawing=$work/$name
  fi
  draw() {
    picture=$work/$name-$1.png
    shift
    "$relievo" render "$drawing" --quiet --pitch 0 --size 200 -o "$picture" "$@" ||
      echo "$name: no picture"
  }
  draw 1 --yaw 0
  draw 2 --yaw 45
  draw 3 --yaw 45 --clay --light -60 30
  draw 4 --yaw 75 --clay --light -60 30
done
montage "$work"/*.png -tile 8x -geometry 150x150+2+2 -background white "$work/sheet.miff"
convert "$work/sheet.miff" +dither -colors 160 PNG8:"$sheet"
