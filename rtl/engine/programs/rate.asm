# SPDX-License-Identifier: Apache-2.0
# The rate of time, tick by tick: hls/time_scaler.hpp, with what is due of hls/stop_schedule.hpp
# (stops.asm). Lines: rtl/engine/assembler/source.hpp.
#
#   rate_tick    time makes a tick towards `target`, 0 .. 2^16, at `rate`; `standing`: the machine
#                stands until a target is not 0 (rtl/time/standstill.sv)
#   time_begins  time begins, at reset and anew with other bounds, while nothing is under way
#
# A truth is 1 or 0. TimeScaler's fresh_ needs no word: nothing is under way then. It has arrived_
# in the ticks that begin on their goal with a slope of 0.

word target rate
word standing = 1, 1 limb
word hold_acceleration hold_slope          # the bounds: settings.asm

# TimeScaler: the first tick lands, and so gives the other words their values.
word asked
word aimed                                 # target_, stale behind a stop: it rests on 0
word unsettled
word resting
word wait
word ahead = 0, 2 limbs
word scaled                                # rate_; in a stop its 33 bits as a signed number
word slope braking
word way                                   # 1: rising_, or -1
word settling
word is_fine                                # 1: fine_
word stopping
word left                                  # twice the ticks
word stop_slope
word change step                           # step, negative: the branch's last

# StopSchedule: stops.asm
word near next_wait begins
word reading read
word active idle                           # path.asm

word steady                                # the tick rests: path.asm
local obeyed passed same high goal acceleration max_slope rest faster from between
data idle_ticks = 16
data one_scaled = 4294967296               # the rate 1 with 32 fraction bits; 2^16 with 16
data border = 3758096384                   # 7/8 with 32 fraction bits
data bank_entries = 768                    # kStopSteps, of three entries
data most_rest = 31                        # kStopLead - 1

rate_tick:
  test target - asked, 2 limbs
  if zero go to rests
  asked = target, 2 limbs
  unsettled = 1, 1 limb

rests:
  obeyed = target
  steady = 0, 1 limb
  test stopping + 0, 1 limb
  if not zero go to paces
  test unsettled + 0, 1 limb
  if zero go to goes_on
  test idle - idle_ticks, 1 limb
  if zero go to arrives
goes_on:
  test resting + 0, 1 limb
  if zero go to whole
  test target + 0, 2 limbs
  if not zero go to same
  test near + 0, 1 limb
  if not zero go to waits
  test begins + 0, 1 limb
  if zero go to waits
  stopping = 1, 1 limb
  scaled = one_scaled
  go to paces
waits:
  test wait + 0, 2 limbs
  if zero go to whole
  obeyed = aimed
same:
  test obeyed - aimed, 2 limbs
  if not zero go to whole
  steady = 1, 1 limb

paces:                                     # pass
  passed = 0, 2 limbs
  ahead = ahead - aimed, 2 limbs
  if not negative go to count
  ahead = ahead + 2^16, 2 limbs
  go to passes
arrives:                                   # it lands
  rest = target - 2^15, 2 limbs
  test rest - 2^12, 2 limbs                 # kBranchRate
  if negative go to whole
  steady = 1, 1 limb
whole:
  ahead = 0, 2 limbs
passes:
  passed = 1, 2 limbs

count:                                     # count, StopSchedule::due, count
  test near + 0, 1 limb
  if not zero go to comes
  wait = next_wait, 2 limbs
  near = 0 - 1, 1 limb
  go to drops
comes:
  if negative go to waited
  near = near - passed, 1 limb
waited:
  test steady + 0, 1 limb
  if zero go to clip
  wait = wait - passed, 2 limbs
  test obeyed - target, 2 limbs            # it waits for a branch
  if not zero go to drops
clip:
  test wait - most_rest, 2 limbs
  if not negative go to drops
  wait = most_rest, 2 limbs
drops:
  begins = begins * steady, 1 limb

  test stopping + 0, 1 limb
  if zero go to aim
  test passed + 0, 1 limb
  if zero go to slides
  test left + 0, 1 limb                    # stop_on
  if not zero go to stops
  from = reading + read
  port address = from, 2 limbs
  step = port memory
  step = step * 2^1                        # bit 43 is its sign
  change = floor(step * 2^33 >> 45)
  left = change * 2^12
  left = step - left
  change = change * 2^13
  change = floor(change * 2^32 >> 45)
  read = read + 3, 1 limb
  test read - bank_entries, 1 limb
  if not zero go to stops
  read = 0, 1 limb
stops:
  left = left - 2, 1 limb
  if not zero go to slows
  test step + 0
  if negative go to stopped
slows:
  stop_slope = stop_slope + change
  scaled = scaled + stop_slope
  scaled = scaled * 2^12
  scaled = floor(scaled * 2^33 >> 45)
slides:                                    # between two ticks of path time
  rest = stop_slope * 2^12
  rest = floor(rest * 2^18 >> 45)
  rest = rest * ahead
  rest = floor(rest * 2^29 >> 45)
  between = floor(scaled * 2^30 >> 45)
  between = between - rest
  between = between * 2^27                 # its bit 17 is the sign
  if not negative go to slowed
  rate = aimed - 1, 2 limbs                # the most that is below it
  go to stand
slowed:
  rate = aimed + aimed, 2 limbs
  rate = floor(rate * between >> 45), 2 limbs
  go to stand
stopped:
  stopping = 0, 1 limb
  stop_slope = 0
  obeyed = 0
  high = 0, 1 limb
  go to lands

aim:
  same = obeyed - aimed, 2 limbs
  aimed = obeyed, 2 limbs
  high = obeyed + 2^13
  high = floor(high * 2^29 >> 45), 1 limb    # 1: from 7/8 on
  test idle - idle_ticks, 1 limb
  if not zero go to rate_follows
  unsettled = 0, 1 limb
lands:                                     # rest, land
  resting = 0, 1 limb
  settling = 0, 1 limb
  slope = 0
  braking = 0
  is_fine = high, 1 limb
  scaled = obeyed * 2^16
  go to lies

rate_follows:
  test slope + 0
  if not zero go to sides
  test scaled - border
  if not zero go to sides
  is_fine = high, 1 limb                     # a rate that settles moves neither way
sides:
  goal = obeyed * 2^16
  test high - is_fine, 1 limb
  if zero go to bounds
  goal = border
bounds:
  acceleration = hold_acceleration
  max_slope = hold_slope
  test is_fine + 0, 1 limb
  if zero go to distance
  acceleration = floor(acceleration * 2^42 >> 45)
  max_slope = floor(max_slope * 2^42 >> 45)
distance:
  resting = 0, 1 limb
  rest = goal - scaled
  test slope + 0
  if not zero go to moves
  way = floor(rest * 2^0 >> 45)
  way = way + way
  way = way + 1
  rest = rest * way
  if not zero go to away
  settling = 0, 1 limb                     # on its goal
  test same + 0, 2 limbs
  if not zero go to rated
lies:
  rest = scaled - 2^31
  test rest - 2^28                         # kBranchRate
  if negative go to rated
  resting = 1, 1 limb
  go to rated
away:
  test settling + 0, 1 limb
  if zero go to leaves
  settling = 0, 1 limb
  go to rated
leaves:                                    # with a slope of 0 `braking` is 0, too
  test rest - acceleration
  if not negative go to drives
  settling = 1, 1 limb
  scaled = goal
  go to rated
moves:
  rest = rest * way
  rest = rest - braking
  rest = rest - slope
  if negative go to brakes
drives:
  faster = slope + acceleration
  test max_slope - faster
  if negative go to keeps
  test rest - faster
  if negative go to keeps
  braking = braking + slope
  slope = faster
  go to keeps
brakes:
  slope = slope - acceleration
  braking = braking - slope
keeps:
  rest = slope * way
  scaled = scaled + rest

rated:
  rate = floor(scaled * 2^29 >> 45), 2 limbs
stand:
  standing = 0, 1 limb
  test target + 0, 2 limbs
  if not zero return
  test active + 0, 1 limb                  # no program is under way, and none can begin
  if zero go to stands
  test stopping + 0, 1 limb
  if not zero return
  test scaled + 0
  if not zero return
stands:
  standing = 1, 1 limb
  return

time_begins:
  unsettled = 1, 1 limb
  stopping = 0, 1 limb
  stop_slope = 0
  left = 0, 1 limb
  wait = most_rest, 2 limbs
  idle = idle_ticks, 1 limb
  return
