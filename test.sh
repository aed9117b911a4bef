#!/bin/sh
# Builds the program and the editor and runs their tests. With --all also the tests under the address
# and undefined-behaviour sanitizers, the long surveys, the linter, the pages of the interface, a
# program built against the installed package, a tenth of the learning from layered drawings and, as
# root, a batch on a Slurm cluster of this machine.
set -eu
cd "$(dirname "$0")"
# Comparisons with slow reference solvers, many scenes, solids and kills, a slicer, Blender.
surveys='^NonlinearReferences|^Lambda/RandomScenes|^Slicer|^SolidSurvey|^Blender|^campaign_(kills|memory)$'
case "${1:-}" in
  "") all='' packages=test left_out="$surveys|^consumer\$|^lint\$" ;;
  --all) all=yes packages=all left_out='^$' ;;
  *) echo "usage: $0 [--all]" >&2; exit 2 ;;
esac
jobs=$(nproc 2> /dev/null || echo 2)

scripts/install-packages.sh "$packages"
if command -v npm > /dev/null; then
  (cd tests/tools && npm ci --ignore-scripts --no-audit --no-fund --silent) ||
    echo "No glTF validator from npm; the tests that need it are skipped." >&2
fi

if [ "$all" ]; then
  export RELIEVO_LONG=1
  scripts/build-docs.sh
  cmake --preset asan > /dev/null
  cmake --build build/asan -j "$jobs"
  # Surveys and measurements tell nothing more here; they run below.
  UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_stack_use_after_return=1 \
    LSAN_OPTIONS=suppressions=$PWD/tests/leaks.supp:print_suppressions=0 \
    ctest --test-dir build/asan -j "$jobs" --output-on-failure --no-tests=error \
      -E "$surveys|^Seam|^SolidSamples|Invariance|^OperationCounts|DoesNotFlicker|^PaperSizes|^Scenes/Random.*/[12]"
  # The tests that follow run on the libraries that are packed.
  scripts/make-packages.sh
  build=build/package
  cmake --preset package -DRELIEVO_TESTS=ON -DRELIEVO_RESEARCH=ON > /dev/null
else
  build=build/test
  cmake --preset test > /dev/null
fi
export RELIEVO="$PWD/$build/apps/cli/relievo"
cmake --build "$build" -j "$jobs" --target relievo

if [ "$all" ]; then
  # Debian's Python, for which the module is built.
  PYTHONPATH="$PWD/build/package/python" \
    /usr/bin/python3 -m pytest -q -p no:cacheprovider tests/python
  tests/packages/packages.sh "$RELIEVO"
  tests/packages/npm.sh "$RELIEVO"
  tests/blender/blender.sh "$RELIEVO" "$PWD/build/package/python"
fi

# The editor: its modules, its engine against the command line, and journeys in a real browser,
# which wait now and then. The program's tests are compiled meanwhile, with what the journeys leave of
# the processors; journeys that measure come after that.
scripts/build-web.sh
nice -n 19 cmake --build "$build" -j "$jobs" > "$build/tests.log" 2>&1 &
compiling=$!
trap 'kill "$compiling" 2> /dev/null || true' EXIT
(cd web && npm run --silent test && npm run --silent journeys)
wait "$compiling" || { cat "$build/tests.log" >&2; exit 1; }
trap - EXIT
(cd web && npm run --silent measured)

[ -z "$all" ] || scripts/learn.sh build/learning 0.1
if [ "$all" ] && [ "$(id -u)" -eq 0 ]; then
  tests/cluster/slurm.sh "$RELIEVO"
fi

ctest --test-dir "$build" -j "$jobs" --output-on-failure --no-tests=error -E "$left_out"
