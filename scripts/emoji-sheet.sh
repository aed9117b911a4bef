#!/bin/sh
# Makes the sheet of emoji in docs: drawing, model from the front and from 45 degrees, and in clay
# from 75, two emoji a row, with npm, librsvg and ImageMagick. The drawings are fetched from the
# registry and not kept. Usage: emoji-sheet.sh SHEET.png [RELIEVO [SET/NAME...]]
set -eu
sheet=$1
relievo=${2:-build/release/apps/cli/relievo}
if [ $# -lt 2 ]; then shift; else shift 2; fi
[ $# -gt 0 ] || set -- noto-v1/camel noto-v1/cow noto-v1/elephant noto-v1/penguin noto-v1/pig \
  noto-v1/rabbit noto-v1/ram noto-v1/rooster noto-v1/snail noto-v1/tiger noto-v1/turtle \
  noto-v1/two-hump-camel fluent-emoji/beaver fluent-emoji/dodo fluent-emoji/flamingo \
  fluent-emoji/hedgehog fluent-emoji/kangaroo fluent-emoji/otter fluent-emoji/ox \
  fluent-emoji/peacock fluent-emoji/sauropod fluent-emoji/sloth fluent-emoji/swan fluent-emoji/t-rex
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
relievo=$(realpath "$relievo")

cat > "$work/extract.js" << 'EOF'
const [folder, emoji] = process.argv.slice(2);
const [set, name] = emoji.split("/");
const all = require(`${folder}/node_modules/@iconify-json/${set}/icons.json`);
const { body, width = all.width ?? 16, height = all.height ?? 16 } = all.icons[name];
console.log(`<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  width="${(1024 * width) / height}" height="1024" viewBox="0 0 ${width} ${height}">${body}</svg>`);
EOF
packages=$(printf '@iconify-json/%s\n' "$@" | cut -d/ -f1,2 | sort -u)
# shellcheck disable=SC2086 # names without spaces
npm install --silent --no-save --prefix "$work" $packages > /dev/null
for emoji in "$@"; do
  name=$(echo "$emoji" | tr / -)
  node "$work/extract.js" "$work" "$emoji" > "$work/$name.svg"
  rsvg-convert -w 200 "$work/$name.svg" -o "$work/$name-1.png"
  draw() {
    picture=$work/$name-$1.png
    shift
    "$relievo" render "$work/$name.svg" --quiet --pitch 0 --size 200 -o "$picture" "$@" ||
      echo "$name: no picture"
  }
  draw 2 --yaw 0
  draw 3 --yaw 45
  draw 4 --yaw 75 --clay --light -60 30
done
montage "$work"/*.png -tile 8x -geometry 150x150+2+2 -background white "$work/sheet.miff"
convert "$work/sheet.miff" +dither -colors 160 PNG8:"$sheet"
