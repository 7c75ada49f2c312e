# SPDX-License-Identifier: Apache-2.0
# The ledger of both streams, and the guard of time: hls/word_ledger.hpp.
#
#   segment_entered   a whole segment is in its queue, a whole piece: words.asm
#   piece_entered
#   guard             once a tick, before its rate is made: `underrun_hold`, `may_begin`

word path_lead = 0, 4 limbs                # of the segments over the pieces
word ticks_lead = 0, 4 limbs
word underrun_hold = 0, 1 limb
word may_begin = 0, 1 limb
word ends_lead                             # 1: the segments' program has ended, -1: the pieces'
word segment_inside piece_inside piece_ticks word_faults               # words.asm
word segment_words profile_words
word queued_ticks finals active end time final                         # path.asm
word stop_ticks                                                        # settings

local covered back waits present rest programs over low all_covered runs_low twice

guard:
  back = port link, 1 limb
  waits = finals, 1 limb                   # final pieces that have not begun, and that has
  present = 0, 1 limb
  covered = 0, 4 limbs
  test active + 0, 1 limb
  if zero go to without_present
  present = final, 1 limb
  covered = end - time
  covered = floor(covered * 2^29 >> 45)
without_present:
  test word_faults - 16, 1 limb
  if negative go to ends_known
  waits = 0, 1 limb
  present = 0, 1 limb
ends_known:
  covered = covered + queued_ticks         # by pieces
  may_begin = 1, 1 limb
  all_covered = 1, 1 limb
  runs_low = 0, 1 limb
  programs = waits, 1 limb
  over = profile_words - profile_queue_words, 2 limbs
  over = over + 4, 2 limbs
  call cover
  covered = covered + ticks_lead, 4 limbs  # by segments
  programs = waits + ends_lead, 1 limb
  over = segment_words - segment_queue_words, 2 limbs
  over = over + frame_words, 2 limbs
  over = over - 1, 2 limbs
  call cover
  port link = back, 1 limb
  test active + 0, 1 limb
  if zero go to no_hold
  test all_covered + 0, 1 limb
  if not zero go to no_hold
  test runs_low + 0, 1 limb
  if zero return
  underrun_hold = 1, 1 limb
  port report_underrun = 0, 1 limb
  return
no_hold:
  underrun_hold = 0, 1 limb
  return

cover:                                     # one stream, full if `over` is 0 or more
  low = 1, 1 limb
  test stop_ticks - covered, 4 limbs
  if not negative go to little
  low = 0, 1 limb
  test over + 0, 2 limbs
  if not negative return
  twice = stop_ticks + stop_ticks, 4 limbs
  test twice - covered, 4 limbs
  if negative return
little:
  rest = 0 - programs, 1 limb
  if negative go to begins_covered
  may_begin = 0, 1 limb
begins_covered:
  test rest - present, 1 limb
  if negative return
  all_covered = 0, 1 limb
  test low + 0, 1 limb
  if zero return
  runs_low = 1, 1 limb
  test over + 0, 2 limbs
  if negative return
  port report_short = 0, 1 limb
  return

segment_entered:
  test segment_inside + 0, 1 limb
  if not zero return
  ends_lead = ends_lead + 1, 1 limb
  go to ends_there
piece_entered:
  ticks_lead = ticks_lead - piece_ticks, 4 limbs
  queued_ticks = queued_ticks + piece_ticks
  test piece_inside + 0, 1 limb
  if not zero return
  finals = finals + 1, 2 limbs
  ends_lead = ends_lead - 1, 1 limb
ends_there:
  if not zero return
  test ticks_lead + 0, 4 limbs
  if not zero go to apart
  test path_lead + 0, 4 limbs
  if zero return
apart:                                     # all words from now on are dropped: program_begins
  word_faults = 16, 1 limb
  port report_words = word_faults, 1 limb
  return
