# SPDX-License-Identifier: Apache-2.0
# Even shares of a tick's increment among its 2^n samples, and the path: SampleShare of
# hls/path_kernel.hpp. After j samples floor(j increment / 2^n) is gone.
#
#   share   `sigma` (follow.asm) goes on by the next sample's, and path_sum, which the board is told.
#           Where share_index is 0, `increment` is a new tick's, and n is samples_per_tick.

word share_index = 0, 2 limbs  # samples that the tick still has
word increment             # of a tick (path.asm), then its floor(increment / 2^n)
word sigma
word samples_per_tick      # n: settings.asm
word path_sum = 0, 4 limbs # modulo 2^61
word shares share_odd share_gone   # 2^n; increment modulo 2^n; what of 2^n is missing to a quantum
local place whole part ds
data share_bits = 44

share:
  test share_index + 0, 2 limbs
  if not zero go to next_share
  whole = increment + 0, 4 limbs
  place = samples_per_tick * 2^2, 1 limb   # powers.asm
  port address = place, 1 limb
  shares = port memory, 2 limbs
  test samples_per_tick + 0, 1 limb
  if zero go to tick_shared
  place = share_bits - samples_per_tick, 1 limb
  place = place + 1, 1 limb
  place = place * 2^2, 1 limb
  port address = place, 1 limb
  part = port memory                       # 2^(45-n)
  increment = floor(increment * part >> 45)
tick_shared:
  share_odd = increment * shares, 4 limbs
  share_odd = whole - share_odd, 4 limbs
  share_gone = 0 - shares, 2 limbs
  share_index = shares, 2 limbs
next_share:
  share_index = share_index - 1, 2 limbs
  ds = increment + 0, 4 limbs            # of 46 bits, which a copy cuts
  share_gone = share_gone + share_odd, 2 limbs
  if negative go to shared
  share_gone = share_gone - shares, 2 limbs
  ds = ds + 1, 4 limbs
shared:
  sigma = sigma + ds, 4 limbs
  path_sum = path_sum + ds, 4 limbs
  port path_out = path_sum, 4 limbs
  port path_increment = ds, 4 limbs
  return
