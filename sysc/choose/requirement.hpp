// SPDX-License-Identifier: Apache-2.0
// What is asked of a core.
#pragma once

#include <optional>
#include <string>

#include "ref/machine/machine.hpp"
#include "sysc/cost/cost_model.hpp"

namespace curvecore::sysc {

/// | field           | unit    | meaning                                                          |
/// |-----------------|---------|------------------------------------------------------------------|
/// | error_mm        | mm      | worst error of a position as the core gives it, on any axis      |
/// | unit_mm         | mm      | length unit; none: any of kUnits                                 |
/// | radius_mm       | mm      | arcs and helices of up to this radius, and lines; 0: none        |
/// | least_radius_mm | mm      | and from this radius up                                          |
/// | length_mm       | mm      | splines of up to this length; 0: none                            |
/// | feed            | mm/s    | along the path, where the machine's acceleration and jerk let it |
/// | travel_mm       | mm      | positions within so far of the origin                            |
/// | sample_period_s | s       |                                                                  |
/// | clock_hz        | Hz      | that the core must run at; none: any that it reaches             |
/// | host_words      | 1/s     | bus words of segments that the host can send, 48 bits each       |
/// | whole_board     |         | the device holds a motion_board with its UART, not a core alone  |
/// | machine         |         | acceleration and jerk                                            |
struct Requirement {
    double error_mm = 0;
    std::optional<double> unit_mm;
    double radius_mm = 0;
    double least_radius_mm = 0.01;
    double length_mm = 0;
    double feed = 0;
    double travel_mm = 0;
    double sample_period_s = 100e-6;
    std::optional<double> clock_hz;
    double host_words = 100e3;
    const Device* device = nullptr;
    std::optional<Build> build;
    bool whole_board = false;
    ref::Machine machine;

    bool arcs() const { return radius_mm > 0; }
    bool splines() const { return length_mm > 0; }
};

}  // namespace curvecore::sysc
