#!/bin/sh
# Segments every drawing of a folder and puts the overlays, which show what was understood, on one
# sheet, with ImageMagick. A drawing NAME.png, or NAME/texture.png, takes the strokes of
# STROKES/NAME.json where there are any; refusals are printed and have no picture.
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
  set --
  [ ! -f "$strokes/$name.json" ] || set -- --scribbles "$strokes/$name.json"
  "$relievo" segment "$drawing" "$@" --quiet -o "$work/$name.relievo" \
    --overlay "$work/$name.png" || echo "$name: no picture"
done
montage -label '%t' "$work"/*.png -tile 4x -geometry 600x600+6+6 "$sheet"
