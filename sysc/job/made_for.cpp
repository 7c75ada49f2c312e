// SPDX-License-Identifier: Apache-2.0
#include "sysc/job/made_for.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "hls/registers/board_facts.h"
#include "rtl/engine/compiler/word_numbers.hpp"

namespace curvecore::sysc {
namespace {

std::uint16_t board_digest(const Options& options) {
    const CoreParameters& core = options.core;
    const std::uint32_t capability =
        CURVECORE_PUT(CAPABILITY_AXES, core.axes()) |
        CURVECORE_PUT(CAPABILITY_BUILD, core.build == Build::kSerial) |
        CURVECORE_PUT(CAPABILITY_ENGINE, core.build == Build::kEngine) |
        CURVECORE_PUT(CAPABILITY_SPLINES, core.splines);
    const auto whole = [](double value) {
        return static_cast<std::uint32_t>(std::min(std::round(value), 4294967295.0));
    };
    return curvecore_board_digest(capability, assembler::core_word(core),
                                  whole(options.sample_period_s * options.clock_hz),
                                  whole(options.clock_hz));
}

std::uint16_t with(std::uint16_t digest, double value) {
    std::uint64_t bits = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    digest = curvecore_digest(digest, static_cast<std::uint32_t>(bits));
    return curvecore_digest(digest, static_cast<std::uint32_t>(bits >> 32));
}

}  // namespace

MadeFor made_for(const Options& options, const ref::Machine& machine) {
    std::uint16_t host = with(0, options.unit_mm);
    host = with(host, options.samples_per_tick);
    for (const double limit :
         {machine.velocity, machine.acceleration, machine.jerk, machine.joint_time}) {
        host = with(host, limit);
    }
    for (int n = 0; n < options.core.axes(); ++n) {
        const ref::AxisLimits& axis = machine.axis[static_cast<std::size_t>(n)];
        for (const double limit : {axis.velocity, axis.acceleration, axis.jerk, axis.min, axis.max,
                                   axis.rotary ? 1.0 : 0.0}) {
            host = with(host, limit);
        }
    }
    return {board_digest(options), host};
}

}  // namespace curvecore::sysc
