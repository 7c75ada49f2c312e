# SPDX-License-Identifier: Apache-2.0
# Entry of words into the queues: hls/word_entry.hpp. Lines: rtl/engine/assembler/source.hpp.
#
#   enter_segment_word   the word that waits at a stream is judged: it passes into its queue, or it
#   enter_piece_word     cuts both streams and is dropped, and so are all that follow. It stays
#                        where it is while its queue is full, or its program waits (ledger.asm)
#
# What is valid is said by segment_words.asm and piece_words.asm, each in the order of its words:
# `call next_segment` lets one pass and finds itself back with the next as `entering`, which has the
# selected tag. A select is 4 tag, + 2: bits 43:36 are left out of the check, + 1: of the profile.
# An entering word is signed and has the low half of its tag in bits 45:44. Products modulo 2^45
# drop it; in what floor() gives of the word it stays, and is taken off. The queue has the word as it
# passes on, of a ds and coefficients the number alone. Numbers here are sums of powers of two where
# a word of data would be needed else.

word segment_next = place of length_word, 1 limb
word segment_select = 4, 1 limb
word segment_check = 0, 1 limb
word segment_put = segment_begin, 2 limbs
word segment_words = 0, 2 limbs
word piece_next = place of piece_word, 1 limb
word piece_select = 35, 1 limb
word piece_check = 0, 1 limb
word piece_put = profile_begin, 2 limbs
word profile_words = 0, 2 limbs
word word_faults = 0, 1 limb               # faults 0 to 4 of rtl/motion_interpolator.sv
word ends_lead = 0, 1 limb                 # ledger.asm: 1 segments wait, -1 pieces
word piece_inside
local entry_link entry_fault entering      # of all three sources
local left digest

enter_segment_word:
  entry_link = port link, 1 limb
  entry_fault = 1, 1 limb
  port select = segment_select, 1 limb
  test segment_words - segment_queue_words, 2 limbs
  if not negative go to word_stays
  if not port tag_is go to bad_word
  port check = segment_check, 1 limb
  entering = port word_in
  port link = segment_next, 1 limb
  return

next_segment:
  segment_next = port link, 1 limb
  segment_check = port check_in, 1 limb
  segment_select = segment_select + 4, 1 limb
  segment_words = segment_words + 1, 2 limbs
  port address = segment_put, 2 limbs
  port memory = entering
  segment_put = segment_put + 3, 2 limbs
  test segment_put - segment_end, 2 limbs
  if negative go to word_taken
  segment_put = segment_begin, 2 limbs
  go to word_taken

enter_piece_word:
  entry_link = port link, 1 limb
  entry_fault = 4, 1 limb
  port select = piece_select, 1 limb
  test profile_words - profile_queue_words, 2 limbs
  if not negative go to word_stays
  if not port tag_is go to stop_here
selected:
  port check = piece_check, 1 limb
  entering = port word_in
  port link = piece_next, 1 limb
  return
stop_here:                                 # a branch may stand before a piece, 35 or 53
  left = piece_select - 32, 1 limb
  test left - 3, 1 limb
  if not zero go to bad_word
  piece_select = piece_select + 16, 1 limb
  piece_select = piece_select + 2, 1 limb
  port select = piece_select, 1 limb       # tag_is: six clocks later
  test piece_inside - 1, 1 limb
  if zero go to bad_word
  if port tag_is go to selected
  go to bad_word

next_piece:
  piece_next = port link, 1 limb
  piece_check = port check_in, 1 limb
  piece_select = piece_select + 4, 1 limb
  profile_words = profile_words + 1, 2 limbs
  port address = piece_put, 2 limbs
  port memory = entering
  piece_put = piece_put + 3, 2 limbs
  go to word_taken

word_stays:
  test word_faults + 0, 1 limb
  if zero go to word_waits
strange_word:                              # valid, but not of this place
  entry_fault = entry_fault + entry_fault, 1 limb
bad_word:
  test word_faults + 0, 1 limb
  if not zero go to word_taken
  word_faults = entry_fault, 1 limb
  port report_words = word_faults, 1 limb
  call both_go_on
word_taken:                                # here, and nowhere else
  port take = 0, 1 limb
word_waits:
  port link = entry_link, 1 limb
  return
program_begins:
  test word_faults + 0, 1 limb             # the programs before were apart
  if not zero go to word_taken
  digest = port digest_in, 1 limb
  port check = digest, 1 limb
  return
both_go_on:
  segment_next = port link, 1 limb
  piece_next = port link, 1 limb
  return
