#!/bin/sh
# Fuzzes the readers, one after the other, and keeps what they find in build/fuzz/found.
# Usage: fuzz.sh [SECONDS_EACH [READER...]]   (60 s, all readers)
# Goes on from the inputs that earlier runs have found worth keeping, in build/fuzz/corpus.
set -eu
cd "$(dirname "$0")/.."

seconds="${1:-60}"
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- svg scene archive picture layers psd glb scribbles

scripts/install-packages.sh fuzz
cmake --preset fuzz > /dev/null
for reader in "$@"; do
  cmake --build build/fuzz --target "fuzz_$reader" > /dev/null
  mkdir -p "build/fuzz/corpus/$reader" "build/fuzz/found/$reader"
  echo "$reader:"
  "build/fuzz/fuzz/fuzz_$reader" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=65536 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="build/fuzz/found/$reader/" \
    "build/fuzz/corpus/$reader" "fuzz/seeds/$reader"
done
