#!/bin/sh
# Makes what others install, in build/packages: Debian packages of the program, the library, the
# Python module and the editor, an archive of the program that needs nothing but a C library, the core
# for npm and the add-on for Blender. Usage: make-packages.sh [deb|archive|npm|blender]...; all where
# nothing is named.
set -eu
cd "$(dirname "$0")/.."
jobs=$(nproc 2> /dev/null || echo 2)
packages=$PWD/build/packages
version=$(sed -n 's/^project(relievo VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ $# -gt 0 ] || set -- deb archive npm blender

# The same sources make the same packages.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2> /dev/null || echo 0)
export SOURCE_DATE_EPOCH

build_program() {
  scripts/install-packages.sh python
  cmake --preset package -DRELIEVO_COMMIT="$(git describe --always --dirty 2> /dev/null || true)" \
    -DRELIEVO_PACKAGES_DATE="$(LC_ALL=C date -u -R -d "@$SOURCE_DATE_EPOCH")" > /dev/null
  cmake --build build/package -j "$jobs"
}

make_debs() {
  build_program
  scripts/build-web.sh
  rm -f "$packages"/*.deb
  (umask 022 && cd build/package && cpack -G DEB > /dev/null)
  rm -rf "$packages/_CPack_Packages"
}

# The libraries of the program beside it, with their licences; a C library is everywhere.
make_archive() {
  build_program
  name=relievo-$version-linux-$(uname -m)
  root=$packages/$name
  rm -rf "$root" "$root.tar.xz"
  cmake --install build/package --strip --component program --prefix "$root" > /dev/null
  mkdir -p "$root/lib/relievo" "$root/share/doc/relievo/libraries"
  mv "$root/bin/relievo" "$root/lib/relievo/relievo"
  ldd "$root/lib/relievo/relievo" | sed -n 's/.*=> \(\/[^ ]*\).*/\1/p' | while read -r library; do
    case "${library##*/}" in libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | libresolv.so.*) continue ;; esac
    cp -L "$library" "$root/lib/relievo/"
    owner=$(dpkg-query -S "*/${library##*/}" | sed -n '1s/:.*//p')
    cp "/usr/share/doc/$owner/copyright" "$root/share/doc/relievo/libraries/$owner"
  done
  cat > "$root/bin/relievo" << 'END'
#!/bin/sh
root=$(dirname "$(dirname "$(readlink -f "$0")")")
LD_LIBRARY_PATH="$root/lib/relievo${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" exec "$root/lib/relievo/relievo" "$@"
END
  chmod 755 "$root/bin/relievo"
  tar -C "$packages" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" \
    -cJf "$root.tar.xz" "$name"
  rm -rf "$root"
}

# The binding's JavaScript and WebAssembly under one face, with types made of the editor's.
make_npm() {
  scripts/build-web.sh
  stage=$packages/npm
  rm -rf "$stage" "$packages"/*.tgz
  mkdir -p "$stage"
  cp bindings/npm/* web/engine/messages.ts LICENSE build/wasm/bindings/wasm/relievo.mjs \
    build/wasm/bindings/wasm/relievo.wasm "$stage"
  # The declared module becomes a file of declarations.
  sed -e '/^declare module/d' -e '$d' -e "s|'./messages'|'./messages.js'|" \
    web/engine/relievo_module.d.ts > "$stage/relievo.d.mts"
  ln -s "$PWD/web/node_modules" "$stage/node_modules"
  web/node_modules/.bin/tsc -p "$stage"
  rm "$stage/node_modules"
  (cd "$stage" && npm version --silent --no-git-tag-version --allow-same-version "$version" > /dev/null &&
    npm pack --silent --pack-destination "$packages" > /dev/null)
  rm -rf "$stage"
}

make_blender() {
  stage=$packages/blender
  rm -rf "$stage"
  mkdir -p "$stage/relievo_addon"
  cp bindings/blender/relievo_addon/*.py "$stage/relievo_addon"
  (cd "$stage" && /usr/bin/python3 -m zipfile -c "$packages/relievo-blender-$version.zip" relievo_addon)
  rm -rf "$stage"
}

mkdir -p "$packages"
for kind in "$@"; do
  case "$kind" in
    deb) make_debs ;;
    archive) make_archive ;;
    npm) make_npm ;;
    blender) make_blender ;;
    *) echo "usage: $0 [deb|archive|npm|blender]..." >&2; exit 2 ;;
  esac
done
ls -l "$packages"
