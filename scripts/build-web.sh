#!/bin/sh
# Builds the editor: the core for the browser and the page, as static files in build/web that any
# host can serve.
set -eu
cd "$(dirname "$0")/.."

scripts/install-packages.sh web
scripts/fetch-sources.sh build/sources
cmake --preset wasm > /dev/null
cmake --build --preset wasm
cd web
[ -n "$(find node_modules/.package-lock.json -newer package-lock.json 2> /dev/null)" ] ||
  npm ci --ignore-scripts --no-audit --no-fund --silent
npm run --silent build
