// SPDX-License-Identifier: Apache-2.0
// Taps of shapers against closed forms: what impulses leave at the mode, how far feed-forward is
// from the mode's inverse; and how an .ini asks for them.
#include "ref/machine/shaper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "ref/text/input_error.hpp"

namespace curvecore::tb::shaper_test {

using ref::Machine;
using ref::ShaperKind;
using ref::ShaperTaps;
using Complex = std::complex<double>;

constexpr double kSample = 1e-4;  // s

ShaperTaps taps_of(ShaperKind kind, double hertz, double damping, double sample_s = kSample) {
    Machine machine;
    machine.shaper = kind;
    machine.modes[1] = {hertz, damping};
    return ref::shaper_taps(machine, sample_s, 255)[1];
}

/// Returns the factor that taps give e^(s t), without their delay.
Complex response(const ShaperTaps& taps, Complex s, double sample_s = kSample) {
    const Complex before = std::exp(-s * (taps.delay * sample_s));
    return (before + taps.near * (1.0 - before) + taps.far * before * (1.0 - before)) / before;
}

/// Pole of a mode.
Complex pole(double hertz, double damping) {
    const double w = 2 * M_PI * hertz;
    return {-damping * w, w * std::sqrt(1 - damping * damping)};
}

TEST(Shaper, ZvLeavesNoVibrationOfTheMode) {
    for (const double damping : {0.0, 0.05, 0.2}) {
        // Half a period is a whole number of samples.
        const double hertz = 50 / std::sqrt(1 - damping * damping);
        const ShaperTaps taps = taps_of(ShaperKind::kZv, hertz, damping);
        EXPECT_EQ(taps.delay, 100);
        EXPECT_LT(std::abs(response(taps, pole(hertz, damping))), 1e-9) << damping;
        EXPECT_EQ(taps.far, 0);
    }
}

TEST(Shaper, EiLeavesTheTwentiethPartAtTheModeAndNoMoreBesideIt) {
    const ShaperTaps taps = taps_of(ShaperKind::kEi, 50, 0);
    EXPECT_NEAR(std::abs(response(taps, pole(50, 0))), 0.05, 1e-9);
    for (double hertz = 45; hertz <= 55; hertz += 0.5) {
        EXPECT_LT(std::abs(response(taps, pole(hertz, 0))), 0.0501) << hertz;
    }
}

TEST(Shaper, FeedForwardIsTheInverseOfTheMode) {
    for (const double sample_s : {1e-4, 1.6e-3}) {
        for (const double damping : {0.0, 0.05, 0.3}) {
            const ShaperTaps taps = taps_of(ShaperKind::kFeedForward, 40, damping, sample_s);
            EXPECT_LE(taps.near, 6);
            const double tau = taps.delay * sample_s;
            const double w = 2 * M_PI * 40;
            for (double hertz = 1; hertz <= 20; ++hertz) {
                const Complex s(0, 2 * M_PI * hertz);
                const Complex inverse = 1.0 + 2 * damping / w * s + s * s / (w * w);
                // Differences over +- tau are short by (s tau)^2 / 6 and / 12 of what they are of.
                const double most = std::pow(std::abs(s) * tau, 2) / 6 * std::abs(inverse - 1.0);
                EXPECT_LE(std::abs(response(taps, s, sample_s) - inverse), 1.01 * most + 1e-12);
            }
        }
    }
}

TEST(Shaper, AnExtruderLeadsByItsTime) {
    for (const double advance : {0.01, 0.2}) {
        Machine machine;
        machine.shaper = ShaperKind::kFeedForward;
        machine.modes[0].hertz = 50;
        machine.modes[3].advance_s = advance;
        const auto taps = ref::shaper_taps(machine, kSample, 255);
        EXPECT_EQ(taps[3].delay, taps[0].delay);
        EXPECT_LE(taps[3].near, 6);
        for (double hertz = 1; hertz <= 10; ++hertz) {
            const Complex s(0, 2 * M_PI * hertz);
            const double short_by = std::pow(std::abs(s) * taps[3].delay * kSample, 2) / 6;
            const Complex lead = advance * s;
            EXPECT_LE(std::abs(response(taps[3], s) - 1.0 - lead),
                      1.01 * short_by * std::abs(lead));
        }
    }
}

TEST(Shaper, ToolsAreLateByTheDelayOfTapsAndMode) {
    const Complex s(0, 1e-3);  // so slow that the phase is the delay
    for (const ShaperKind kind : {ShaperKind::kFeedForward, ShaperKind::kZv, ShaperKind::kEi}) {
        for (const double damping : {0.0, 0.05, 0.3}) {
            Machine machine;
            machine.shaper = kind;
            machine.modes[1] = {40, damping};
            const auto taps = ref::shaper_taps(machine, kSample, 255);
            const double w = 2 * M_PI * 40;
            const Complex mode = 1.0 + 2 * damping / w * s + s * s / (w * w);
            const Complex tool =
                response(taps[1], s) * std::exp(-s * (taps[1].delay * kSample)) / mode;
            const int delay = ref::tool_delay(machine, taps, kSample);
            EXPECT_NEAR(delay * kSample, -std::arg(tool) / s.imag(), 0.501 * kSample) << damping;
            if (kind == ShaperKind::kFeedForward) {
                EXPECT_EQ(delay, taps[1].delay);
            }
        }
    }
    EXPECT_EQ(ref::tool_delay({}, {}, kSample), 0);
}

TEST(Shaper, AxesWithoutAModeAreAsLateWithFeedForward) {
    Machine machine;
    machine.shaper = ShaperKind::kFeedForward;
    machine.modes[0].hertz = 30;
    machine.modes[1].hertz = 60;
    const auto taps = ref::shaper_taps(machine, kSample, 255);
    EXPECT_EQ(taps[0].delay, taps[1].delay);
    EXPECT_EQ(taps[2].delay, taps[0].delay);
    EXPECT_EQ(taps[2].near, 0);
    machine.shaper = ShaperKind::kNone;
    EXPECT_EQ(ref::shaper_taps(machine, kSample, 255)[0].delay, 0);
}

Machine machine_of(const std::string& shaper, const std::string& axis) {
    return ref::read_machine_text("[TRAJ]\nSHAPER = " + shaper + "\n[JOINT_0]\n" + axis + "\n",
                                  "m.ini");
}

std::string refusal(const std::string& shaper, const std::string& axis) {
    try {
        ref::shaper_taps(machine_of(shaper, axis), kSample, 31);
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Shaper, IsAskedForInTheMachinesFile) {
    const Machine machine =
        machine_of("feed-forward", "SHAPER_FREQUENCY = 42\nSHAPER_DAMPING = 0.1");
    EXPECT_EQ(machine.shaper, ShaperKind::kFeedForward);
    EXPECT_EQ(machine.modes[0].hertz, 42);
    EXPECT_EQ(machine.modes[0].damping, 0.1);
    EXPECT_EQ(machine.modes[1].hertz, 0);
    EXPECT_EQ(refusal("zvd", ""), "m.ini:2: error: SHAPER = zvd: none, feed-forward, zv or ei");
    EXPECT_EQ(machine_of("feed-forward", "PRESSURE_ADVANCE = 0.05").modes[0].advance_s, 0.05);
    EXPECT_EQ(refusal("zv", "PRESSURE_ADVANCE = 0.05"),
              "m.ini:4: error: PRESSURE_ADVANCE needs SHAPER = feed-forward in [TRAJ]");
    EXPECT_EQ(refusal("ei", "SHAPER_DAMPING = 1"),
              "m.ini:4: error: SHAPER_DAMPING = 1: a ratio from 0 to below 1");
    EXPECT_EQ(refusal("zv", "SHAPER_FREQUENCY = 50"),
              "m.ini: error: X: SHAPER_FREQUENCY = 50 asks for a delay of 100 samples of 0.1 ms, 1 "
              "to 31 are possible");
    EXPECT_EQ(refusal("feed-forward", "PRESSURE_ADVANCE = 0.05"),
              "m.ini: error: X: PRESSURE_ADVANCE = 0.05 asks for a delay of 32 samples of 0.1 ms, "
              "1 to 31 are possible");
    EXPECT_EQ(refusal("feed-forward", "SHAPER_FREQUENCY = 500\n[JOINT_1]\nPRESSURE_ADVANCE = 0.05"),
              "m.ini: error: Y: PRESSURE_ADVANCE = 0.05 asks for a delay of 32 samples of 0.1 ms, "
              "1 to 31 are possible");
}

}  // namespace curvecore::tb::shaper_test
