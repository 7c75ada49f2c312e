// SPDX-License-Identifier: Apache-2.0
// What the system around a core is like: `--system NAME=VALUE`.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace curvecore::sysc {

/// What makes the blocks of the system that the RTL has.
enum class BlockKind { kKernel, kRtl };
constexpr std::array<std::string_view, 2> kBlockNames{"kernel", "rtl"};
/// kPins: the RTL as a SystemC module, whose pins are signals.
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
    double encoder_mm = 1e-3;  // from count to count
};

struct SystemSettings {
    BlockKind interpolator = BlockKind::kKernel;
    StepsKind steps = StepsKind::kKernel;
    double host_s = 1e-3;     // from one look of the host to the next
    double jitter_s = 0;      // and up to so much later
    double word_s = 1e-6;     // of a word of 48 bits on the bus
    double step_mm = 2.5e-3;  // degrees of a rotary axis
    PinTimes pins;
    AxisSettings axis;
};

/// NAME=VALUE into the settings. @throws UsageError
void set_system(SystemSettings& settings, const std::string& text);

/// The names, each with what it takes and its default.
std::string system_names();

}  // namespace curvecore::sysc
