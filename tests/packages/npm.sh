#!/bin/sh
# Whether the package for npm in build/packages can be installed and used: in Node, in a browser and by
# TypeScript, with the bytes of PROGRAM. Usage: npm.sh PROGRAM
set -eu
program=$(readlink -f "$1")
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for package in build/packages/relievo-[0-9]*.tgz; do cp "$package" "$work/relievo.tgz"; done
cp tests/packages/use_npm.mjs tests/packages/use_in_page.mjs tests/packages/typed.ts examples/wolf.svg "$work"
echo '{ "type": "module" }' > "$work/package.json"
ln -s "$PWD/web/node_modules" "$work/tools"
(cd "$work" && npm install --silent --no-audit --no-fund --offline ./relievo.tgz > /dev/null)

cd "$work"
node use_npm.mjs wolf.svg
mkdir program
"$program" build scene.json -q --vertices 4000 -o program/wolf.glb -o program/wolf.stl \
  --normal-map program/normal.png
for file in wolf.glb wolf.stl normal.png; do cmp "$file" "program/$file"; done
echo "npm: Node: same bytes"
node use_in_page.mjs wolf.svg > page.sha256
sha256sum < wolf.stl | cmp - page.sha256
echo "npm: a browser: same bytes"
tools/.bin/tsc --strict --noEmit --module NodeNext --moduleResolution NodeNext --target ES2022 \
  --lib ES2023,DOM --types "" typed.ts
echo "npm: types are sound"
