# SPDX-License-Identifier: Apache-2.0
# Stop branches as they pass, hls/stop_schedule.hpp: pieces.asm loads them, rate.asm takes what is
# due, and the steps. Lines: rtl/engine/assembler/source.hpp.
#
#   branch_passes  begin_piece: path.asm goes there where a piece begins, `active` as before, and
#                  goes on at piece_begins

word near = - 1, 1 limb                    # path time until what is next is due; -1: another counts
word next_wait begins                      # next_
word branch = 0, 2 limbs                   # wait of the branch before the next piece, 0: none
word reading = stop_begin                  # a bank: the steps that a stop takes ..
word read                                  # .. and how many entries it has taken
word loading = stop_middle                 # the other bank: the steps before the next piece
word loaded                                # pieces.asm
word steady active                         # rate.asm, path.asm
data most_rest = 31                        # kStopLead - 1

branch_passes:
  test branch + 0, 2 limbs
  if not zero go to counts
  test active + 0, 1 limb
  if not zero go to piece_begins
counts:
  test near + 0, 1 limb
  if not negative go to passed
  near = most_rest, 1 limb
  begins = 0, 1 limb
  next_wait = 1, 2 limbs
  test branch + 0, 2 limbs
  if zero go to piece_begins
  next_wait = branch, 2 limbs
  begins = steady, 1 limb
  if zero go to passed
  read = 0, 1 limb
  test loaded + 0, 1 limb
  if zero go to passed                     # again: they are where they are read
  loaded = 0, 1 limb
  reading = reading + loading              # the banks change places
  loading = reading - loading
  reading = reading - loading
passed:
  branch = 0, 2 limbs
  go to piece_begins
