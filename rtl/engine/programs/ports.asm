# SPDX-License-Identifier: Apache-2.0
# Ports and conditions of the board around the motion's programs: rtl/engine/engine_motion.sv.

# Conditions
data request = 3           # a sample is asked for, and there is room for one
data segment_waits = 4     # a word waits at a stream
data piece_waits = 5
data check_holds = 6       # of the selected stream's word
data killed = 7            # as of the request taken
data held_now = 8
data tag_is = 9            # of the selected stream's word: the selected one
data position_waits = 10   # a sample of the host, and there is room for one
data awaited = 11          # somebody waits for a sample, with none there

# IN and OUT
data link = 2              # of the program at hand
data memory = 3            # the limb at the address, which goes on by one each limb

# IN
data word_in = 4           # the selected stream's word: bits 14:0, 29:15, 45:30, 47:46
data check_in = 5          # the check after it, from the one that `check` was told
data override_in = 9       # 8 to 23: the register of that number
data samples_per_tick_in = 11
data acceleration_in = 12
data slope_in = 13         # 2^32 where the register has 0
data stop_ticks_in = 14
data digest_in = 19        # with that of the board
data scale_low = 24        # SCALE_LO of an axis
data scale_high = 25       # SCALE_HI, and goes on to the next axis
data position_in = 26      # of the host, of the axis whose rate comes next
data references = 27       # axes that the first sample references, that of axis 0 in bit 13

# OUT
data address = 4           # of the memory, 2 limbs
data take = 5              # takes the selected stream's word
data check = 6
data select = 7            # stream: 0 segments, 1 profile; + 2: bits 43:36 are left out of the check;
                           # + 4 tag
data take_request = 8
data report_underrun = 9   # each of these four stays up
data report_short = 10     # a full queue does not cover a stop
data report_settings = 11
data report_words = 12     # faults 4 to 0, a bit each
data now_active = 13       # a program is under way
data now_standing = 14     # the machine stands until a target above 0
data path_active = 15      # of the increment behind it: it is not 0
data sample = 16           # fine positions, 3 limbs of each axis
data placing = 17          # a sample's places change until it is whole
data axis_rate = 19        # of the next axis, 2 limbs; before it one of
data unmoved = 20          # .. it is 0
data moved_on = 21         # .. it is not
data stands_at = 22        # .. the axis stands at this fraction of a step
data refused = 23          # .. it is 0, and refused
data refused_move = 24     # .. it is refused
data sample_whole = 25     # they are all there
data path_out = 26         # 4 limbs
data path_increment = 28   # 4 limbs
data path_rate = 29        # 2 limbs: with the last one all of the path is there
data empties = 30          # segments without length, so far, 2 limbs
data made_for = 31         # what all programs are made for: word_numbers.hpp
