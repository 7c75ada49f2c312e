#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# yosys.sh YOSYS FILE SOURCE... : FILE's module as its own top, every net driven once and from
# somewhere.
set -eu
yosys=$1
file=$2
module=$(basename "$file" .sv)
shift 2
sources=$("$(dirname "$0")/../support/needed_sources.sh" "$file" "$@")
"$yosys" -q -w "Replacing memory" -p "read_verilog -sv -defer $(echo $sources)
  read_verilog -lib +/ecp5/cells_bb.v +/ice40/cells_sim.v
  hierarchy -check -top $module; proc; flatten; opt_clean; check -assert"
