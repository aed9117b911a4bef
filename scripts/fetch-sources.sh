#!/bin/sh
# Fetches the sources of the libraries that the browser's engine is compiled with, as Debian's
# signed source packages: the same releases that the command line links to. Nothing on the system
# changes; does nothing where all are there. Usage: fetch-sources.sh FOLDER
set -eu
[ $# -eq 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
packages="libpng1.6 libpolyclipping meshoptimizer pugixml zlib"

mkdir -p "$1"
cd "$1"
missing=""
for package in $packages; do
  [ -d "$package" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

# apt with lists of its own: the system's archives, but their sources instead of their packages.
state=$PWD/.apt
rm -rf "$state"
mkdir -p "$state/parts" "$state/lists/partial"
[ ! -f /etc/apt/sources.list ] ||
  sed -n 's/^deb /deb-src /p' /etc/apt/sources.list > "$state/parts/classic.list"
for file in /etc/apt/sources.list.d/*.sources; do
  if grep -qi debian "$file" 2> /dev/null; then
    sed 's/^Types:.*/Types: deb-src/' "$file" > "$state/parts/$(basename "$file")"
  fi
done
own_apt() {
  apt-get -q -q -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$state/parts" \
    -o Dir::State::Lists="$state/lists" -o Dir::Cache="$state" "$@"
}
own_apt update >&2
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)

for package in $missing; do
  rm -rf "$state/unpacked"
  mkdir "$state/unpacked"
  # A mirror may announce a security update before it has it; the release itself is always there.
  (cd "$state/unpacked" && { own_apt source --only-source "$package" ||
    own_apt source --only-source "$package/$release"; } >&2)
  mv "$(find "$state/unpacked" -mindepth 1 -maxdepth 1 -type d)" "$package"
done
rm -rf "$state"
