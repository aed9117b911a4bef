#!/bin/sh
# Builds Relievo, turns two sample drawings into models, and serves the editor until it is stopped;
# away from a terminal, or with --no-serve, it ends when all is made. Installs what is missing.
set -eu
cd "$(dirname "$0")"

scripts/install-packages.sh build
cmake --preset release > /dev/null
cmake --build build/release --target relievo

mkdir -p out
relievo=build/release/apps/cli/relievo
"$relievo" build examples/wolf.svg -o out/wolf.glb --preview out/wolf.png \
  --normal-map out/wolf-normal.png --depth-map out/wolf-depth.png --part-map out/wolf-parts.png \
  --report out/wolf.json > /dev/null
"$relievo" segment examples/bear.png -o out/bear.relievo --overlay out/bear-understood.png > /dev/null
"$relievo" build out/bear.relievo -o out/bear.glb --preview out/bear.png > /dev/null
"$relievo" render examples/wolf.svg -o out/wolf-sheet.png --view sheet > /dev/null

cat << 'END'

Made from examples/wolf.svg:
  out/wolf.glb          the model; opens in Blender, on Windows, macOS and in web viewers
  out/wolf.png          a picture of it
  out/wolf-sheet.png    the same from several sides
  out/wolf-normal.png   normal map, out/wolf-depth.png depth map, out/wolf-parts.png parts
  out/wolf.json         what was computed, how exactly and how fast

Made from examples/bear.png, a flat drawing:
  out/bear.relievo      what was understood of it; out/bear-understood.png shows that
  out/bear.glb          the model, out/bear.png a picture of it

Your own drawing: build/release/apps/cli/relievo build DRAWING.svg -o MODEL.glb

Now the editor, for the browser:
END

scripts/build-web.sh
echo "The editor is in build/web, for any host of static files."
if [ ! -t 1 ] || [ "${1:-}" = --no-serve ]; then
  echo "To serve it here: cd web && npm run serve"
  exit 0
fi
echo "Open it here; Ctrl-C ends it:"
cd web && exec npm run --silent serve
