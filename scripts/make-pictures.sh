#!/bin/sh
# Makes the pictures of README and docs from the samples, with rsvg-convert and ImageMagick.
# Usage: make-pictures.sh [RELIEVO]
set -eu
cd "$(dirname "$0")/.."
relievo="${1:-build/release/apps/cli/relievo}"
to=docs/pictures
mkdir -p "$to"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for name in wolf bunny farmer unicorn elephant lamb; do
  rsvg-convert --width 480 --keep-aspect-ratio --background-color white "examples/$name.svg" \
    -o "$to/$name-drawing.png"
  "$relievo" render "examples/$name.svg" -o "$to/$name-clay.png" --view front --clay --size 480 > /dev/null
  yaw=-20
  [ "$name" != unicorn ] || yaw=20
  "$relievo" render "examples/$name.svg" -o "$to/$name.png" --yaw "$yaw" --pitch 8 --size 480 > /dev/null
  # What the editor's first screen shows.
  "$relievo" render "examples/$name.svg" -o "$work/$name.png" --yaw $((yaw * 8 / 5)) --pitch 10 \
    --light -50 35 --size 720 > /dev/null
  convert "$work/$name.png" -resize 320x256 -quality 68 -define webp:method=6 "web/thumbnails/$name.webp"
done

# Creases, with light from the left.
rsvg-convert --width 480 --keep-aspect-ratio --background-color white examples/griffin.svg \
  -o "$to/griffin-drawing.png"
"$relievo" render examples/griffin.svg -o "$to/griffin-clay.png" --view front --clay \
  --light -60 30 --size 480 > /dev/null
"$relievo" render examples/griffin.svg -o "$to/griffin-turned.png" --yaw 45 --clay \
  --light -60 30 --size 480 > /dev/null

# All joins, and a part that lies on another with all of its outline, with light from the left. What
# these were like before (joins-before.png, nose-pulled.png) no option makes any more.
scripts/join-pictures.sh "$relievo" "$to/joins.png"
"$relievo" render examples/nose.json -o "$to/nose.png" --yaw 30 --pitch 10 --clay --light -60 30 \
  --size 420 > /dev/null

# A flat drawing.
convert examples/bear.png -resize 480x480 "$to/bear-drawing.png"
"$relievo" segment examples/bear.png -o "$work/bear.relievo" --overlay "$work/bear.png" > /dev/null
convert "$work/bear.png" -resize 480x480 "$to/bear-understood.png"
"$relievo" render "$work/bear.relievo" -o "$to/bear.png" --yaw -20 --pitch 8 --size 480 > /dev/null

# Contours in the paint, and as lines that turn with the model.
for name in bear.png griffin.svg wolf.svg lamb.svg farmer.svg elephant.svg; do
  for yaw in 45 75; do
    for ink in paint shell; do
      "$relievo" render "examples/$name" --ink "$ink" --yaw "$yaw" --pitch 4 --size 480 \
        -o "$work/contour-$name-$yaw-$ink.png" > /dev/null
    done
  done
  montage "$work/contour-$name"-*.png -tile 4x -geometry 240x200 -background '#dcdcdc' \
    "$work/contours-$name.png"
done
convert "$work"/contours-*.png -append +repage -quality 85 "$to/contours.jpg"

# A join's ends: the paper's pits, and what the Robin range makes of them.
"$relievo" render examples/wolf.svg -o "$to/ends-pits.png" --alpha0 1 --view front --clay \
  --window 440 470 260 --size 420 > /dev/null
"$relievo" render examples/wolf.svg -o "$to/ends.png" --view front --clay \
  --window 440 470 260 --size 420 > /dev/null
"$relievo" build examples/elephant.svg --normal-map "$to/elephant-normal.png" \
  --depth-map "$to/elephant-depth.png" --map-size 480 > /dev/null

# Solids.
solid="examples/wolf.svg --profile solid --size 480 --pitch 15"
while read -r name look; do
  # shellcheck disable=SC2086
  "$relievo" render $solid $look -o "$work/solid.png" > /dev/null
  convert "$work/solid.png" -resize 360x -colors 192 "$to/solid-$name.png"
done << END
front --clay --yaw 0
turned --clay --yaw 60
back --clay --yaw 165
outline --base outline --ring 4 --yaw -30
plate --base plate --margin 8 --hole 4 --yaw -30
round --base round --yaw -30
END
"$relievo" render examples/bunny.svg --profile solid --base outline --height 8 --height-mode detail \
  --cutter 12 --size 480 --yaw -35 --pitch 30 --clay -o "$work/cutter.png" > /dev/null
convert "$work/cutter.png" -resize 360x -colors 192 "$to/solid-cutter.png"
for mode in linear detail; do
  "$relievo" render examples/wolf.svg --profile solid --base round --height 5 --height-mode "$mode" \
    --clay --light -60 30 --yaw -20 --pitch 20 --size 480 -o "$work/coin-$mode.png" > /dev/null
done
convert "$work/coin-linear.png" "$work/coin-detail.png" +append -resize 720x -colors 192 \
  "$to/solid-depth.png"

while read -r drawing base; do
  "$relievo" render "examples/$drawing.svg" --profile figure --base "$base" --size 480 --yaw -35 \
    --pitch 20 -o "$work/figure.png" > /dev/null
  convert "$work/figure.png" -resize x360 -colors 192 "$to/figure-$base.png"
done << END
wolf plate
farmer round
END

# Figures from all sides, and those of drawings without far limbs, which the near ones make.
while read -r sheet drawing options; do
  row=$work/$sheet-$drawing
  if [ "$sheet" = figure-mirrored ]; then
    sed '/<g id="far-/,/<\/g>/d' "examples/$drawing.svg" > "$row.svg"
  else
    cp "examples/$drawing.svg" "$row.svg"
  fi
  # shellcheck disable=SC2086
  "$relievo" build "$row.svg" --quiet --profile figure $options -o "$row.glb"
  for yaw in 000 045 090 135 180; do
    "$relievo" render "$row.glb" --quiet --yaw "$yaw" --pitch 0 --size 400 -o "$row-$yaw.png"
  done
  montage "$row"-[01]*.png -tile 5x -geometry 250x190 -background '#dcdcdc' "$row-row.png"
done << END
figures wolf
figures elephant
figures bunny
figures farmer
figures lamb
figures unicorn
figure-mirrored elephant --mirror near-hind-leg --mirror near-front-leg --mirror near-ear
figure-mirrored wolf --mirror near-hind-leg --mirror near-front-leg --mirror near-ear
figure-mirrored unicorn --mirror near-hind-leg --mirror near-front-leg
END
for sheet in figures figure-mirrored; do
  convert "$work/$sheet"-*-row.png -append +repage -quality 85 "$to/$sheet.jpg"
done

# Figures for the README.
scripts/figure-sheet.sh "$relievo" "$to/turned.jpg" examples/bear.png examples/griffin.svg \
  examples/farmer.svg examples/bunny.svg

# What a printer lays, where a slicer is installed.
if command -v prusa-slicer > /dev/null; then
  "$relievo" build examples/wolf.svg --profile figure -o "$work/wolf.stl" > /dev/null
  prusa-slicer --export-gcode --layer-height 0.3 -o "$work/wolf.gcode" "$work/wolf.stl" > /dev/null
  python3 scripts/draw-layers.py "$work/wolf.gcode" "$to/solid-layers.png"
fi

# A hat before a head, and closed round it.
for caps in loose closed; do
  "$relievo" render examples/farmer.svg --quiet --caps "$caps" --yaw 65 --pitch 0 --clay \
    --light -60 30 --size 1000 -o "$work/caps-$caps.png"
done
convert "$work/caps-loose.png" "$work/caps-closed.png" -crop 380x330+200+40 +repage +append \
  "$to/caps.png"

# The non-linear method: its fields, its steps, and the ends of joins.
for field in inflation shift relief; do
  "$relievo" render examples/wolf.svg --method nonlinear --field "$field" --clay --yaw -20 \
    --pitch 8 --size 480 -o "$work/$field.png" > /dev/null
done
"$relievo" build examples/wolf.svg --method nonlinear --convergence "$work/steps.png" > /dev/null
look="--view front --clay --window 440 470 260 --size 420"
# shellcheck disable=SC2086
"$relievo" render examples/wolf.svg $look -o "$work/approximate.png" > /dev/null
for lambda in 100 0.01; do
  # shellcheck disable=SC2086
  "$relievo" render examples/wolf.svg $look --method nonlinear --lambda-bnd "$lambda" \
    -o "$work/nonlinear-$lambda.png" > /dev/null
done
convert "$work/inflation.png" "$work/shift.png" "$work/relief.png" +append "$to/wolf-fields.png"
convert "$work/steps.png" -resize 50% "$to/wolf-convergence.png"
convert "$work/approximate.png" "$work/nonlinear-100.png" "$work/nonlinear-0.01.png" +append \
  "$to/joint-ends.png"

# Values of lambda_bnd: what the paper's 100 and 0.01 are in our unit, and smaller ones.
look="--view front --clay --window 620 560 420 --light -60 30 --size 300"
# shellcheck disable=SC2086
"$relievo" render examples/wolf.svg $look --ramps robin -o "$work/legs-robin.png" > /dev/null
for lambda in 125000 12.5 0.3 0.01; do
  # shellcheck disable=SC2086
  "$relievo" render examples/wolf.svg $look --method nonlinear --lambda-bnd "$lambda" \
    -o "$work/legs-$lambda.png" > /dev/null
done
convert "$work/legs-robin.png" "$work/legs-125000.png" "$work/legs-12.5.png" \
  "$work/legs-0.3.png" "$work/legs-0.01.png" +append "$to/lambda-units.png"

# Approximate and non-linear side by side, a row for each of the drawings.
for name in wolf bunny farmer unicorn elephant lamb; do
  look="--yaw -20 --pitch 8 --clay --size 300"
  # shellcheck disable=SC2086
  "$relievo" render "examples/$name.svg" $look -o "$work/$name-approximate.png" > /dev/null
  for lambda in 100 0.01; do
    # shellcheck disable=SC2086
    "$relievo" render "examples/$name.svg" $look --method nonlinear --lambda-bnd "$lambda" \
      -o "$work/$name-$lambda.png" > /dev/null
  done
  convert "$work/$name-approximate.png" "$work/$name-100.png" "$work/$name-0.01.png" +append \
    "$work/$name-row.png"
done
convert "$work/wolf-row.png" "$work/unicorn-row.png" "$work/elephant-row.png" "$work/lamb-row.png" \
  "$work/bunny-row.png" "$work/farmer-row.png" -append -colors 128 "$to/fidelity.png"
