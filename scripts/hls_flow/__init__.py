# SPDX-License-Identifier: Apache-2.0
"""Kernels of hls/ through clang and XLS to Verilog.  scripts/hls.sh uses it."""
