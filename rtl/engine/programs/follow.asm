# SPDX-License-Identifier: Apache-2.0
# A stream of segments, followed along the path: hls/interpolator_kernel.hpp.
#
#   follow   draws fine[k], fine[3] .. where the path is, which share.asm moves on. Where it leads
#            into a segment that is not queued, `waits` is 1 and nothing is drawn: it is called again,
#            until `waits` is 0.
#
# curve_load, curve_step and curve_sample (rtl/engine/compiler/curve_assembler.hpp) go on at
# measure_step, the sample at drawn; fetch_segment (segment.asm) at curve_load.

word waits                 # until then: where the program is called
word sigma = 0, 4 limbs    # offset into the present step
word segment_rest = 0      # from the step's start to the segment's end; 0: there is none
word step_length = 0       # of the present step
word fine_scale segments
axis fine[k] end[k]

follow:
  waits = port link, 1 limb
in_step:
  test sigma - step_length, 4 limbs
  if negative go to curve_sample
  if not zero go to leave_step
  test segment_rest - step_length
  if not zero go to leave_step           # the end of the step, and not of the segment
  test segment_rest + 0
  if not zero go to land
leave_step:
  sigma = sigma - step_length, 4 limbs
  segment_rest = segment_rest - step_length
  if not zero go to curve_step
  step_length = 0
open_segment:
  test segments + 0, 1 limb
  if not zero go to fetch_segment
  port link = waits, 1 limb
  waits = 1, 1 limb
  return
drawn:
  port link = waits, 1 limb
  waits = 0, 1 limb
  return

measure_step:
  step_length = fine_scale * 2^step_lift   # 2^(16+k)
  test segment_rest - step_length
  if not negative go to in_step
  step_length = segment_rest
  go to in_step

land:
  call land_auxiliary
  for each axis call land_axis
  go to drawn
land_axis:
  fine[k] = end[k]
  return
