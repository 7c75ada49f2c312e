#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# yosys.sh YOSYS FILE SOURCE... : FILE's module as its own top, every net driven once and from
# somewhere; Build 2, which has no programs here, is linted in engine_motion.
set -eu
yosys=$1
file=$2
module=$(basename "$file" .sv)
shift 2
sources=$("$(dirname "$0")/../support/needed_sources.sh" "$file" "$@")
parallel=
if grep -q "parameter int Build  *= 2," "$file" && grep -q "parameter  *Program " "$file"; then
  parallel="chparam -set Build 0 $module;"
fi
"$yosys" -q -w "Replacing memory" -p "read_verilog -sv -defer $(echo $sources)
  read_verilog -lib +/ecp5/cells_bb.v +/ice40/cells_sim.v
  $parallel hierarchy -check -top $module; proc; flatten; opt_clean; check -assert"
