#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# verilate.sh DIR PREFIX FLAG... : verilates into DIR, compiles DIR/PREFIX__ALL.a and writes
# DIR/model.d, the sources on which it depends.  Environment: VERILATOR CXX, and CCACHE CFLAGS.
# Above -O1 models take half as long again to compile and run no faster; more files do not help,
# since reading verilated.h is most of a file's compilation. verilated_model.cmake compiles that
# header with exactly these options; with others GCC silently reads its text again.
set -eu
dir=$1
prefix=$2
shift 2
mkdir -p "$dir"
"$VERILATOR" --cc --Mdir "$dir" --assert -O3 --x-assign unique --x-initial unique "$@"
rm -f "$dir/${prefix}__ALL.a"
make -s -C "$dir" -f "$prefix.mk" "${prefix}__ALL.a" \
  CXX="$CXX" OBJCACHE="${CCACHE:-}" VM_PARALLEL_BUILDS=0 OPT_FAST=-O1 \
  USER_CPPFLAGS="-std=c++17 -w ${CFLAGS:-}" >/dev/null
sed "s|^[^:]*:|$dir/${prefix}__ALL.a:|" "$dir/${prefix}__ver.d" >"$dir/model.d"
