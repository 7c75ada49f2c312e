# SPDX-License-Identifier: Apache-2.0
# Where the two programs begin: the background tells the board what it is made for before it does
# anything, at places that every store has.

  go to reset
  go to foreground
reset:
  port made_for = own, 1 limb
  go to first_values
