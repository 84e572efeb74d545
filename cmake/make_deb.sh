#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# make_deb.sh BUILD FOLDER: packs the component `program` of cmake/install.cmake, as a build folder
# has it, as FOLDER/bulletnav_VERSION_ARCHITECTURE.deb and prints that name. What the program and the
# reader of scenes link is in Depends, what only the libraries for learning, SLAM and agents in Python
# link in Recommends: without them the rest runs. The same bytes from the same commit and build.
set -euo pipefail
build=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
architecture=$(dpkg --print-architecture)
file="$folder/bulletnav_${version}_$architecture.deb"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [[ -z ${SOURCE_DATE_EPOCH:-} ]]; then
  SOURCE_DATE_EPOCH=$(git -C "$source" log -1 --format=%ct 2>/dev/null || date +%s)
fi
export SOURCE_DATE_EPOCH

umask 022
stage="$work/stage"
DESTDIR="$stage" cmake --install "$build" --prefix /usr --component program --strip >"$work/log" ||
  { tail -n 5 "$work/log" >&2; exit 1; }

# "Depends: ..." and "Recommends: ...", of the packages that this machine has the libraries from.
dependencies() {
  mkdir -p "$work/debian"
  printf 'Source: bulletnav\n\nPackage: bulletnav\nArchitecture: any\n' >"$work/debian/control"
  local libraries=() library
  for library in "$stage"/usr/lib/bulletnav/*.so "$stage"/usr/lib/bulletnav/bulletnav-import-sdf; do
    [[ ! -e $library ]] || libraries+=(-e "$library")
  done
  (cd "$work" && dpkg-shlibdeps -O -dDepends -e "$stage/usr/lib/bulletnav/bulletnav" \
    -e "$stage/usr/lib/bulletnav/bulletnav-import" -dRecommends "${libraries[@]}" \
    2>"$work/log") || { cat "$work/log" >&2; exit 1; }
}
dependencies >"$work/found"
depends=$(sed -n 's/^shlibs:Depends=//p' "$work/found")
recommends=$(sed -n 's/^shlibs:Recommends=//p' "$work/found")

mkdir -p "$stage/DEBIAN"
cat >"$stage/DEBIAN/control" <<CONTROL
Package: bulletnav
Version: $version
Architecture: $architecture
Maintainer: The BulletNav authors
Section: science
Priority: optional
Installed-Size: $(du -k -s --apparent-size "$stage/usr" | cut -f 1)
Depends: $depends, fonts-dejavu-core
Recommends: ${recommends:+$recommends, }libegl1, libegl-mesa0, libgl1-mesa-dri, libopenblas0-openmp
Description: simulator and benchmark for image-goal navigation
 Furnished houses in a Bullet physics world, RGBD panoramas, noise of motion
 and odometry measured on a real robot, Neural Topological SLAM and baselines
 with their weights, topological SLAM, tables and replays in the browser.
CONTROL
find "$stage" -exec touch --no-dereference --date "@$SOURCE_DATE_EPOCH" {} +
dpkg-deb --root-owner-group -Zzstd -z9 --build "$stage" "$file" >"$work/log" 2>&1 ||
  { cat "$work/log" >&2; exit 1; }
printf '%s\n' "$file"
