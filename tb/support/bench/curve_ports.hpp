// SPDX-License-Identifier: Apache-2.0
// Ports of the cores that draw curves: rtl/curve_interpolator.sv, the cores of one kind, and the
// serial build.
#pragma once

#include "tb/support/bench/any_core.hpp"

namespace curvecore::tb {

struct CurvePorts {
    bool rst_ni = true;
    bool segment_valid_i = false;
    uint64_t segment_data_i = 0;
    bool request_valid_i = false;
    uint64_t request_ds_i = 0;
    bool sample_ready_i = false;

    bool segment_ready_o = false;
    bool request_ready_o = false;
    bool sample_valid_o = false;
    int64_t sample_fine_o[kPortAxes] = {};      // of a valid sample
    int64_t sample_position_o[kPortAxes] = {};  // of a valid sample
    uint32_t empty_segments_o = 0;
};

using CurveCore = AnyCore<CurvePorts>;

}  // namespace curvecore::tb
