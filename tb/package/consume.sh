#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# consume.sh BUILD CXX PROGRAM : installs BUILD's libraries, builds consumer/ with nothing else of
# this tree, and plans PROGRAM with it.
set -eu
build=$1
cxx=$2
program=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$build" --component libraries --prefix "$folder/prefix" >/dev/null
cp -r "$(dirname "$0")/consumer" "$folder"
cmake -G Ninja -S "$folder/consumer" -B "$folder/build" -DCMAKE_CXX_COMPILER="$cxx" \
  -DCMAKE_PREFIX_PATH="$folder/prefix" >/dev/null
cmake --build "$folder/build"
"$folder/build/plan" "$program"
