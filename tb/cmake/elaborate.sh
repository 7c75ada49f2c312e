#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# elaborate.sh IVERILOG VVP FLAG... : elaborates a module with Icarus and runs its time 0.
set -eu
iverilog=$1
vvp=$2
shift 2
image=$(mktemp)
trap 'rm -f "$image"' EXIT
"$iverilog" -g2012 -o "$image" "$@"
"$vvp" -n "$image"
