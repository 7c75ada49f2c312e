#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# yosys.sh YOSYS MODULE SOURCE... : MODULE as its own top, every net driven once and from somewhere.
set -eu
yosys=$1
module=$2
shift 2
"$yosys" -q -w "Replacing memory" -p "read_verilog -sv -defer $*
  read_verilog -lib +/ecp5/cells_bb.v +/ice40/cells_sim.v
  hierarchy -check -top $module; proc; flatten; opt_clean; check -assert"
