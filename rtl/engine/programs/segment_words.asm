# SPDX-License-Identifier: Apache-2.0
# A segment, word by word: hls::SegmentEntry, hls/word_entry.hpp. `call next_segment`: words.asm.
#
# Signed bits are sign-extended where rounding away one more than the word has leaves 0.

word segments = 0, 2 limbs                 # whole ones in the queue
word segment_inside = 0, 1 limb            # 0: the next segment is its program's first
word segment_number = 0, 1 limb            # of the next one, modulo 2^8
word joins = 0, 1 limb                     # a start is the end before: not of the first segment
word entry_axis                            # less 3
word entry_limit                           # 0 or, of a spline, k + 32; then of auxiliary axes: joins
word ticks_bytes
word segment_select segment_put ends_lead path_lead ticks_lead
local entry_link entry_fault entering
local t byte high kind least place before lambda

segment_whole:
  joins = 1, 1 limb
  segment_number = segment_number + 1, 1 limb
  segments = segments + 1, 2 limbs
  t = floor(ticks_bytes * 2^34 >> 45), 4 limbs
  t = t + 2^1, 4 limbs                     # less tags, -512 and 256 of a byte's, and X's bytes, -2
  t = t - 2^8, 4 limbs
  t = t + 2^17, 4 limbs
  t = t - 2^24, 4 limbs
  t = t + 2^33, 4 limbs
  ticks_lead = ticks_lead + t, 4 limbs
  call segment_entered
  segment_select = 0, 1 limb
  call next_segment

length_word:
  test 0 - ends_lead, 1 limb
  if negative go to word_stays
  test segment_inside + 0, 1 limb
  if zero call program_begins
  t = entering * 2^0, 4 limbs
  t = t - 2^44, 4 limbs
  path_lead = path_lead + t, 4 limbs
  entry_axis = 0 - 3, 1 limb
  call next_segment

theta_word:
  call coefficient
  high = floor(entering * 2^2 >> 45), 1 limb       # -4, of a program's last -3
  segment_inside = high + 3, 1 limb
  high = high * 2^5, 1 limb
  entry_limit = floor(entering * 2^7 >> 45), 1 limb
  entry_limit = entry_limit - high, 1 limb
  high = entry_limit + 4, 1 limb           # k is 27 at most
  test high - 32, 1 limb
  if not negative go to bad_word
  kind = entering * 2^7
  kind = floor(kind * 2^2 >> 45)           # 0 and 1, or -2 and -1: of their last limb,
  test kind - kinds, 1 limb                # 32766 and 32767
  if not negative go to no_kind            # bad_word, or table_words.asm
  entry_limit = entry_limit + 32, 1 limb
  entry_limit = entry_limit * kind, 1 limb
  least = kind * 2^least_phi
  test t - least
  if negative go to bad_word
next_axis:
  call next_segment

start_word:
  call point
  test joins + 0, 1 limb
  if zero go to starts
  place = segment_put + 3, 2 limbs         # of the end in the segment before
  place = place - frame_words, 2 limbs
  place = place - frame_words, 2 limbs
  place = place - frame_words, 2 limbs
  test place - segment_begin, 2 limbs
  if not negative go to end_there
  place = place + segment_end, 2 limbs
  place = place - segment_begin, 2 limbs
end_there:
  port address = place, 2 limbs
  before = port memory
  before = before * 2^1
  test t - before
  if not zero go to strange_word
starts:
  call next_segment

end_word:
  call point
  test entry_axis + 0, 1 limb
  if not negative go to linear
  test entry_axis + 3, 1 limb
  if not zero go to y_or_z
  segment_select = segment_select + 2, 1 limb
  call next_segment

tangent_word:
  call coefficient_and_byte
  byte = byte - segment_number, 1 limb
  test byte * 2^7, 1 limb
  if not zero go to strange_word
  segment_select = segment_select - 2, 1 limb
  call next_segment

normal_word:
  call coefficient_and_byte
  high = floor(entering * 2^3 >> 45), 1 limb       # -8, with another turn -7
  lambda = high * 2^6, 1 limb
  lambda = byte - lambda, 1 limb
  place = entry_limit - 32, 1 limb
  if not negative go to of_spline
  test lambda + 0, 1 limb
  if not zero go to bad_word
of_spline:
  test lambda - place, 1 limb              # from k to 27
  if negative go to bad_word
  lambda = lambda + 4, 1 limb
  test lambda - 32, 1 limb
  if not negative go to bad_word
  entry_limit = 0 - high, 1 limb
  entry_limit = entry_limit - 8, 1 limb
  entry_limit = entry_limit + 1, 1 limb
  if negative go to bad_word
  go to advance

y_or_z:
  call next_segment
y_or_z_tangent_word:
  call coefficient_and_byte
  call next_segment
y_or_z_normal_word:
  call coefficient_and_byte
  go to advance
linear:
  segment_select = segment_select + 8, 1 limb
advance:
  segment_select = segment_select + 2, 1 limb
  call next_segment
advance_word:
  if not port check_holds go to bad_word
  call coefficient
  segment_select = 8, 1 limb
  entry_axis = entry_axis + 1, 1 limb
  if not zero go to axis_over
  joins = joins * entry_limit, 1 limb
axis_over:
  test entry_axis - aux_axes, 1 limb
  if negative go to next_axis
  go to axes_end                           # segment_whole, or table_words.asm

coefficient_and_byte:
  byte = floor(entering * 2^9 >> 45), 1 limb       # bits 43:36
  high = byte * 2^35
  ticks_bytes = high + (ticks_bytes * 2^37 >> 45)
coefficient:
  t = entering * 2^9
  test t * 2^coef_room >> 45
  go to in_range
point:
  t = entering * 2^1
  test t * 2^fine_room >> 45
in_range:
  if not zero go to bad_word
  return
