#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# long_tests.sh BUILD LIST : each test of the list is one that BUILD has, with the label long.
set -eu
known=$(mktemp)
trap 'rm -f "$known"' EXIT
ctest --test-dir "$1" -N -L '^long$' | sed -nE 's/^ *Test +#[0-9]+: //p' >"$known"
gone=$(sed -nE 's/^([a-z]+\.[^ ]+).*/\1/p' "$2" | grep -vxFf "$known") || true
[ -z "$gone" ] || { echo "$2 names tests that are not there:"; echo "$gone"; exit 1; }
