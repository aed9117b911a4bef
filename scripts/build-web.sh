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
[ node_modules/.package-lock.json -nt package-lock.json ] ||
  npm ci --ignore-scripts --no-audit --no-fund --silent
npm run --silent build
