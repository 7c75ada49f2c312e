# SPDX-License-Identifier: Apache-2.0
# A motion: words in, samples out; what waits, one after the other. sysc/board/kernel_board.cpp
# composes the kernels in the same way.
#
#   motion   the background, from a reset on
#   sample   a sample from its request on: a tick of time where one is due, its share, a position

word target rate active next underrun_hold good standing share_index
word pieces
word waits = 0, 1 limb         # the sample under way waits for a segment

foreground:                    # it has nothing to do
  end, then foreground

motion:
  test waits + 0, 1 limb
  if not zero go to draw
  test share_index + 0
  if not zero go to asked
  test next + 0, 1 limb
  if not zero go to asked
  test pieces + 0, 2 limbs
  if not zero go to words      # first the next piece, with its branch
asked:
  if port request go to sample
words:
  if port segment_waits call enter_segment_word
  if port piece_waits call enter_piece_word
  call fetch_piece
  if port segment_waits go to motion
  if port piece_waits go to motion
  test share_index + 0
  if not zero go to motion     # the settings are those of a whole tick
  call settings
  go to motion

report_begun:
  port path_active = active, 1 limb
  return

sample:
  port take_request = 0, 1 limb
  test share_index + 0
  if not zero go to shares_on
  call settings
  call guard
  target = 0
  if port killed go to aimed
  if port held_now go to aimed
  test underrun_hold + 0, 1 limb
  if not zero go to aimed
  test good + 0, 1 limb
  if zero go to aimed
  target = port override_in, 2 limbs
  test target - one              # the rate 1: rate.asm
  if negative go to aimed
  target = one
aimed:
  call rate_tick
  port path_active = active, 1 limb
  call tick
  port now_active = active, 1 limb
  port now_standing = standing, 1 limb
  test active + 0, 1 limb
  if not zero call report_begun
shares_on:
  call share
  port path_rate = rate, 2 limbs
draw:
  call follow
  test waits + 0, 1 limb
  if not zero go to words
  call put_sample
  port sample_whole = 0, 1 limb
  go to words
