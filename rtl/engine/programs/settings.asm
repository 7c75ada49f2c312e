# SPDX-License-Identifier: Apache-2.0
# Settings of the motion: hls/motion_settings.hpp. Lines: rtl/engine/assembler/source.hpp.
#
#   settings    before a tick, with no sample missing of the one before: takes what the ports ask
#               for while no program is under way, and time begins anew
#
# `good`: time may run, otherwise the target is 0. Bad ones are reported to the board.

word samples_per_tick = 16, 1 limb         # n, 0 .. 15; 16: none are taken
word hold_acceleration hold_slope
word stop_ticks
word good
word active next pieces                    # path.asm, words.asm

local new_samples new_acceleration new_slope new_stop

settings:
  new_samples = port samples_per_tick_in, 1 limb
  new_acceleration = port acceleration_in
  new_slope = port slope_in
  new_stop = port stop_ticks_in
  test new_samples - samples_per_tick, 1 limb
  if not zero go to settings_differ
  test new_acceleration - hold_acceleration
  if not zero go to settings_differ
  test new_slope - hold_slope
  if not zero go to settings_differ
  test new_stop - stop_ticks
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
  samples_per_tick = new_samples, 1 limb
  hold_acceleration = new_acceleration
  hold_slope = new_slope
  stop_ticks = new_stop
  good = 0, 1 limb
  test new_slope - new_acceleration
  if negative go to time_begins
  test new_acceleration - 8
  if negative go to time_begins
  new_acceleration = new_acceleration - 1
  test new_acceleration - 2147483648       # 2^31
  if not negative go to time_begins
  new_slope = new_slope - 1
  test new_slope - 4294967296              # 2^32
  if not negative go to time_begins
  test 0 - new_stop
  if not negative go to time_begins
  test new_stop - 2^29
  if not negative go to time_begins
  good = 1, 1 limb
  go to time_begins
