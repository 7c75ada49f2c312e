#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# make_core.sh TREE DIR TOP SOURCE NAME=VALUE... : verilates TREE's TOP, motion_interpolator or
# motion_board, with these parameters and compiles it with SOURCE to DIR/core.so, which curvecore
# opens.  Environment: VERILATOR CXX CCACHE, as for verilate.sh; MICROCODE, the folder in which an
# engine finds its programs; RTL, the folder of the modules, or DUT, flags and files for Verilator
# of a design of others, which has TOP.
set -eu
tree=$1
dir=$2
top=$3
source=$4
shift 4
parameters=
definitions=
for parameter; do
  parameters="$parameters -G$parameter"
  definitions="$definitions -DCFG_$parameter"
done
set --
if [ -n "$DUT" ]; then
  set -- $DUT
else
  case " $parameters " in
    *" -GBuild=2 "*)
      set -- "-GProgram=\"$MICROCODE/program.hex\"" "-GData=\"$MICROCODE/data.hex\""
      ;;
  esac
  search=$(find "$RTL" -type d -printf '-y %p ')
  packages=$(find "$RTL" -name '*_pkg.sv' | sort)
  set -- "$@" --top-module "$top" $parameters $search $packages "$RTL/$top.sv"
fi
CFLAGS="-fPIC"
export CFLAGS
# Waveforms stop above the multipliers; boards have none, and are made in half of the time.
[ "$top" = motion_board ] || set -- "$@" --trace-fst --trace-depth 6
"$tree/sysc/cmake/verilate.sh" "$dir" Vcore --prefix Vcore "$@"
include=$("$VERILATOR" --getenv VERILATOR_ROOT)/include
${CCACHE:-} $CXX $CFLAGS -std=c++17 -w -O2 -c -o "$dir/core.o" $definitions \
  -DCFG_FUNCTION=curvecore_model \
  -DCFG_MODEL=Vcore -DCFG_HEADER='"Vcore.h"' -DVM_TRACE=1 -DVM_TRACE_FST=1 \
  -I "$tree" -I "$dir" -isystem "$include" -isystem "$include/vltstd" \
  "$tree/$source"
# The core's own symbols come first; Verilator's library is the program's.
$CXX $CFLAGS -shared -Wl,-Bsymbolic -o "$dir/core.so" "$dir/core.o" "$dir/Vcore__ALL.a"
