#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The long form of the tests of buses: accesses by others' masters with random pauses on each bus,
# a tenth of them on lines, whose bits take many clocks; then random datagrams and random writes of
# registers to a virtual board, twice as many as accesses.
#
#   scripts/buses.sh [ACCESSES]      on each bus, default 20000; logs in build/campaign
set -euo pipefail
accesses=${1:-20000}
case $accesses in
  -h | --help)
    sed -n '3,8s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  "" | *[!0-9]* | 0*)
    echo "buses: '$accesses' is no number of accesses: digits only, such as 20000" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" -- curvecore made_registers
# The slowest first.
printf '%s\n' spi_line uart spi axi_lite axi_stream wishbone | xargs -P "$(nproc)" -I BUS sh -c '
  folder=$PWD/build/campaign/BUS
  mkdir -p "$folder"
  accesses=$0
  case BUS in spi_line | uart) accesses=$(((accesses + 9) / 10)) ;; esac
  python tb/bus/run_bus.py BUS "$accesses" "$PWD/build/release/tb/bus/registers/registers.json" \
    "$folder" >"$folder.log" 2>&1 || {
    echo "FAILED: $folder.log"
    exit 1
  }
  echo "BUS: $(grep -o "[0-9]* [aw].* as described" "$folder.log")"' "$accesses"
CURVECORE_DATAGRAMS=$((2 * accesses)) python tb/wire/master_test.py build/curvecore \
  MasterTest.test_random_writes_give_no_step
