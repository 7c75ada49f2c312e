# SPDX-License-Identifier: Apache-2.0
# Even shares of a tick's increment among its 2^n samples, and the path: SampleShare of
# hls/path_kernel.hpp. After j samples floor(j increment / 2^n) is gone.
#
#   share_tick   `increment` is a new tick's; n is the port's. `left` samples are its
#   share        `path_ds`: the next sample's, one of those left; `path_total` goes on by it

word left = 0              # samples that the tick still has: 0 asks for a new one
word increment             # of a tick, then its floor(increment / 2^n)
word path_ds
wide path_total = 0        # 64 bits
word shares odd gone       # 2^n, increment modulo 2^n, and how much of 2^n is missing to a quantum
local n whole

share_tick:
  n = port samples_per_tick_in, 1 limb
  whole = increment + 0, 4 limbs
  shares = 0 + 1
  loop
    n = n - 1, 1 limb
    if negative go to divided
    shares = shares + shares
    increment = floor(increment * 2^44 >> 45)
  repeat 15 times
divided:
  odd = increment * shares, 4 limbs
  odd = whole - odd, 4 limbs
  gone = 0 - shares
  left = shares
  return

share:
  left = left - 1
  path_ds = increment + 0                # of 46 bits, which a copy cuts
  gone = gone + odd
  if negative go to shared
  gone = gone - shares
  path_ds = path_ds + 1
shared:
  path_total += wide path_ds * 2^0
  return
