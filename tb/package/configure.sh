#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# configure.sh SOURCE "HIDDEN;..." OPTION... : configures SOURCE afresh without what is hidden.
set -eu
source=$1
hidden=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake -G Ninja -S "$source" -B "$folder" -DHIDDEN="$hidden" \
  -DCMAKE_PROJECT_TOP_LEVEL_INCLUDES="$source/tb/package/hidden.cmake" "$@" 2>&1
