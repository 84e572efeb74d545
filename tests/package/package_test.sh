#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# package_test.sh BUILD: makes the Debian package of a build, unpacks it into a scratch root and uses
# the program there from an empty folder: where the kernel lets it, in a mount namespace in which the
# checkout and the build are hidden. Exits with 77, for "skipped", without dpkg's tools.
set -euo pipefail
for tool in dpkg-deb dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || { echo "skipped: there is no $tool (Debian: dpkg-dev)"; exit 77; }
done
build=$(realpath "$1")
source=$(realpath "$(dirname "$0")/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "package_test.sh: $*" >&2; exit 1; }
expect() { grep -qF -- "$2" <<<"$1" || fail "'$2' is not in: $1"; }

package=$("$source/cmake/make_deb.sh" "$build" "$work/out")
root="$work/root"
dpkg-deb -x "$package" "$root"

# One version everywhere.
version=$(dpkg-deb -f "$package" Version)
[[ $package == "$work/out/bulletnav_${version}_$(dpkg --print-architecture).deb" ]] || fail "$package"
expect "$(cat "$source/CITATION.cff")" "version: $version"
expect "$(cat "$source/CMakeLists.txt")" "project(bulletnav VERSION $version "

# Dependencies were found, and nothing but the package's own folders is written to.
for library in libc6 libembree3 libbullet libassimp5 libcairo2 fonts-dejavu-core; do
  expect "$(dpkg-deb -f "$package" Depends)" "$library"
done
others=$(cd "$root" && find . -not -type d | grep -vE \
  '^\./usr/(bin/bulletnav$|lib/bulletnav/|share/bulletnav/|share/doc/bulletnav/)' || true)
[[ -z $others ]] || fail "holds $others"
[[ $(readlink "$root/usr/bin/bulletnav") == ../lib/bulletnav/bulletnav ]] || fail "link"
owners=$(dpkg-deb -c "$package" | awk '{ print $2 }' | sort -u)
[[ $owners == root/root ]] || fail "belongs to $owners"
for folder in "$source" "$build"; do
  if grep -rlF -- "$folder" "$root/usr/lib/bulletnav"; then fail "these name $folder"; fi
done

# The program, from an empty folder.
cat >"$work/use.sh" <<'USE'
set -euo pipefail
if [[ $1 == hide ]]; then
  mount -t tmpfs none "$2"
  [[ ! -e $3 ]] || mount -t tmpfs none "$3"
fi
mkdir "$4/empty" && cd "$4/empty"
program="$4/root/usr/bin/bulletnav"
"$program" --version
"$program" scenes generate --count 1 --out made
ls made
"$program" run configs/quickstart.yaml houses.count=1 max_steps=12 episodes.draw.counts.easy=1 \
  episodes.draw.counts.medium=0 episodes.draw.counts.hard=0 --require-all --no-plots --workers 1
if [[ -e $4/root/usr/lib/bulletnav/bulletnav-slam.so ]]; then "$program" slam --help; fi
if [[ -e $4/root/usr/lib/bulletnav/bulletnav-learning.so ]]; then "$program" train --help; fi
USE
hide=bare
enter=()
if unshare --user --map-root-user --mount true 2>/dev/null; then
  hide=hide
  enter=(unshare --user --map-root-user --mount)
fi
said=$("${enter[@]}" env -i PATH=/usr/bin:/bin HOME="$work" \
  bash "$work/use.sh" "$hide" "$source" "$build" "$work" 2>&1) || fail "$said"
expect "$said" "bulletnav $version ("
expect "$said" "house_000.glb"
expect "$said" "configs/quickstart.yaml is not here; $root/usr/share/bulletnav/configs/quickstart.yaml"
for agent in nts metric_map_fbe random shortest_path; do
  expect "$(cat "$work/empty/results/quickstart/episodes.jsonl")" "\"agent\":\"$agent\""
done
echo "package_test.sh: $(basename "$package"), used with the checkout ${hide/hide/hidden}"
