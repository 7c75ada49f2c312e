// SPDX-License-Identifier: Apache-2.0
// Ports of rtl/motion_interpolator.sv.
#pragma once

#include "tb/support/bench/any_core.hpp"

namespace curvecore::tb {

struct MotionPorts {
    bool rst_ni = true;
    uint32_t digest_i = 0;
    bool segment_valid_i = false;
    uint64_t segment_data_i = 0;
    bool profile_valid_i = false;
    uint64_t profile_data_i = 0;
    bool sample_request_valid_i = false;
    bool sample_ready_i = false;
    bool hold_i = false;
    uint32_t override_i = 65536;
    bool kill_i = false;
    unsigned samples_per_tick_log2_i = 0;
    uint32_t hold_acceleration_i = 0;
    uint64_t hold_slope_i = 0;
    uint32_t stop_ticks_i = 0;

    bool segment_ready_o = false;
    bool profile_ready_o = false;
    bool sample_request_ready_o = false;
    bool sample_valid_o = false;
    int64_t sample_fine_o[kPortAxes] = {};      // of a valid sample
    int64_t sample_position_o[kPortAxes] = {};  // of a valid sample
    bool path_valid_o = false;
    uint64_t path_ds_o = 0;
    uint32_t path_rate_o = 0;
    bool path_active_o = false;
    uint64_t path_o = 0;
    bool active_o = false;
    bool underrun_o = false;
    bool killed_o = false;
    bool standing_o = false;
    unsigned fault_o = 0;
    uint32_t empty_segments_o = 0;
};

using MotionCore = AnyCore<MotionPorts>;

}  // namespace curvecore::tb
