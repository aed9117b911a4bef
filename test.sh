#!/bin/sh
# Builds everything and runs every test: first under the address and undefined-behaviour
# sanitizers, then optimised, with the linter and a program built against the installed package.
set -eu
cd "$(dirname "$0")"
jobs=$(nproc 2> /dev/null || echo 2)

scripts/install-packages.sh test

cmake --preset asan > /dev/null
cmake --build build/asan -j "$jobs"
UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_stack_use_after_return=1 \
  ctest --test-dir build/asan -j "$jobs" --output-on-failure --no-tests=error

cmake --preset dev > /dev/null
cmake --build build/dev -j "$jobs"
ctest --test-dir build/dev -j "$jobs" --output-on-failure --no-tests=error
