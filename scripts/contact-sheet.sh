#!/bin/sh
# Puts every flat drawing of a folder on one sheet, with ImageMagick: the drawing, what was understood
# of it, and its model from the front and turned by 45 degrees. A drawing NAME.png, or
# NAME/texture.png, takes the strokes of STROKES/NAME.json where there are any; refusals are printed.
# Usage: contact-sheet.sh DRAWINGS SHEET.png [STROKES] [RELIEVO]
set -eu
drawings=$1
sheet=$2
strokes=${3:-}
relievo=${4:-build/release/apps/cli/relievo}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for drawing in "$drawings"/*.png "$drawings"/*.jpg "$drawings"/*.gif "$drawings"/*.svg \
  "$drawings"/*/texture.png; do
  [ -f "$drawing" ] || continue
  name=$(basename "${drawing%/texture.png}")
  name=${name%.*}
  cell=$work/$name
  set --
  [ ! -f "$strokes/$name.json" ] || set -- --scribbles "$strokes/$name.json"
  if ! "$relievo" segment "$drawing" "$@" --quiet -o "$cell.relievo" --overlay "$cell-2.png"; then
    echo "$name: no picture"
    continue
  fi
  case $drawing in
    *.svg) rsvg-convert -w 600 "$drawing" -o "$cell-1.png" ;;
    *) convert "${drawing}[0]" "$cell-1.png" ;;
  esac
  "$relievo" render "$cell.relievo" --quiet --pitch 0 --yaw 0 --size 400 -o "$cell-3.png"
  "$relievo" render "$cell.relievo" --quiet --pitch 0 --yaw 45 --size 400 -o "$cell-4.png"
done
montage "$work"/*.png -tile 8x -geometry 149x149+2+2 -background white -depth 8 "$work/sheet.miff"
convert "$work/sheet.miff" -colors 200 "$sheet"
