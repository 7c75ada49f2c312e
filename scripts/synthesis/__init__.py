# SPDX-License-Identifier: Apache-2.0
"""Place and route: devices, cores, netlist, placement, sweep.  scripts/synth.sh uses it."""
