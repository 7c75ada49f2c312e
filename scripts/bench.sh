#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The benchmarks, one run: prints a table and writes build/bench.json.  Options go to the benchmark
# (--benchmark_filter=REGEX ...).
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
PATH=$PWD/.venv/bin:$PATH
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target kernel_bench
build/release/tb/bench/kernel_bench --benchmark_out=build/bench.json \
  --benchmark_out_format=json "$@"
