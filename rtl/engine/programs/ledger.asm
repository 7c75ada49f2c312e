# SPDX-License-Identifier: Apache-2.0
# The ledger of both streams, and the guard of time: hls/word_ledger.hpp.
#
#   segment_entered   a whole segment is in its queue, a whole piece: words.asm
#   piece_entered
#   guard             once a tick, before its rate is made: `underrun_hold`; with no program under
#                     way `may_begin`

word path_lead = 0, 4 limbs                # of the segments over the pieces
word ticks_lead = 0, 4 limbs
word underrun_hold = 0, 1 limb
word may_begin = 0, 1 limb
word ends_lead                             # 1: the segments' program has ended, -1: the pieces'
word segment_inside piece_inside piece_ticks word_faults               # words.asm
word segment_words profile_words
word queued_ticks finals active end time final                         # path.asm
word stop_ticks twice_stop                                             # settings.asm

local covered back keeps programs over rest

guard:
  back = port link, 1 limb
  keeps = 0, 1 limb                        # streams that do not last, + 4 of those not for a stop
  programs = finals, 1 limb                # whole ones: final pieces that have not ended
  covered = queued_ticks + 0, 4 limbs      # by pieces
  test active + 0, 1 limb
  if zero go to without_present
  programs = programs + final, 1 limb
  rest = end - time
  rest = floor(rest * 2^29 >> 45)
  covered = covered + rest
without_present:
  test word_faults - 16, 1 limb
  if negative go to ends_known
  programs = 0, 1 limb
ends_known:
  over = profile_words - profile_full, 2 limbs
  call cover
  covered = covered + ticks_lead, 4 limbs  # by segments
  programs = programs + ends_lead, 1 limb
  over = segment_words - segments_full, 2 limbs
  call cover
  port link = back, 1 limb
  may_begin = 0, 1 limb
  test keeps + 0, 1 limb
  if not zero go to not_ample
  may_begin = 1, 1 limb
no_hold:
  underrun_hold = 0, 1 limb
  return
not_ample:
  test active + 0, 1 limb
  if zero go to no_hold
  test keeps - 4, 1 limb
  if negative return
  underrun_hold = 1, 1 limb
  port report_underrun = 0, 1 limb
  return

cover:                                     # one stream, full if `over` is 0 or more
  test 0 - programs, 1 limb
  if negative return
  test twice_stop - covered, 4 limbs
  if negative return
  test stop_ticks - covered, 4 limbs
  if not negative go to low
  test over + 0, 2 limbs
  if not negative return
  keeps = keeps + 1, 1 limb
  return
low:
  keeps = keeps + 2^2, 1 limb
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
