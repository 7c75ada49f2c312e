// SPDX-License-Identifier: Apache-2.0
// Requirements on a core.
#pragma once

#include <optional>
#include <string>

#include "ref/machine/machine.hpp"
#include "sysc/cost/cost_model.hpp"

namespace curvecore::sysc {

/// | field           | unit    | meaning                                                          |
/// |-----------------|---------|------------------------------------------------------------------|
/// | error_mm        | mm      | worst error of a position as the core returns it, on any axis    |
/// | unit_mm         | mm      | length unit; none: any of kUnits                                 |
/// | radius_mm       | mm      | largest radius of arcs and helices, and lines; 0: none           |
/// | least_radius_mm | mm      | smallest radius of arcs and helices                              |
/// | length_mm       | mm      | greatest length of splines; 0: none                              |
/// | feed            | mm/s    | along the path, where the machine's acceleration and jerk let it |
/// | travel_mm       | mm      | greatest distance of a position from the origin, on any axis     |
/// | sample_period_s | s       |                                                                  |
/// | clock_hz        | Hz      | clock that the core must reach; none: any                        |
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
