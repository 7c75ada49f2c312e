#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the files of a release into build/release_files/vX.Y.Z, with notes.md, the section of
# CHANGELOG.md, and SHA256SUMS. What was made of the same commit stays, so that a release that was
# stopped goes on. Nothing is tagged or pushed: the last lines say what to type.
#
#   scripts/release.sh [--without PART[,PART ..]]     two hours or so, minutes without bitstreams
#
#   verilog       each core as one file of Verilog-2005, and its component for VHDL
#   bitstreams    of every board of scripts/boards, placed at its clock
#   wheel         the Python package and its sources
#   site          the pages with the demo, one archive
#
# The tree must be a commit without changes, whose CHANGELOG.md has the section of its version
# (scripts/version.py X.Y.Z begins it) and nothing above it.
set -euo pipefail
cd "$(dirname "$0")/.."
mapfile -t known < <(sed -nE 's/^#   ([a-z]+)    +[a-z].*/\1/p' "$0")
refuse() {
  echo "release: $*" >&2
  exit 2
}
without=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help)
      sed -n '3,15s/^# \{0,1\}//p' "$0"
      exit 0
      ;;
    --without)
      [ -n "${2:-}" ] || refuse "--without needs parts: ${known[*]}"
      without+=" ${2//,/ }"
      shift
      ;;
    *) refuse "'$1' is not known: --without PART[,PART ..]" ;;
  esac
  shift
done
for part in $without; do
  [[ " ${known[*]} " = *" $part "* ]] || refuse "'$part' is no part: one of ${known[*]}"
done

section() {  # lines of CHANGELOG.md under a heading
  awk -v head="## [$1]" 'index($0, "## [") == 1 {here = index($0, head) == 1; next} here' \
    CHANGELOG.md
}
check_tree() {
  local changed
  changed=$(git status --porcelain) || refuse "$PWD is no clone: a release is made of a commit"
  [ -z "$changed" ] || refuse "the tree has changes that are in no commit: commit them, or put" \
    "them aside (git stash)"$'\n'"$changed"
}
check_tree
commit=$(git rev-parse HEAD)
version=$(scripts/version.py) || refuse "the version is not the same everywhere: set it in those"
[ -z "$(section Unreleased)" ] || refuse "CHANGELOG.md: what stands under [Unreleased] is not in" \
  "$version: scripts/version.py X.Y.Z makes a section of it"
[ -n "$(section "$version")" ] || refuse "CHANGELOG.md: the section of $version says nothing"
tag=v$version
tagged=$(git rev-parse -q --verify "refs/tags/$tag^{commit}") || tagged=$commit
[ "$tagged" = "$commit" ] || refuse "$tag is another commit, ${tagged::12}: a release has" \
  "a version of its own"

to=build/release_files/$tag
[ "$(cat "$to/.commit" 2>/dev/null)" = "$commit" ] || rm -rf "$to"
mkdir -p "$to"
echo "$commit" >"$to/.commit"
rm -rf "$to/SHA256SUMS" "$to/.making"

# make FOLDER COMMAND ..: what the command puts into .making becomes $to/FOLDER, whole or not.
make() {
  local made=$to/$1
  shift
  [ -e "$made" ] && return
  echo "release: $made"
  rm -rf "$to/.making"
  mkdir -p "$to/.making" "$(dirname "$made")"
  "$@" || {
    echo "release: $made cannot be made; what is finished stays, the same command goes on" >&2
    exit 1
  }
  mv "$to/.making" "$made"
}

flat() { scripts/flat.sh "$1" -o "$to/.making/$1.v" --vhdl >/dev/null; }

bitstream() {
  scripts/synth.sh --board "$1" || return
  local file there=
  for file in build/synth/boards/"$1"/board.{json,bit,bin,fs}; do
    [ -e "$file" ] || continue
    cp "$file" "$to/.making/$1.${file##*.}" || return
    [ "${file##*.}" = json ] || there=1
  done
  [ "$there" ]  # a bitstream, in one of its formats
}

wheel() { scripts/wheel.sh && cp build/wheel/*.whl build/wheel/*.tar.gz "$to/.making"; }

site() {
  scripts/site.sh && tar -C build/site/html --sort=name --mtime=@0 --owner=0 --group=0 \
    --numeric-owner -czf "$to/.making/site.tar.gz" .
}

for part in "${known[@]}"; do
  [[ " $without " != *" $part "* ]] || continue
  case $part in
    verilog)
      for core in $(grep -v / rtl/curvecore.f | grep -v "_pkg\.sv$"); do
        make "verilog/${core%.sv}" flat "${core%.sv}"
      done
      ;;
    bitstreams)
      for board in scripts/boards/*.json; do
        make "boards/$(basename "$board" .json)" bitstream "$(basename "$board" .json)"
      done
      ;;
    *) make "$part" "$part" ;;
  esac
done
section "$version" >"$to/notes.md"
check_tree
[ "$(git rev-parse HEAD)" = "$commit" ] || refuse "the commit is not $commit any more"
sums=$(cd "$to" && find . -type f ! -name ".*" -printf "%P\n" | LC_ALL=C sort |
  xargs -d "\n" sha256sum)
echo "$sums" >"$to/SHA256SUMS"
echo "release: $tag of ${commit::12}: $to, $(wc -l <<<"$sums") files${without:+, without$without}"
echo "to publish it, with those files:"
echo "  git tag -a --cleanup=whitespace -F $to/notes.md $tag $commit && git push origin $tag"
