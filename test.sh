#!/bin/sh
# Builds everything and runs every test: first under the address and undefined-behaviour
# sanitizers, then the editor's, and last optimised, with the linter and a program built against
# the installed package.
set -eu
cd "$(dirname "$0")"
jobs=$(nproc 2> /dev/null || echo 2)

scripts/install-packages.sh test
if command -v npm > /dev/null; then
  (cd tests/tools && npm ci --ignore-scripts --no-audit --no-fund --silent) ||
    echo "No glTF validator from npm; the tests that need it are skipped." >&2
fi

cmake --preset asan > /dev/null
cmake --build build/asan -j "$jobs"
# Comparisons with slow reference solvers tell nothing more here; they run below.
UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_stack_use_after_return=1 \
  LSAN_OPTIONS=suppressions=$PWD/tests/leaks.supp:print_suppressions=0 \
  ctest --test-dir build/asan -j "$jobs" --output-on-failure --no-tests=error \
  -E '^JointReferences|^Lambda/RandomScenes'

cmake --preset dev > /dev/null
cmake --build build/dev -j "$jobs"

# The editor: its modules, its engine against the command line, and journeys in a real browser.
scripts/build-web.sh
(cd web && npm run --silent test && npm run --silent journeys)

ctest --test-dir build/dev -j "$jobs" --output-on-failure --no-tests=error
