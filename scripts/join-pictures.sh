#!/bin/sh
# Renders every join of the samples close, in clay with light from the left, as one picture.
# Usage: join-pictures.sh RELIEVO OUT.png
set -eu
cd "$(dirname "$0")/.."
relievo="$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tiles=
for name in wolf bunny farmer unicorn elephant lamb; do
  "$relievo" check "examples/$name.svg" -o "$work/scene.json" > /dev/null 2>&1
  python3 - "$work/scene.json" > "$work/windows" << 'END'
import json
import sys

for join in json.load(open(sys.argv[1]))["joins"]:
    xs, ys = zip(*join["line"])
    size = max(max(xs) - min(xs), max(ys) - min(ys))
    print(join["upper"], (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2, 1.8 * size)
END
  while read -r part x y width; do
    tile="$work/$name-$part.png"
    "$relievo" render "examples/$name.svg" -o "$tile" --view front --clay --light -60 30 \
      --window "$x" "$y" "$width" --size 300 > /dev/null 2>&1
    convert "$tile" -resize '150x150!' -colorspace Gray "$tile"
    tiles="$tiles $tile"
  done < "$work/windows"
done
# shellcheck disable=SC2086
montage $tiles -tile 9x -geometry 150x150+1+1 -colorspace Gray -depth 8 "$2"
