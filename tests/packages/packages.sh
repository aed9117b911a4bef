#!/bin/sh
# Whether what scripts/make-packages.sh made in build/packages can be used: lintian finds no errors,
# a program builds against the library's package, and in a root where nothing of ours is installed the
# archive, the program's package and the Python module do the README's first example, with the bytes of
# PROGRAM. Needs to be root for the last. Usage: packages.sh PROGRAM
set -eu
program=$(readlink -f "$1")
cd "$(dirname "$0")/../.."
packages=build/packages
work=$(mktemp -d)
root=$work/root

clean() {
  umount "$root/proc" 2> /dev/null || true
  rm -rf --one-file-system "$work"
}
trap clean EXIT

same() {
  cmp "$work/wolf.glb" "$1" || { echo "packages: $2 makes another model" >&2; exit 1; }
  echo "packages: $2: same bytes"
}

lintian --fail-on error --tag-display-limit 0 "$packages"/*.deb
"$program" build examples/wolf.svg -q -o "$work/wolf.glb"

for package in "$packages"/librelievo-dev_*.deb; do dpkg-deb -x "$package" "$work/library"; done
cmake -S examples/embed -B "$work/embed" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$work/library/usr" > /dev/null
cmake --build "$work/embed" > /dev/null
mkdir "$work/embedded"
"$work/embed/embed" examples/wolf.svg "$work/embedded/wolf.glb"
same "$work/embedded/wolf.glb" "a program built with librelievo-dev"

if [ "$(id -u)" -ne 0 ]; then
  echo "packages: not root; nothing is installed" >&2
  exit 0
fi
debootstrap --variant=minbase bookworm "$root" "${RELIEVO_MIRROR:-http://deb.debian.org/debian}" \
  > "$work/debootstrap.log" 2>&1 || { tail "$work/debootstrap.log" >&2; exit 1; }
mount -t proc proc "$root/proc" || true
for folder in "" archive program python; do mkdir "$root/try/$folder"; done
cp examples/wolf.svg "$packages"/*.deb "$root/try"
tar -C "$root/try" -xJf "$packages"/relievo-*-linux-*.tar.xz

in_root() { chroot "$root" /bin/sh -euc "cd /try; $1"; }
in_root 'relievo-*-linux-*/bin/relievo build wolf.svg -q -o archive/wolf.glb'
same "$root/try/archive/wolf.glb" "the archive where nothing is installed"
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
in_root 'apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    ./relievo_*.deb ./python3-relievo_*.deb ./relievo-editor_*.deb > install.log 2>&1 ||
    { tail install.log; exit 1; }
  relievo build wolf.svg -q -o program/wolf.glb
  python3 -c "import relievo; relievo.build(\"wolf.svg\").save(\"python/wolf.glb\")"
  test -s /usr/share/relievo/editor/index.html
  test -s /usr/share/man/man1/relievo-build.1.gz
  apt-get remove -y -qq relievo python3-relievo relievo-editor > /dev/null
  test ! -e /usr/share/relievo'
same "$root/try/program/wolf.glb" "relievo in a clean root"
same "$root/try/python/wolf.glb" "python3-relievo in a clean root"
