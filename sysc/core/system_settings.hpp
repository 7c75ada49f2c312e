// SPDX-License-Identifier: Apache-2.0
// Settings of the system around a core: `--system NAME=VALUE`.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace curvecore::sysc {

/// Implementation of the system's blocks that exist in RTL.
enum class BlockKind { kKernel, kRtl };
constexpr std::array<std::string_view, 2> kBlockNames{"kernel", "rtl"};
/// Implementation of the step generator; kPins: the RTL as a SystemC module, whose pins are
/// signals.
enum class StepsKind { kKernel, kRtl, kPins };
constexpr std::array<std::string_view, 3> kStepsNames{"kernel", "rtl", "pins"};

/// Times of the drives' pins, seconds.
struct PinTimes {
    double steplen = 1e-6;
    double stepspace = 2e-6;
    double dirsetup = 200e-9;
    double dirhold = 200e-9;
};

/// An axis behind its drive: x'' = w^2 (u - x) - 2 D w x' - friction, w = 2 pi frequency.
struct AxisSettings {
    double frequency_hz = 50;
    double damping = 0.7;
    double friction = 20;      // mm/s^2
    double encoder_mm = 1e-3;  // mm from count to count
};

struct SystemSettings {
    BlockKind interpolator = BlockKind::kKernel;
    StepsKind steps = StepsKind::kKernel;
    double host_s = 1e-3;     // period at which the host looks, s
    double jitter_s = 0;      // random delay added to it, up to this, s
    double word_s = 1e-6;     // time of a word of 48 bits on the bus, s
    double step_mm = 2.5e-3;  // mm a step; degrees on a rotary axis
    PinTimes pins;
    AxisSettings axis;
};

/// Sets one of the settings from NAME=VALUE. @throws UsageError
void set_system(SystemSettings& settings, const std::string& text);

/// Returns the names, each with its values and its default.
std::string system_names();

}  // namespace curvecore::sysc
