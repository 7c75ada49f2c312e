# SPDX-License-Identifier: Apache-2.0
# A piece, and the stop branch before it, word by word: hls::PieceEntry, hls/word_entry.hpp.
# `call next_piece`: words.asm.

word pieces = 0, 2 limbs                   # whole ones in the queue, with their branches
word piece_inside = 0, 1 limb              # 0: the next frame is its program's first
word piece_number = 0, 1 limb              # of the next one, modulo 2^8
word piece_ticks piece_final
word piece_select piece_check pieces_wait entering
word entry_path path_lead                  # ledger.asm
local t high e m number power

data last_coefficient = 51                 # selects
data after_branch = 95                     # 4 less than 99, a piece; bit 6 is ours

piece_whole:
  piece_number = piece_number + 1, 1 limb
  pieces = pieces + 1, 2 limbs
  call piece_entered
  piece_select = 31, 1 limb
next_frame:
  call next_piece

piece_word:
  test pieces_wait + 0, 1 limb
  if not zero go to word_stays
  test piece_inside + 0, 1 limb
  if not zero go to piece_follows
  piece_check = port digest_in, 1 limb
  port check = piece_check, 1 limb
piece_follows:
  test piece_select - stop_select, 1 limb
  if zero go to stop_word
  t = entering * 2^9                       # bits 35:0
  high = floor(t * 2^4 >> 45), 1 limb
  if not zero go to bad_word
  piece_final = floor(t * 2^5 >> 45), 1 limb
  high = floor(t * 2^11 >> 45), 1 limb     # final, e
  e = piece_final * 2^6, 1 limb
  e = high - e, 1 limb
  test e - 47, 1 limb
  if not negative go to bad_word
  m = high * 2^5, 1 limb
  high = floor(t * 2^16 >> 45)             # final, e, m
  m = high - m, 1 limb
  test m - 20, 1 limb
  if not negative go to bad_word
  t = floor(t * 2^36 >> 45)
  high = high * 2^20
  piece_ticks = t - high
  if zero go to bad_word
  power = 1, 2 limbs                       # 2^m
  loop
    m = m - 4, 1 limb
    if negative go to by_ones
    power = power * 2^4, 2 limbs
  repeat 4 times
by_ones:
  m = m + 4, 1 limb
  loop
    m = m - 1, 1 limb
    if negative go to powered
    power = power + power, 2 limbs
  repeat 3 times
powered:
  test power - piece_ticks, 2 limbs
  if negative go to bad_word
  number = floor(entering * 2^9 >> 45), 1 limb
  number = number - piece_number, 1 limb
  test number * 2^7, 1 limb
  if not zero go to strange_word
  piece_inside = piece_final - 1, 1 limb
  piece_select = 33, 1 limb
  call next_piece

ds_word:
  entry_path = entering - 2^44
  path_lead = path_lead - entry_path, 4 limbs
  piece_select = piece_select + 2, 1 limb
next_coefficient:
  call next_piece
coefficient_word:
  if not port check_holds go to bad_word
  test piece_select - last_coefficient, 1 limb
  if not zero go to next_coefficient
  go to piece_whole

stop_word:
  piece_inside = 1, 1 limb
  t = entering - 2^44
  if zero go to bad_word
  test t - 2^20
  if not negative go to bad_word
next_step:
  call next_piece
step_word:
  test entering * 2^34                     # ticks
  if zero go to bad_word
  piece_select = stop_select, 1 limb
  test entering * 2^1                      # last
  if not negative go to next_step
  piece_select = after_branch, 1 limb
  go to next_frame
