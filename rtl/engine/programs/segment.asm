# SPDX-License-Identifier: Apache-2.0
# The next segment of the queue, hls/words.hpp, of which a whole one is there.
#
#   fetch_segment   its words become those of the segment under way; goes on at curve_load, or at
#                   open_segment if it has no length
#
# Words in the queue have passed hls/word_entry.hpp: fields are sign-extended to 36 and 44 bits. The
# queue holds whole frames from segment_begin to segment_end.

word segments segment_words             # whole ones in the queue, words in it: words.asm
word segment_take = segment_begin, 2 limbs
word empty_segments = 0                 # without length: consumed
word segment_rest kind theta tau_scale fine_scale place_scale step_scale
axis start[k] end[k] tangent[k] normal[k] advance[k]
local place lambda k frame
data most_step = 44

fetch_segment:
  segments = segments - 1, 1 limb
  frame = 0 + 2^4                        # 17 + 3 AuxAxes words, and further ones
  frame = frame + 1, 1 limb
  frame = frame + words_behind_axes, 1 limb
  segment_words = segment_words - frame, 2 limbs
  place = segment_take                   # on by three entries a word
  segment_take = segment_take + frame, 2 limbs
  segment_take = segment_take + frame, 2 limbs
  segment_take = segment_take + frame, 2 limbs
  test segment_take - segment_end, 2 limbs
  if not zero go to segment_at_hand
  segment_take = segment_begin
segment_at_hand:
  port address = place, 2 limbs
  segment_rest = port memory
  segment_rest = segment_rest - 2^44     # the tag's lower bits, 1
  if zero go to no_length
  theta = port memory
  kind = theta * 2^7                     # bits 37:36, signed
  kind = floor(kind * 2^2 >> 45), 1 limb
  k = floor(theta * 2^7 >> 45), 1 limb   # the tag's lower bits, -2; last; k of 5 bits
  k = k + 2^7, 1 limb
  test k - 2^5, 1 limb
  if negative go to k_known
  k = k - 2^5, 1 limb
k_known:
  theta = theta * 2^9
  theta = floor(theta * 2^36 >> 45)
  for each axis call fetch_axis
  call fetch_auxiliary
  place = place + 2^4, 2 limbs           # lambda: bits 41:36 of X's normal, the sixth word
  place = place - 1, 2 limbs
  port address = place, 2 limbs
  lambda = port memory
  lambda = lambda * 2^3
  lambda = floor(lambda * 2^6 >> 45), 1 limb

  place = k * 2^2, 1 limb                # powers.asm
  port address = place, 1 limb
  fine_scale = port memory
  fine_scale = fine_scale * 2^fine_exponent        # 2^(fine+k)
  place = lambda * 2^2, 1 limb
  port address = place, 1 limb
  place_scale = port memory
  place_scale = place_scale * 2^fine_exponent      # 2^(fine+lambda)
  place = 0 - k, 1 limb
  place = place + 2^5, 1 limb
  place = place * 2^2, 1 limb
  port address = place, 1 limb
  tau_scale = port memory
  tau_scale = floor(tau_scale * 2^40 >> 45)        # 2^(27-k)
  place = k - lambda, 1 limb
  place = place + most_step, 1 limb
  place = place * 2^2, 1 limb
  port address = place, 1 limb
  step_scale = port memory               # 2^(44-s), s = lambda - k
  go to curve_load

fetch_axis:
  start[k] = port memory
  start[k] = start[k] * 2^1
  start[k] = floor(start[k] * 2^44 >> 45)
  end[k] = port memory
  end[k] = end[k] * 2^1
  end[k] = floor(end[k] * 2^44 >> 45)
  tangent[k] = port memory
  tangent[k] = tangent[k] * 2^9
  tangent[k] = floor(tangent[k] * 2^36 >> 45)
  normal[k] = port memory
  normal[k] = normal[k] * 2^9
  normal[k] = floor(normal[k] * 2^36 >> 45)
  advance[k] = port memory
  advance[k] = advance[k] * 2^9
  advance[k] = floor(advance[k] * 2^36 >> 45)
  return

no_length:
  empty_segments = empty_segments + 1
  port empties = empty_segments, 2 limbs
  go to open_segment
