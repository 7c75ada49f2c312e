# SPDX-License-Identifier: Apache-2.0
# Settings of the motion: hls/motion_settings.hpp. Lines: rtl/engine/assembler/source.hpp.
#
#   settings        before a tick, with no sample missing of the one before: negative if others are
#                   asked for, while no program is under way
#   take_settings   takes them, and time begins anew
#
# `good`: time may run, otherwise the target is 0. Bad ones are reported to the board.

word samples_per_tick = 16, 1 limb         # n, 0 .. 15; 16: none are taken
word hold_acceleration hold_slope
word stop_ticks twice_stop
word good
word active next pieces                    # path.asm, words.asm

local asked less

settings:
  asked = port samples_per_tick_in, 1 limb
  test asked - samples_per_tick, 1 limb
  if not zero go to settings_differ
  asked = port acceleration_in
  test asked - hold_acceleration
  if not zero go to settings_differ
  asked = port slope_in
  test asked - hold_slope
  if not zero go to settings_differ
  asked = port stop_ticks_in
  test asked - stop_ticks
  if not zero go to settings_differ
  test good + active, 1 limb
  if not zero return
  test next + pieces, 2 limbs
  if zero return
settings_bad:
  port report_settings = 0, 1 limb
  return
settings_differ:
  test active + 0, 1 limb
  if not zero go to settings_bad
  test 0 - 1, 1 limb
  return

take_settings:
  samples_per_tick = port samples_per_tick_in, 1 limb
  hold_acceleration = port acceleration_in
  hold_slope = port slope_in
  stop_ticks = port stop_ticks_in
  twice_stop = stop_ticks + stop_ticks
  good = 0, 1 limb
  test hold_slope - hold_acceleration
  if negative go to time_begins
  test hold_acceleration - 8
  if negative go to time_begins
  less = hold_acceleration - 1
  test less - 2147483648                   # 2^31
  if not negative go to time_begins
  less = hold_slope - 1
  test less - 4294967296                   # 2^32
  if not negative go to time_begins
  test 0 - stop_ticks
  if not negative go to time_begins
  test stop_ticks - 2^29
  if not negative go to time_begins
  good = 1, 1 limb
  go to time_begins
