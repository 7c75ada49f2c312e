# SPDX-License-Identifier: Apache-2.0
# Words of the profile queue (hls/words.hpp): a piece becomes the path's next one, a branch before
# it goes to the stop memory (load_wait, load_step of hls/stop_schedule.hpp). Lines:
# rtl/engine/assembler/source.hpp.
#
#   fetch_piece   if the path has no next piece and the queue a whole one: takes the piece, or of
#                 the branch before it the stop, or up to two steps
#
# So a tick in which the piece under way ends may come while `next` is not 0, or `pieces` is. The
# queue has 46 bits of a word: the highest two are 0 of a piece's first word, 1 of a stop, -2 of a
# step; a ds and coefficients stand there alone, as numbers. A piece, a stop and a step begin in
# front of profile_end: the last piece's words may go on behind it.

word piece_take = profile_begin, 2 limbs   # address of the first word
word pieces                                # whole pieces, with their branches: words.asm
word profile_words
word ticks m e next next_ds next_final next_c1 next_c2 next_c3        # path.asm
word branch loading                        # stops.asm
word loaded                                # entries of the last branch; 0: none that is not in use
data bank_entries = 768                    # kStopSteps, of three entries

local word_here above place more

fetch_piece:
  test next + 0, 1 limb
  if not zero return
  test pieces + 0, 2 limbs
  if zero return
  test piece_take - profile_end, 2 limbs
  if negative go to taken_from
  piece_take = profile_begin, 2 limbs
taken_from:
  port address = piece_take, 2 limbs
  word_here = port memory
  if negative go to load_step
  above = word_here - 2^44
  if not negative go to load_wait

  above = floor(word_here * 2^25 >> 45)    # bits 19:0 are the ticks,
  ticks = above * 2^20
  ticks = word_here - ticks
  place = floor(above * 2^40 >> 45)        # 24:20 m,
  m = place * 2^5, 1 limb
  m = above - m, 1 limb
  above = floor(place * 2^39 >> 45)        # 30:25 e,
  e = above * 2^6, 1 limb
  e = place - e, 1 limb
  next_final = above * 2^44                # 31 final
  next_final = next_final * -1 >> 45       # a half, rounded up
  next_ds = port memory
  next_c1 = port memory
  next_c2 = port memory
  next_c3 = port memory
  piece_take = piece_take + 2^4, 2 limbs   # 5 words
  piece_take = piece_take - 1, 2 limbs
  profile_words = profile_words - 2^2, 2 limbs
  profile_words = profile_words - 1, 2 limbs
  pieces = pieces - 1, 2 limbs
  go to piece

load_wait:
  branch = above - 2^20, 2 limbs           # again: its steps are there
  if not negative go to wait_loaded
  branch = above, 2 limbs
  loaded = 0, 1 limb
wait_loaded:
  profile_words = profile_words - 1, 2 limbs
  piece_take = piece_take + 3, 2 limbs
  return

load_step:
  more = 1, 1 limb
  loop
    test loaded - bank_entries, 1 limb
    if not zero go to bank_has_room
    loaded = 0, 1 limb
bank_has_room:
    place = loading + loaded, 2 limbs
    port address = place, 2 limbs
    port memory = word_here
    loaded = loaded + 3, 1 limb
    profile_words = profile_words - 1, 2 limbs
    piece_take = piece_take + 3, 2 limbs
    test piece_take - profile_end, 2 limbs
    if not negative return
    port address = piece_take, 2 limbs
    word_here = port memory
    if not negative return
    more = more - 1, 1 limb
    if negative return
  repeat 1 times
