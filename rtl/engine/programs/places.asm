# SPDX-License-Identifier: Apache-2.0
# Places of the axes, and the rates between them: PlaceScaler of hls/place_scaler.hpp.
#
#     place = floor(position scale / 2^FineBits)          2^-16 step
#     rate  = place - place of the sample before          2^-16 step per period
#
#   read_scales    after a reset, from the board
#   put_sample     rates of the sample in fine[k]
#   put_position   rates of a sample whose positions the host wrote
#
# The first sample after a reset says where axes stand that the board references, and a program's
# is refused a step or more away from its place. Whether an axis is referenced the board knows. A
# sample is `placing` until it is whole: then its places are those of a sample that is taken.

word first = 1, 1 limb     # no sample since the reset
axis fine[k] place[k] scale[k]
local position moved kept            # places_assembler.cpp has them, too
local mask                           # references of the axes to come, the next one's in bit 13
local bound                          # 2^45 over the rates that are not refused
local back beyond

put_sample:
  back = port link, 1 limb
  call begin_sample
  for each axis call place_axis
  call place_auxiliary
  port link = back, 1 limb
  return

put_position:
  back = port link, 1 limb
  call begin_sample
  bound = 0 + 2^far_bound
  for each axis call place_position
  call place_auxiliary_positions
  port sample_whole = 0, 1 limb
  port link = back, 1 limb
  return

begin_sample:
  port placing = 0, 1 limb
  mask = 0, 1 limb
  bound = 0 + 2^far_bound
  test first + 0, 1 limb
  if zero return
  first = 0, 1 limb
  mask = port references, 1 limb
  bound = 0 + 2^29                  # a step
  return

place_position:
  position = port position_in
  position = position * 2^position_room
  go to place_here
place_axis:
  position = fine[k] * 2^fine_left
place_here:
  position = floor(position * scale[k] >> 45)
  moved = position - place[k]
  if zero go to rate_unmoved
  place[k] = position
rate_moved:
  mask = mask * 2^1, 1 limb
  if negative go to rate_stands
  beyond = floor(moved * bound >> 45), 2 limbs
  if zero go to rate_within
  test beyond + 1, 2 limbs
  if not zero go to rate_refused
rate_within:
  port moved_on = 0, 1 limb
put_rate:
  port axis_rate = moved, 2 limbs
  return

put_moved:                         # as above, of `moved` and `position`
  test moved + 0
  if not zero go to rate_moved
rate_unmoved:
  mask = mask * 2^1, 1 limb
  if negative go to rate_stands
  port unmoved = 0, 1 limb
  go to put_rate
rate_refused:
  beyond = moved * 2^rate_room, 2 limbs   # 0 if the rate is
  if zero go to rate_refused_still
  port refused_move = 0, 1 limb
  go to put_rate
rate_refused_still:
  port refused = 0, 1 limb
  go to put_rate
rate_stands:
  port stands_at = 0, 1 limb
  moved = position * 2^29          # its fraction of a step
  moved = floor(moved * 2^16 >> 45)
  go to put_rate

read_scales:
  back = port link, 1 limb
  for each axis call read_scale
  call read_auxiliary_scales
  port link = back, 1 limb
  return
read_scale:
  scale[k] = port scale_low         # 32 bits
  moved = port scale_high
  moved = moved * 2^31              # twice: it may have 45 bits
  scale[k] = scale[k] + moved
  scale[k] = scale[k] + moved
  return
