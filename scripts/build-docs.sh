#!/bin/sh
# Makes pages of the library's interface in build/docs/html; fails where a comment is not sound.
set -eu
cd "$(dirname "$0")/.."

scripts/install-packages.sh docs
mkdir -p build/docs
doxygen docs/Doxyfile
echo "docs: build/docs/html/index.html"
