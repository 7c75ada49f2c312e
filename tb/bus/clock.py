# SPDX-License-Identifier: Apache-2.0
"""The clock of a bench. cocotb would toggle it in Python, which takes longer than the bench."""

from cocotb.clock import Clock


def start_clock(clk, period=10, unit="ns"):
    # Its first edge is half a period away: at time 0 masters would read what nothing drives yet.
    Clock(clk, period, unit, impl="gpi").start(start_high=False)
