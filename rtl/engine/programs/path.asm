# SPDX-License-Identifier: Apache-2.0
# The path of a program, tick by tick: hls/path_kernel.hpp. Lines: rtl/engine/assembler/source.hpp.
#
#   piece   the words of a piece (hls/words.hpp) become those of the next one
#   tick    time goes on by `rate`, 0 .. 2^16; `increment` is what the path goes on by, quanta

word rate held increment
word ticks m e new_ds new_final new_c1 new_c2 new_c3
word next_end next_ds next_final next_c1 next_c2 next_c3 next_tau next    # next: it is there
word end ds final c1 c2 c3 to_tau active time walked path start tau d idle count
wide next_scale scale
data idle_ticks = 16

piece:
  next_end = ticks * 2^16
  next_ds = new_ds * 2^0
  next_final = new_final * 2^0
  next_c1 = new_c1 * 2^0
  next_c2 = new_c2 * 2^0
  next_c3 = new_c3 * 2^0
  next_tau = 1 * 2^28                       # 2^(28-m): tau = time 2^(19-m) has 35 fraction bits,
  count = m * 2^0                           # and 2^9 more
  loop
    count = count - 1, 1 limb
    if negative go to tau_made
    next_tau = floor(next_tau * 2^44 >> 45)
  repeat 19 times
tau_made:
  next_scale = 1 * 2^11, 4 limbs            # 2^(11+e): d has 34 fraction bits
  count = e * 2^0
  loop
    count = count - 1, 1 limb
    if negative go to scale_made
    next_scale = next_scale + next_scale, 4 limbs
  repeat 46 times
scale_made:
  next = 1 * 2^0
  return

tick:
  increment = 0 * 2^0
  test active + 0
  if zero go to resting
  time = time + rate
  test time - end
  if negative go to inside
  increment = ds - walked                   # the rest of the piece
  walked = ds * 2^0
  test final + 0
  if not zero go to ended
  test next + 0
  if zero go to waiting
  start = time - end
  go to begin
waiting:
  time = end * 2^0
  go to count_idle
ended:
  active = 0 * 2^0
  go to count_idle
resting:
  test held + 0
  if not zero go to count_idle
  test next + 0
  if zero go to count_idle
  start = rate * 2^0
begin:
  end = next_end * 2^0
  ds = next_ds * 2^0
  final = next_final * 2^0
  c1 = next_c1 * 2^0
  c2 = next_c2 * 2^0
  c3 = next_c3 * 2^0
  to_tau = next_tau * 2^0
  scale = next_scale + 0, 4 limbs
  next = 0 * 2^0
  active = 1 * 2^0
  walked = 0 * 2^0
  time = start * 2^0
  test time - end
  if not negative go to beyond
inside:
  tau = time * to_tau
  tau = tau + tau
  d = c3 * 2^0
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
count_idle:
  test active + 0
  if zero go to idles
  idle = 0 * 2^0
  return
idles:
  test idle - idle_ticks
  if zero go to counted
  idle = idle + 1
counted:
  return
