#!/bin/sh
# Checks the layout of all sources, the comments of the interface and the scripts, and runs clang-tidy over the program
# and its libraries, which takes a while. Usage: lint.sh [BUILD_DIR with compile_commands.json]
# lint.sh --quick leaves clang-tidy out.
set -eu
cd "$(dirname "$0")/.."
find include src apps bindings research tests benchmarks examples \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format --dry-run -Werror
shellcheck run.sh test.sh .ci/run scripts/*.sh scripts/cluster/*.sh tests/*/*.sh
# Takes less than a second; where it is missing, ./test.sh --all looks.
if command -v doxygen > /dev/null; then doxygen docs/Doxyfile; fi
if [ "${1:-}" = --quick ]; then
  echo "lint: layout and scripts are as they should be"
  exit 0
fi

build="${1:-build/dev}"
jobs=$(nproc 2> /dev/null || echo 2)
if [ ! -f "$build/compile_commands.json" ]; then
  echo "lint: $build has no compile_commands.json; configure the dev preset first" >&2
  exit 1
fi
find src apps research -name '*.cpp' -print0 | sort -z |
  xargs -0 -n 1 -P "$jobs" clang-tidy -p "$build" --quiet \
    --extra-arg=-Wno-unknown-warning-option 2> "$build/clang-tidy.log" ||
  { cat "$build/clang-tidy.log" >&2; exit 1; }
echo "lint: nothing to complain about"
