#!/bin/sh
# The developer's kit says what is so: each preset is a tree of the launcher, the forge runs what CI runs, and what
# CONTRIBUTING.md and the architecture name is there.
# Usage: kit_test.sh SOURCE_TREE
set -eu
cd "$1"
failed=0
fail() {
  echo "FAILED: $*"
  failed=1
}

grep -q '^ *- run: \.ci/run$' .github/workflows/tests.yml || fail "the forge's workflow does not run .ci/run"
grep -q '\./slosh test' .ci/run || fail ".ci/run does not run ./slosh test"
for preset in $(cmake --list-presets | sed -nE 's/^ +"([a-z]+)".*/\1/p'); do
  grep -qE "configure $preset( |$)" slosh || fail "the preset $preset is no tree of the launcher"
done

# Paths in backquotes name files that are there, or patterns that match some; NAME stands for any name.
for document in CONTRIBUTING.md docs/architecture.md; do
  names=$(grep -oE '`[a-z_./]+/[A-Za-z_./*]*`' "$document" | tr -d '`' | sort -u | grep -v '^\./slosh\|^build/\|NAME')
  [ "$(echo "$names" | wc -l)" -ge 15 ] || fail "$document names too few files: $names"
  for name in $names; do
    found=
    for file in $name; do if [ -e "$file" ]; then found=yes; fi; done
    [ -n "$found" ] || fail "$document names '$name', which is not there"
  done
done
exit $failed
