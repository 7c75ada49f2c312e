# SPDX-License-Identifier: Apache-2.0
# The path of a program, tick by tick: hls/path_kernel.hpp. Lines: rtl/engine/assembler/source.hpp.
#
#   piece   ticks, m and e of the next piece (hls/words.hpp) become what the path needs; next_ds,
#           next_final, 1 or 0, and next_c1 .. next_c3 are there already: pieces.asm
#   tick    time goes on by `rate`, 0 .. 2^16, of which `target` is 0 if it is held; `increment` is
#           what the path goes on by, quanta
#
# Where a piece begins, its branch passes: stops.asm.

word target rate increment
word may_begin                             # 1: a program may begin, ledger.asm
word ticks m e
word next_end next_ds next_final next_c1 next_c2 next_c3 next_tau
word next = 0, 1 limb                      # it is there
word queued_ticks = 0                      # of the pieces that have not begun,
word finals = 0, 2 limbs                   # and how many of these are final
word end ds final c1 c2 c3 to_tau time walked
word active = 0, 1 limb
word idle                                  # ticks without a piece, 16 at most: time_begins
wide next_scale scale
local path start tau d place
data idle_ticks = 16
data tau_bits = 28
data scale_place = 44                      # of 2^11

piece:
  next_end = ticks * 2^16
  place = tau_bits - m, 1 limb             # 2^(28-m): tau = time 2^(19-m) has 35 fraction bits,
  place = place * 2^2, 1 limb              # and 2^9 more
  port address = place, 1 limb             # powers.asm
  next_tau = port memory
  place = e * 2^2, 1 limb                  # 2^(11+e): d has 34 fraction bits
  place = place + scale_place, 1 limb
  port address = place, 1 limb
  next_scale = port memory, 4 limbs
  next = 1, 1 limb
  return

tick:
  increment = 0
  test active + 0, 1 limb
  if zero go to resting
  time = time + rate
  test time - end
  if negative go to inside
  increment = ds - walked                   # the rest of the piece
  walked = ds
  test final + 0, 1 limb
  if not zero go to ended
  test next + 0, 1 limb
  if zero go to waiting
  start = time - end
  go to branch_passes
waiting:
  time = end
  go to no_idle_tick
ended:
  active = 0, 1 limb
  go to idles
resting:
  test target + 0, 2 limbs
  if zero go to idles
  test may_begin + 0, 1 limb
  if zero go to idles
  test next + 0, 1 limb
  if zero go to idles
  start = rate
  go to branch_passes
piece_begins:
  queued_ticks = queued_ticks - ticks
  finals = finals - next_final, 2 limbs
  end = next_end
  ds = next_ds
  final = next_final, 1 limb
  c1 = next_c1
  c2 = next_c2
  c3 = next_c3
  to_tau = next_tau
  scale = next_scale + 0, 4 limbs
  next = 0, 1 limb
  active = 1, 1 limb
  port path_active = active, 1 limb
  walked = 0
  time = start
  test time - end
  if not negative go to beyond
inside:
  tau = time * to_tau
  tau = tau + tau
  d = c3
  d = c2 + (d * tau >> 45)
  d = c1 + (d * tau >> 45)
  d = d * tau >> 45
  path = wide scale * d >> 45, 4 limbs      # the path goes neither back ..
  test path - walked, 4 limbs
  if not negative go to forward
  path = walked + 0, 4 limbs
forward:
  test ds - path, 4 limbs                   # .. nor beyond the piece's end
  if not negative go to reached
beyond:
  path = ds + 0, 4 limbs
reached:
  increment = increment + path
  increment = increment - walked
  walked = path + 0
no_idle_tick:
  idle = 0, 1 limb
  return
idles:
  test idle - idle_ticks, 1 limb
  if zero return
  idle = idle + 1, 1 limb
  return
