# SPDX-License-Identifier: Apache-2.0
# A motion: words in, samples out; what waits, one after the other, samples first, since words can
# wait. But where the motion stands, perhaps for want of words, or somebody takes samples as they
# come, they take turns. sysc/board/kernel_board.cpp composes the kernels in the same way.
#
#   motion   the background, from a reset on
#   sample   a sample from its request on: a tick of time where one is due, its share, a position

word target rate active next underrun_hold good standing share_index end time
word pieces
word waits = 0, 1 limb         # the sample under way waits for a segment
local left

foreground:                    # it has nothing to do
  end, then foreground

first_settings:
  call take_settings
motion:
  test waits + 0, 1 limb
  if not zero go to draw
  if not port request go to words
  test share_index + 0, 2 limbs
  if zero go to tick_is_due
  port take_request = 0, 1 limb
  go to shares_on
tick_is_due:
  test next + 0, 1 limb
  if not zero go to sample
  test pieces + 0, 2 limbs
  if zero go to sample
  test active + 0, 1 limb
  if zero go to fetch
  left = time - end
  test left + 2^16
  if negative go to sample     # the piece does not end in this tick
fetch:                         # first the next one, with its branch
  call fetch_piece
  go to tick_is_due

words:                         # one of each stream
  if port position_waits call put_position
  if port segment_waits call enter_segment_word
  if port piece_waits call enter_piece_word
  if port request go to motion
  if port segment_waits go to motion
  if port piece_waits go to motion
  test share_index + 0, 2 limbs
  if not zero go to motion     # the settings are those of a whole tick
  call settings
  if negative call take_settings
  go to motion

others:                        # between programs: the guard is that of the tick before
  call take_settings
  go to guarded

sample:
  port take_request = 0, 1 limb
  call settings
  if negative go to others
  call guard
guarded:
  target = 0, 2 limbs
  if port killed go to aimed
  if port held_now go to aimed
  test good - underrun_hold, 1 limb
  if negative go to aimed
  if zero go to aimed
  target = port override_in, 2 limbs
  test target - 2^16, 2 limbs    # the rate 1
  if negative go to aimed
  target = 0 + 2^16, 2 limbs
aimed:
  call rate_tick
  port path_active = active, 1 limb
  call tick
  port now_active = active, 1 limb
  port now_standing = standing, 1 limb
shares_on:
  call share
  port path_rate = rate, 2 limbs
draw:
  call follow
  test waits + 0, 1 limb
  if not zero go to words
  call put_sample
  port sample_whole = 0, 1 limb
  test standing + 0, 1 limb
  if not zero go to words
  test share_index + 0, 2 limbs
  if not zero go to sample_is_out
  call fetch_piece             # once a tick
sample_is_out:
  if port awaited go to words  # it has no pace to keep
  go to motion
