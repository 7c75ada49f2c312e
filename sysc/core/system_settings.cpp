// SPDX-License-Identifier: Apache-2.0
#include "sysc/core/system_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sysc/cli/choice.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

struct Setting {
    std::string_view name;
    std::string_view takes;
    void (*set)(SystemSettings& settings, const std::string& name, const std::string& text);
};

double within(const std::string& name, double value, double low, double high, const char* unit) {
    if (!(value >= low && value <= high)) {
        throw UsageError(fmt::format("{} must be in [{:g}, {:g}]{}", name, low, high, unit));
    }
    return value;
}

double time_of(const std::string& name, const std::string& text, double low, double high) {
    return within(name, duration(name, text), low, high, " s");
}

using Settings = SystemSettings;
using Text = const std::string;

constexpr double kLongestPin = 1e-3;

constexpr std::array<Setting, 14> kTable{{
    {"interpolator", "kernel|rtl",
     [](Settings& s, Text& name, Text& text) {
         s.interpolator = static_cast<BlockKind>(choice(name, text, kBlockNames));
     }},
    {"steps", "kernel|rtl|pins",
     [](Settings& s, Text& name, Text& text) {
         s.steps = static_cast<StepsKind>(choice(name, text, kStepsNames));
     }},
    {"host", "1ms",
     [](Settings& s, Text& name, Text& text) { s.host_s = time_of(name, text, 1e-6, 100); }},
    {"jitter", "0ms",
     [](Settings& s, Text& name, Text& text) { s.jitter_s = time_of(name, text, 0, 100); }},
    {"word", "1us",
     [](Settings& s, Text& name, Text& text) { s.word_s = time_of(name, text, 0, 1); }},
    {"step", "2.5um",
     [](Settings& s, Text& name, Text& text) { s.step_mm = length(name, text, 1e-6, 10); }},
    {"steplen", "1us",
     [](Settings& s, Text& name, Text& text) {
         s.pins.steplen = time_of(name, text, 0, kLongestPin);
     }},
    {"stepspace", "2us",
     [](Settings& s, Text& name, Text& text) {
         s.pins.stepspace = time_of(name, text, 0, kLongestPin);
     }},
    {"dirsetup", "200ns",
     [](Settings& s, Text& name, Text& text) {
         s.pins.dirsetup = time_of(name, text, 0, kLongestPin);
     }},
    {"dirhold", "200ns",
     [](Settings& s, Text& name, Text& text) {
         s.pins.dirhold = time_of(name, text, 0, kLongestPin);
     }},
    {"frequency", "50Hz",
     [](Settings& s, Text& name, Text& text) {
         s.axis.frequency_hz = frequency(name, text, 0.1, 1e5);
     }},
    {"damping", "0.7",
     [](Settings& s, Text& name, Text& text) {
         s.axis.damping = within(name, quantity(name, text, {{"", 0}}), 0.01, 10, "");
     }},
    {"friction", "20",
     [](Settings& s, Text& name, Text& text) {
         s.axis.friction = within(name, quantity(name, text, {{"", 0}}), 0, 1e6, " mm/s^2");
     }},
    {"encoder", "1um",
     [](Settings& s, Text& name, Text& text) { s.axis.encoder_mm = length(name, text, 1e-6, 10); }},
}};

}  // namespace

void set_system(SystemSettings& settings, const std::string& text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals);
    const auto found = std::find_if(kTable.begin(), kTable.end(),
                                    [&](const Setting& s) { return s.name == name; });
    if (found == kTable.end() || equals == text.size()) {
        throw UsageError(
            fmt::format("--system '{}': must be NAME=VALUE of {}", text, system_names()));
    }
    found->set(settings, "--system " + name, text.substr(equals + 1));
}

std::string system_names() {
    std::string names;
    for (const Setting& setting : kTable) {
        names += fmt::format("{}{}={}", names.empty() ? "" : ", ", setting.name, setting.takes);
    }
    return names;
}

}  // namespace curvecore::sysc
