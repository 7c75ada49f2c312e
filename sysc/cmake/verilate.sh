#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# verilate.sh DIR PREFIX FLAG... : verilates into DIR, compiles DIR/PREFIX__ALL.a and writes
# DIR/model.d, the sources on which it depends.  Environment: VERILATOR CXX CFLAGS CCACHE.
# Above -O1 models take half as long again to compile and run no faster.
set -eu
dir=$1
prefix=$2
shift 2
mkdir -p "$dir"
"$VERILATOR" --cc --Mdir "$dir" --assert -O3 --x-assign unique --x-initial unique "$@"
rm -f "$dir/${prefix}__ALL.a"
make -s -C "$dir" -f "$prefix.mk" "${prefix}__ALL.a" \
  CXX="$CXX" OBJCACHE="${CCACHE:-}" OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O1 \
  USER_CPPFLAGS="$CFLAGS" >/dev/null
sed "s|^[^:]*:|$dir/${prefix}__ALL.a:|" "$dir/${prefix}__ver.d" >"$dir/model.d"
