#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# test_names.sh BUILD : each test of a parameter is named by its value in words, not by a number or
# by the parameter's bytes, in all test programs that were built in BUILD.
set -eu
unnamed='^add_test\(.*(GetParam|TypeParam|/[0-9]+\]=*\])'
found=$(find "$1" -name '*_tests.cmake' -exec grep -hE "$unnamed" {} + | cut -c 1-120) || true
[ -z "$found" ] || { echo "$found" | head -n 20; exit 1; }
