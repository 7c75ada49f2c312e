# SPDX-License-Identifier: Apache-2.0
# Powers of two that are not known before: a table at the memory's beginning.
#
#   put_powers   writes it, at reset: 2^n of 4 limbs at 4 n, n = 0 .. 59

local power

put_powers:
  port address = 0, 1 limb
  power = 1, 4 limbs
  loop
    port memory = power, 4 limbs
    power = power + power, 4 limbs
    test power + 0, 4 limbs
    if negative return                     # 2^60 is none of 4 limbs
  repeat 59 times
