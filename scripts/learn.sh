#!/bin/sh
# Learns from layered drawings how flat ones are understood, and measures it: gathers a corpus, trains
# the network of src/understanding/perception, fits the trees of src/understanding/areas and prints how
# well drawings of other artists are understood. Needs 20 GB of memory. All that it makes stays in
# FOLDER but for the weights and the trees. A run that was stopped goes on with the figures that it had
# gathered. With a SHARE below 1 it is a trial with that share of figures and steps, of which the
# weights and trees stay in FOLDER too. Usage: learn.sh FOLDER [SHARE]
set -eu
[ $# -ge 1 ] || { echo "usage: $0 FOLDER [SHARE]" >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
share=${2:-1}
cd "$(dirname "$0")/.."
python=/usr/bin/python3
weights=src/understanding/perception/network.bin
trees=src/understanding/areas
if [ "$share" != 1 ]; then
  weights=$folder/network.bin
  trees=$folder
fi
part_of() { awk "BEGIN { print int($1 * $share + 0.5) }"; }

scripts/install-packages.sh learn
build() {
  cmake --preset test -DRELIEVO_RESEARCH=ON > /dev/null
  cmake --build build/test -j "$(nproc)" --target relievo relievo-regions
}
program=build/test/apps/cli/relievo

build
"$python" research/corpus/gather.py "$program" "$folder" --share "$share"
"$python" research/learning/paint.py "$folder" "$folder/pictures" tuning --side 512 --each 11 \
  --shapes "$(part_of 400)"
"$python" research/learning/network.py "$folder/pictures" "$weights" --steps "$(part_of 6000)"
build
"$python" research/learning/paint.py "$folder" "$folder/regions" tuning --each 2 \
  --most "$(part_of 250)" --shapes "$(part_of 60)"
"$python" research/learning/regions.py build/test/research/learning/relievo-regions "$folder/regions" "$trees"
build
"$python" research/corpus/table.py "$program" "$folder" validation --most "$(part_of 100)"
