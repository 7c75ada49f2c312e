# SPDX-License-Identifier: Apache-2.0
# Words of the profile queue (hls/words.hpp): a piece becomes the path's next one, a branch before
# it goes to the stop memory (load_wait, load_step of hls/stop_schedule.hpp). Lines:
# rtl/engine/assembler/source.hpp.
#
#   fetch_piece   if the path has no next piece and the queue a whole one: takes a word of the
#                 branch before it, or the piece
#
# So a tick may come while `next` is not 0, or `pieces` is. The queue has 46 bits of a word: the
# highest two are 0 of a piece's first word, 1 of a stop, -2 of a step.

word piece_take = profile_begin, 2 limbs   # address of the first word
word pieces                                # whole pieces, with their branches: words.asm
word profile_words
word ticks m e next next_ds next_final next_c1 next_c2 next_c3        # path.asm
word branch loading                        # stops.asm
word loaded                                # entries of the branch
data bank_entries = 768                    # kStopSteps, of three entries
data second_bit = 17592186044416           # 2^44: the tag's low two bits are 1

local back word_here above place

fetch_piece:
  test next + 0, 1 limb
  if not zero return
  test pieces + 0, 2 limbs
  if zero return
  back = port link, 1 limb
  call next_word
  test word_here + 0
  if negative go to load_step
  above = word_here - second_bit
  if not negative go to load_wait

  above = floor(word_here * 2^25 >> 45)    # bits 19:0 are the ticks,
  ticks = above * 2^20
  ticks = word_here - ticks
  place = floor(above * 2^40 >> 45)        # 24:20 m,
  m = place * 2^5
  m = above - m
  above = floor(place * 2^39 >> 45)        # 30:25 e,
  e = above * 2^6
  e = place - e
  next_final = above * 2^44                # 31 final
  next_final = next_final * -1 >> 45       # a half, rounded up
  call next_word
  next_ds = word_here - second_bit
  call next_word
  next_c1 = word_here * 2^9                # 35:0, signed
  next_c1 = floor(next_c1 * 2^36 >> 45)
  call next_word
  next_c2 = word_here * 2^9
  next_c2 = floor(next_c2 * 2^36 >> 45)
  call next_word
  next_c3 = word_here * 2^9
  next_c3 = floor(next_c3 * 2^36 >> 45)
  pieces = pieces - 1, 2 limbs
  port link = back, 1 limb
  go to piece

load_wait:
  branch = above
  loaded = 0, 1 limb
  go to branch_loaded
load_step:
  place = loading + loaded
  port address = place, 2 limbs
  port memory = word_here
  loaded = loaded + 3, 1 limb
  test loaded - bank_entries, 1 limb
  if not zero go to branch_loaded
  loaded = 0, 1 limb
branch_loaded:
  port link = back, 1 limb
  return

next_word:
  port address = piece_take, 2 limbs
  word_here = port memory
  profile_words = profile_words - 1, 2 limbs
  piece_take = piece_take + 3, 2 limbs
  test piece_take - profile_end, 2 limbs
  if not zero return
  piece_take = profile_begin, 2 limbs
  return
