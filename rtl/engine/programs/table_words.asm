# SPDX-License-Identifier: Apache-2.0
# The words of a segment that are of its core's table, behind those of its axes: hls/word_entry.hpp.
# Of cores that have a table.

word entry_axis segment_select           # segment_words.asm
local entry_link entry_fault entering kind

no_kind:                                   # a table's is -1: any theta, no lambda
  kind = entering * 2^7
  kind = floor(kind * 2^2 >> 45)
  test kind + 1
  if zero go to next_axis
  go to bad_word

axes_end:
  entry_axis = 0 - further_words, 1 limb
  if zero go to segment_whole
further:
  segment_select = 38, 1 limb              # 4 less than of tag 10
  call next_segment
further_word:
  if not port check_holds go to bad_word
  call coefficient
  entry_axis = entry_axis + 1, 1 limb
  if not zero go to further
  go to segment_whole
