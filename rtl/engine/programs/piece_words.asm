# SPDX-License-Identifier: Apache-2.0
# A piece, and the stop branch before it, word by word: hls::PieceEntry, hls/word_entry.hpp.
# `call next_piece`: words.asm.

word pieces = 0, 2 limbs                   # whole ones in the queue, with their branches
word piece_inside = 0, 1 limb              # 0: the next frame is its program's first
word piece_number = 0, 1 limb              # of the next one, modulo 2^8
word most_again = 0, 2 limbs               # wait of a branch without steps; 0: none has come
word piece_ticks
word piece_select piece_put ends_lead path_lead
local entry_link entry_fault entering
local t high e m number power final
# Pieces, stops and steps begin in front of profile_end: pieces.asm.

piece_whole:
  piece_number = piece_number + 1, 1 limb
  pieces = pieces + 1, 2 limbs
  call piece_entered
next_frame:
  piece_select = piece_select - 16, 1 limb # 51: 31, 4 less than a piece's
  piece_select = piece_select - 4, 1 limb
  call next_piece

piece_word:
  test ends_lead + 0, 1 limb
  if negative go to word_stays
  test piece_inside + 0, 1 limb
  if zero call program_begins
  call put_before_end
  test piece_select * 2^13, 1 limb         # 53 of a stop, or 35
  if not negative go to stop_word
of_piece:
  t = entering * 2^9                       # bits 35:0
  high = floor(t * 2^4 >> 45), 1 limb
  if not zero go to bad_word
  final = floor(t * 2^5 >> 45), 1 limb
  high = floor(t * 2^11 >> 45), 1 limb     # final, e
  e = final * 2^6, 1 limb
  e = high - e, 1 limb
  e = e - 31, 1 limb                       # 46 at most
  test e - 16, 1 limb
  if not negative go to bad_word
  m = high * 2^5, 1 limb
  high = floor(t * 2^16 >> 45)             # final, e, m
  m = high - m, 1 limb
  e = m - 16, 1 limb                       # m is 19 at most
  test e - 4, 1 limb
  if not negative go to bad_word
  t = floor(t * 2^36 >> 45)
  high = high * 2^20
  piece_ticks = t - high
  if zero go to bad_word
  m = m * 2^2, 1 limb                      # powers.asm
  port address = m, 1 limb
  power = port memory, 2 limbs             # 2^m
  test power - piece_ticks, 2 limbs
  if negative go to bad_word
  number = floor(entering * 2^9 >> 45), 1 limb
  number = number - piece_number, 1 limb
  test number * 2^7, 1 limb
  if not zero go to strange_word
  piece_inside = final - 1, 1 limb
  piece_select = piece_select - 2, 1 limb
  call next_piece

ds_word:
  entering = entering - 2^44               # less its tag
  t = entering * 2^0, 4 limbs
  path_lead = path_lead - t, 4 limbs
  piece_select = piece_select + 2, 1 limb
next_coefficient:
  call next_piece
coefficient_word:
  if not port check_holds go to bad_word
  entering = entering * 2^9                # bits 35:0
  entering = floor(entering * 2^36 >> 45)
  test piece_select * 2^10, 1 limb         # 51, or 43 and 47
  if not negative go to next_coefficient
  go to piece_whole

put_before_end:
  test piece_put - profile_end, 2 limbs
  if negative return
  piece_put = profile_begin, 2 limbs
  return

stop_word:
  piece_inside = 1, 1 limb
  t = entering - 2^44
  if zero go to bad_word
  t = t - 2^20                             # again
  if negative go to own_steps
  if zero go to bad_word
  test t - most_again
  if not negative go to bad_word
  go to branch_whole
own_steps:
  most_again = 0 + 2^20, 2 limbs
next_step:
  call next_piece
step_word:
  call put_before_end
  test entering * 2^34                     # ticks
  if zero go to bad_word
  piece_select = piece_select - 4, 1 limb
  test entering * 2^1                      # last
  if not negative go to next_step
branch_whole:
  piece_select = piece_select - 2, 1 limb
  go to next_frame
