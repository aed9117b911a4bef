#!/bin/sh
# Installs the Debian packages that are missing; does nothing, quickly, where all are there.
# Usage: install-packages.sh [build|python|web|test|bench|docs|fuzz|figures|learn|all]
# build: to compile and run; web: those and for the editor; test: all of these and to test; bench:
# the first and to measure; python: the first, and for the Python module and its tests; docs: to make
# pages of the interface; fuzz: the first and to fuzz; figures: the first and to remake the pictures
# of docs/figures.md; learn: the first and to learn from a corpus of drawings; all: those of test and python, and for the tests
# of packages, of printing, of Blender and of a Slurm cluster of one machine
set -eu

build="ca-certificates ccache cmake g++ libcgal-dev libcli11-dev libeigen3-dev libembree-dev
  libgif-dev libheif-dev libjpeg-dev libmeshoptimizer-dev libpng-dev libpolyclipping-dev
  libpugixml-dev librsvg2-dev libwebp-dev libzip-dev lld ninja-build nlohmann-json3-dev
  pkg-config zlib1g-dev"
web="dpkg-dev emscripten libboost-dev"
test="admesh chromium clang-format clang-tidy coinor-libipopt-dev lib3mf-dev libgtest-dev
  librapidcheck-dev libvalijson-dev shellcheck"
bench="libbenchmark-dev libopenblas0-pthread libopenblas-pthread-dev libsuitesparse-dev python3"
figures="imagemagick librsvg2-bin python3 python3-numpy python3-pil"
learn="librsvg2-bin python3 python3-numpy python3-pil python3-scipy python3-sklearn python3-torch"
python="libpython3-dev mypy pybind11-dev python3 python3-numpy python3-pil python3-pytest"
all="blender debootstrap lintian munge prusa-slicer slurm-client slurmctld slurmd"

# Any node serves; Debian's where there is none.
command -v npm > /dev/null || { web="$web nodejs npm" learn="$learn nodejs npm"; }

case "${1:-test}" in
  build) wanted="$build" ;;
  python) wanted="$build $python" ;;
  web) wanted="$build $web" ;;
  test) wanted="$build $web $test" ;;
  all) wanted="$build $web $test $python $all" ;;
  bench) wanted="$build $bench" ;;
  docs) wanted="doxygen" ;;
  figures) wanted="$build $figures" ;;
  learn) wanted="$build $learn" ;;
  fuzz) wanted="$build clang libclang-rt-14-dev" ;;
  *) echo "usage: $0 [build|python|web|test|bench|docs|fuzz|figures|learn|all]" >&2; exit 2 ;;
esac

if ! command -v dpkg-query > /dev/null; then
  echo "This system has no Debian packages. Install what these stand for, then try again:" >&2
  echo "$wanted" >&2
  exit 1
fi

# shellcheck disable=SC2086
installed=$(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' $wanted 2> /dev/null |
  sed -n 's/^ii  *//p') || true
missing=""
for package in $wanted; do
  case "
$installed
" in
    *"
$package
"*) ;;
    *) missing="$missing $package" ;;
  esac
done
[ -n "$missing" ] || exit 0

as_root=""
[ "$(id -u)" -eq 0 ] || as_root="sudo"
echo "Installing:$missing" >&2
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq >&2 || echo "Package lists could not be updated; trying without." >&2
# shellcheck disable=SC2086
if ! $as_root apt-get install -y -qq --no-install-recommends $missing >&2; then
  echo "Could not install:$missing. Is there a network connection?" >&2
  exit 1
fi
