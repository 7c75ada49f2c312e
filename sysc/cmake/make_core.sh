#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# make_core.sh TREE DIR NAME=VALUE... : verilates TREE's motion_interpolator with these parameters
# and compiles it to DIR/core.so, which `curvecore run` opens.  Environment: VERILATOR CXX
# CCACHE, as for verilate.sh.
set -eu
tree=$1
dir=$2
shift 2
parameters=
definitions=
for parameter; do
  parameters="$parameters -G$parameter"
  definitions="$definitions -DCFG_$parameter"
done
search=$(find "$tree/rtl" -type d -printf '-y %p ')
packages=$(find "$tree/rtl" -name '*_pkg.sv' | sort)
CFLAGS="-fPIC"
export CFLAGS
# Waveforms stop above the multipliers.
"$tree/sysc/cmake/verilate.sh" "$dir" Vcore --top-module motion_interpolator --prefix Vcore \
  $parameters $search --trace-fst --trace-depth 5 $packages "$tree/rtl/motion_interpolator.sv"
include=$("$VERILATOR" --getenv VERILATOR_ROOT)/include
${CCACHE:-} $CXX $CFLAGS -std=c++17 -w -O2 -c -o "$dir/core.o" $definitions \
  -DCFG_FUNCTION=curvecore_core \
  -DCFG_MODEL=Vcore -DCFG_HEADER='"Vcore.h"' -DVM_TRACE=1 -DVM_TRACE_FST=1 \
  -I "$tree" -I "$dir" -isystem "$include" -isystem "$include/vltstd" \
  "$tree/sysc/cores/compiled_core.cpp"
# The core's own symbols come first; Verilator's library is the program's.
$CXX $CFLAGS -shared -Wl,-Bsymbolic -o "$dir/core.so" "$dir/core.o" "$dir/Vcore__ALL.a"
