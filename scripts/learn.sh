#!/bin/sh
# Learns from layered drawings how flat ones are understood, and measures it: gathers a corpus, trains
# the network of src/understanding/perception, fits the tables of src/understanding/areas and prints how
# well drawings of other artists are understood. All of it stays in FOLDER but for the weights and
# tables. A run that was stopped goes on with the corpus that it had. Usage: learn.sh FOLDER [STEPS]
set -eu
[ $# -ge 1 ] || { echo "usage: $0 FOLDER [STEPS]" >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
steps=${2:-9000}
cd "$(dirname "$0")/.."
python=/usr/bin/python3
learning=src/understanding

scripts/install-packages.sh learn
build() {
  cmake --preset test -DRELIEVO_RESEARCH=ON > /dev/null
  cmake --build build/test -j "$(nproc)" --target relievo relievo-regions
}
program=build/test/apps/cli/relievo

build
"$python" research/corpus/gather.py "$program" "$folder"
"$python" research/learning/paint.py "$folder" "$folder/pictures" tuning --each 12 --shapes 800 --side 512
"$python" research/learning/network.py "$folder/pictures" "$learning/perception/network.bin" --steps "$steps"
build
"$python" research/learning/paint.py "$folder" "$folder/regions" tuning --each 2 --most 250 --shapes 60
"$python" research/learning/regions.py build/test/research/learning/relievo-regions "$folder/regions" \
  "$learning/areas"
build
"$python" research/corpus/table.py "$program" "$folder" validation
