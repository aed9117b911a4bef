#!/bin/sh
# Checks the layout of all sources, runs clang-tidy over the program and its libraries, and looks
# over the scripts. Usage: lint.sh [BUILD_DIR with compile_commands.json]
set -eu
cd "$(dirname "$0")/.."
build="${1:-build/dev}"
jobs=$(nproc 2> /dev/null || echo 2)

if [ ! -f "$build/compile_commands.json" ]; then
  echo "lint: $build has no compile_commands.json; configure the dev preset first" >&2
  exit 1
fi

find src apps bindings tests benchmarks \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format --dry-run -Werror

find src apps -name '*.cpp' -print0 | sort -z |
  xargs -0 -n 1 -P "$jobs" clang-tidy -p "$build" --quiet --extra-arg=-Wno-unknown-warning-option 2> "$build/clang-tidy.log" ||
  { cat "$build/clang-tidy.log" >&2; exit 1; }

shellcheck run.sh test.sh .ci/run scripts/*.sh
echo "lint: nothing to complain about"
