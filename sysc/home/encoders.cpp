// SPDX-License-Identifier: Apache-2.0
#include "sysc/home/encoders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hls/registers/board_facts.h"
#include "ref/curve/axes.hpp"
#include "ref/text/input_error.hpp"
#include "ref/text/text_file.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/home/joints.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kMostCounts = CURVECORE_MOST(ENCODER_RATIO0_COUNTS);
constexpr double kMostSteps = 32767;  // signed
/// Relative error of a ratio that counts as equal: a micrometre in a metre.
constexpr double kSameRatio = 1e-6;

/// Time in which axes settle at their place.
constexpr auto kSettles = std::chrono::milliseconds(500);

}  // namespace

std::vector<AxisEncoder> read_encoders(const std::string& machine_file) {
    const ref::IniFile ini(ref::read_text_file(machine_file), machine_file);
    std::vector<AxisEncoder> encoders;
    for (const Joint& joint : joints_of(ini)) {
        const auto scale = ini.number(joint.section, "ENCODER_SCALE");
        if (!scale || *scale == 0) continue;
        const int line = ini.find(joint.section, "ENCODER_SCALE")->line;
        const auto most = ini.number(joint.section, "FERROR");
        if (!most || *most <= 0) {
            throw ref::InputError(
                machine_file, line,
                fmt::format("[{}] ENCODER_SCALE: FERROR is missing", joint.section));
        }
        encoders.push_back(
            {joint.axis, joint.section, line, *scale / joint.unit_mm, *most * joint.unit_mm,
             ini.number(joint.section, "MIN_FERROR").value_or(*most) * joint.unit_mm});
    }
    return encoders;
}

/// Returns the last convergent of the continued fraction that fits.
EncoderRatio ratio_of(double counts_per_mm, double steps_per_mm) {
    const double wanted = std::abs(counts_per_mm) / steps_per_mm;
    std::pair<double, double> before{0, 1};
    std::pair<double, double> best{1, 0};
    for (double rest = wanted;;) {
        const double whole = std::floor(rest);
        const std::pair<double, double> next{whole * best.first + before.first,
                                             whole * best.second + before.second};
        if (next.first > kMostCounts || next.second > kMostSteps) break;
        before = std::exchange(best, next);
        // The remainder of a ratio of whole numbers is noise.
        if (std::abs(best.first / best.second - wanted) < 1e-12 * wanted) break;
        rest = 1 / (rest - whole);
    }
    const auto [counts, steps] = best;
    if (counts == 0 || steps == 0 || std::abs(counts / steps - wanted) > kSameRatio * wanted) {
        throw UsageError(
            fmt::format("ENCODER_SCALE of {:g} edges a mm beside {:g} steps a mm: no "
                        "ratio that the board can have",
                        counts_per_mm, steps_per_mm));
    }
    return {static_cast<int>(counts), static_cast<int>(std::copysign(steps, counts_per_mm))};
}

Encoders::Encoders(RemoteMachine& machine, const std::string& machine_file, const Drives& drives)
    : machine_(machine) {
    const bool inputs = machine.build().encoders;
    for (int axis = 0; inputs && axis < machine.build().axes; ++axis) machine.watch(axis, {}, 0);
    if (machine_file.empty()) return;
    for (const AxisEncoder& encoder : read_encoders(machine_file)) {
        if (encoder.axis >= machine.build().axes) continue;
        if (!inputs) {
            fmt::print(stderr,
                       "{}:{}: warning: [{}] ENCODER_SCALE: the board has no inputs of encoders\n",
                       machine_file, encoder.line, encoder.joint);
            continue;
        }
        const double steps_per_mm = drives.steps_per_mm[encoder.axis];
        const EncoderRatio ratio = ratio_of(encoder.counts_per_mm, steps_per_mm);
        const double units = steps_per_mm * ratio.counts;
        const double limit = std::floor(encoder.limit_mm * units);
        if (limit < 1 || limit > CURVECORE_MOST_FOLLOWING) {
            throw UsageError(
                fmt::format("FERROR of {:g} mm is more or less than the board can "
                            "watch: {:g} .. {:g} mm",
                            encoder.limit_mm, 1 / units, CURVECORE_MOST_FOLLOWING / units));
        }
        machine.watch(encoder.axis, ratio, static_cast<std::uint32_t>(limit));
        encoders_.push_back(encoder);
        units_per_mm_.push_back(units);
    }
}

std::vector<Following> Encoders::now() const {
    std::vector<Following> all;
    for (std::size_t n = 0; n < encoders_.size(); ++n) {
        const auto [now, worst] = machine_.following(encoders_[n].axis);
        all.push_back({encoders_[n], now / units_per_mm_[n], worst / units_per_mm_[n]});
    }
    return all;
}

std::vector<Following> Encoders::following() const {
    const WireClock::time_point end = machine_.now() + kSettles;
    for (;;) {
        std::vector<Following> all = now();
        if (astray(all).empty() || machine_.now() > end) return all;
        machine_.work();
    }
}

std::string Encoders::astray(const std::vector<Following>& axes) {
    std::string text;
    for (const Following& axis : axes) {
        if (std::abs(axis.now_mm) <= axis.encoder.rest_mm) continue;
        text += fmt::format("{}{} stands {:.3g} mm off, and MIN_FERROR is {:g} mm",
                            text.empty() ? "" : "; ", ref::kAxisLetters[axis.encoder.axis],
                            std::abs(axis.now_mm), axis.encoder.rest_mm);
    }
    return text;
}

}  // namespace curvecore::sysc
