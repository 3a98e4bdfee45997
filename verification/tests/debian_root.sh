#!/bin/sh
# The README's first steps on another Debian: a bare root of the release SUITE (bookworm, trixie, sid), made by
# debootstrap from this machine's own mirror, in which ./slosh installs what it needs, builds the tool and runs
# `campaign verification --quick`; then the release unit tests are built and run. With `readme` it runs the README's two
# commands instead, whole: `campaign small_amplitude`, then `test`. DIRECTORY is kept, and taken again where it holds a
# root already. Exit status: that of the first step that fails; 77 (skipped) without root's rights, debootstrap or the
# mirror.
# Usage: debian_root.sh SOURCE_TREE SUITE DIRECTORY [readme]
set -eu

source_tree=$(readlink -f -- "$1")
suite=$2
directory=$3
if [ "${4-readme}" != readme ]; then
  echo "the fourth argument is '$4'; expected 'readme' or none"
  exit 2
fi

skip() {
  echo "skipped: $*"
  exit 77
}

if [ "$(id -u)" != 0 ]; then skip "debootstrap needs root's rights"; fi
if ! command -v debootstrap >/dev/null; then skip "debootstrap is not installed"; fi

# The first Debian archive that apt takes packages from.
mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
  sed -nE 's/^(URIs:|deb( \[[^]]*\])?) *(https?:[^ ]*debian\/?)( .*)?$/\3/p' | head -n 1)
: "${mirror:=http://deb.debian.org/debian}"

if [ ! -e "$directory/etc/debian_version" ]; then
  rm -rf "$directory"
  mkdir -p "$directory"
  if ! debootstrap --variant=minbase "$suite" "$directory" "$mirror" >"$directory.log" 2>&1; then
    tail -n 3 "$directory.log"
    skip "debootstrap of $suite from $mirror failed (log: $directory.log)"
  fi
fi

leave() { umount -l "$directory/proc" "$directory/sys" "$directory/dev" 2>/dev/null || true; }
trap leave EXIT
leave
mount -t proc proc "$directory/proc"
mount --rbind /sys "$directory/sys"
mount --rbind /dev "$directory/dev"
cp /etc/resolv.conf "$directory/etc/resolv.conf"

# What git tracks, or all but the builds where the tree is no checkout. Every file is as new as this copy, so that
# nothing of an earlier build is taken for one of these files.
mkdir -p "$directory/slosh"
(cd "$source_tree" && { git ls-files -z 2>/dev/null || find . -path ./build -prune -o -type f -print0; } |
  tar --null -T - -cf -) | tar -C "$directory/slosh" -xmf -

inside() { chroot "$directory" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root sh -ec "cd /slosh; $*"; }
if [ "${4-}" = readme ]; then
  inside 'date; ./slosh campaign small_amplitude; date; ./slosh test; date'
  exit
fi
inside ./slosh campaign verification --quick
inside 'cmake --preset release -DSLOSH_UNIT_TESTS=ON && cmake --build build/release --target unit_tests &&
        ctest --test-dir build/release -j "$(nproc)" -L "^unit$" --output-on-failure --no-tests=error'
