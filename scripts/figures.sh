#!/bin/sh
# Remakes the paper's figures and table from the samples, by all methods, into docs/figures and
# docs/figures.md. Given TRUTH, a folder of rendered characters (research/figures/compare-truth.py
# describes it), measures all methods on them as well, which takes a quarter of an hour more.
# Installs the packages that it needs and builds the programs.
# Usage: figures.sh [TRUTH]
set -eu
truth="${1:+$(realpath "$1")}"
cd "$(dirname "$0")/.."
scripts/install-packages.sh figures
cmake --preset figures > /dev/null
cmake --build build/figures --target relievo relievo-compare
relievo=build/figures/apps/cli/relievo
compare=build/figures/research/compare/relievo-compare
to=docs/figures
samples="wolf bunny farmer unicorn elephant lamb"
methods="relievo pillows firm-ends parabolic ink-and-ray entem"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$to"

# shot INPUT PICTURE OPTIONS...: a picture in clay, with light from the left.
shot() {
  input=$1
  picture=$2
  shift 2
  "$relievo" render "$input" -o "$work/$picture.png" --quiet --clay --light -60 30 "$@"
}

# sheet FIGURE COLUMNS WIDTH PICTURES...: these in rows.
sheet() {
  figure=$1
  columns=$2
  width=$3
  shift 3
  for picture in "$@"; do
    set -- "$@" "$work/$picture.png"
    shift
  done
  montage "$@" -tile "${columns}x" -geometry "${width}x+2+2" -background white "$work/sheet.png"
  convert "$work/sheet.png" -quality 82 "$to/$figure.jpg"
}

echo "Models and measures of all methods" >&2
for name in $samples; do
  for method in $methods; do
    "$compare" "examples/$name.svg" --as "$method" --quiet --map-size 512 \
      -o "$work/$name-$method.glb" --report "$work/$name-$method.json"
  done
  rsvg-convert --width 480 --keep-aspect-ratio --background-color white "examples/$name.svg" \
    -o "$work/$name.png"
done

echo "Figure 1: rivals and ours" >&2
for name in unicorn bunny; do
  for method in entem ink-and-ray relievo; do
    shot "$work/$name-$method.glb" "1-$name-$method" --view front --size 480
  done
done
sheet figure-01 3 300 unicorn 1-unicorn-entem 1-unicorn-relievo \
  bunny 1-bunny-ink-and-ray 1-bunny-relievo

echo "Figure 2: profiles" >&2
for method in parabolic pillows; do
  shot "$work/elephant-$method.glb" "2-$method-front" --view front --size 480
  shot "$work/elephant-$method.glb" "2-$method-side" --yaw 75 --pitch 0 --size 480
done
sheet figure-02 2 360 2-parabolic-front 2-pillows-front 2-parabolic-side 2-pillows-side

echo "Figure 3: inputs" >&2
for name in $samples; do
  "$relievo" check "examples/$name.svg" --overlay "$work/3-$name.png" > /dev/null 2>&1
done
# shellcheck disable=SC2086
sheet figure-03 6 220 $samples 3-wolf 3-bunny 3-farmer 3-unicorn 3-elephant 3-lamb

echo "Figure 4: the non-linear method" >&2
for lambda in 100 0.01; do
  for field in inflation shift relief; do
    shot examples/wolf.svg "4-$lambda-$field" --method nonlinear --lambda-bnd "$lambda" \
      --field "$field" --yaw -20 --pitch 8 --size 480
  done
done
sheet figure-04 3 300 4-100-inflation 4-100-shift 4-100-relief \
  4-0.01-inflation 4-0.01-shift 4-0.01-relief
"$relievo" build examples/wolf.svg --quiet --method nonlinear --convergence "$work/steps.png"
convert "$work/steps.png" -crop 480x +repage -resize 320x -set delay 60 -colors 48 \
  -layers Optimize "$to/figure-04.gif"

echo "Figure 5: boundary conditions" >&2
look="--view front --window 620 560 420 --size 300"
while read -r name options; do
  # shellcheck disable=SC2086
  shot examples/wolf.svg "5-$name" $look $options
done << END
dirichlet --ramps robin --alpha0 1
neumann --ramps robin --alpha0 0 --rho 1000
robin --ramps robin --alpha0 0.1
ours
END
# The overlay is larger than the canvas.
convert "$work/3-wolf.png" -resize 1000x -crop 420x336+410+392 +repage "$work/5-input.png"
sheet figure-05 5 240 5-input 5-dirichlet 5-neumann 5-robin 5-ours

echo "Figure 6: bulges" >&2
for method in entem relievo; do
  for name in unicorn elephant; do
    shot "$work/$name-$method.glb" "6-$name-$method" --yaw 20 --pitch 8 --size 480
  done
done
sheet figure-06 2 360 6-unicorn-entem 6-elephant-entem 6-unicorn-relievo 6-elephant-relievo

echo "Figures 7 and 8: seams" >&2
for name in $samples; do
  for method in ink-and-ray relievo; do
    shot "$work/$name-$method.glb" "7-$name-$method" --view front --size 480
  done
  upper="${upper:-} 7-$name-ink-and-ray"
  lower="${lower:-} 7-$name-relievo"
done
# shellcheck disable=SC2086
sheet figure-07 6 230 $upper $lower
for azimuth in 0 45 90 135 180 225 270 315; do
  # Around the line of sight, low: as a lamp that is carried round the drawing.
  light=$(awk "BEGIN { a = $azimuth * 3.14159265 / 180; e = 20 * 3.14159265 / 180
    x = cos(e) * cos(a); y = cos(e) * sin(a); z = sin(e)
    print atan2(x, z) * 57.2957795, atan2(y, sqrt(x * x + z * z)) * 57.2957795 }")
  for method in ink-and-ray relievo; do
    # shellcheck disable=SC2086
    "$relievo" render "$work/wolf-$method.glb" -o "$work/8-$method-$azimuth.png" --quiet --clay \
      --view front --window 600 480 520 --size 300 --light $light
  done
  first="${first:-} 8-ink-and-ray-$azimuth"
  second="${second:-} 8-relievo-$azimuth"
  convert "$work/8-ink-and-ray-$azimuth.png" "$work/8-relievo-$azimuth.png" +append \
    "$work/8-frame-$azimuth.png"
  frames="${frames:-} $work/8-frame-$azimuth.png"
done
# shellcheck disable=SC2086
sheet figure-08 8 180 $first $second
# shellcheck disable=SC2086
convert $frames -set delay 35 -colors 64 -layers Optimize "$to/figure-08.gif"

echo "Figure 9: both methods" >&2
for name in wolf elephant lamb unicorn; do
  look="--yaw -20 --pitch 8 --size 400"
  # shellcheck disable=SC2086
  {
    shot "examples/$name.svg" "9-$name-a" $look --method nonlinear --lambda-bnd 100
    shot "examples/$name.svg" "9-$name-b" $look --ramps robin --alpha0 1
    shot "examples/$name.svg" "9-$name-c" $look --method nonlinear --lambda-bnd 0.01
    shot "examples/$name.svg" "9-$name-d" $look
  }
  rows="${rows:-} 9-$name-a 9-$name-b 9-$name-c 9-$name-d"
done
# shellcheck disable=SC2086
sheet figure-09 4 260 $rows

echo "Figure 10: the limitation" >&2
# What our method made of it once, as the paper's does, no option makes any more.
cp docs/pictures/nose-pulled.png "$work/10-pulled.png"
shot examples/nose.json 10-ours --yaw 30 --pitch 10 --size 420
sheet figure-10 2 300 10-pulled 10-ours

echo "Figures 11 and 12, table 1: six subjects" >&2
for name in $samples; do
  yaw=-25
  [ "$name" != unicorn ] || yaw=25
  "$relievo" render "$work/$name-relievo.glb" -o "$work/11-$name.png" --quiet --yaw "$yaw" \
    --pitch 8 --size 480
  shot "$work/$name-relievo.glb" "12-$name-45" --yaw 45 --pitch 8 --size 480
  shot "$work/$name-relievo.glb" "12-$name-75" --yaw -75 --pitch 8 --size 480
  coloured="${coloured:-} 11-$name"
  turned="${turned:-} 12-$name-45"
  aside="${aside:-} 12-$name-75"
done
# shellcheck disable=SC2086
sheet figure-11 6 230 $samples $coloured
# shellcheck disable=SC2086
sheet figure-12 6 230 $turned $aside
while read -r name vertices; do
  "$relievo" build "examples/$name.svg" --quiet --vertices "$vertices" \
    --report "$work/$name-time.json"
done << END
wolf 32000
bunny 19000
farmer 33000
unicorn 22000
elephant 39000
lamb 30000
END

# shellcheck disable=SC2086
research/figures/figures-table.py "$work" docs/figures.md $methods
if [ -n "$truth" ]; then
  echo "Rendered characters" >&2
  # shellcheck disable=SC2086
  research/figures/compare-truth.py "$compare" "$truth" docs/figures.md $methods
fi
