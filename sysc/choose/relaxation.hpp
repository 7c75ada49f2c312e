// SPDX-License-Identifier: Apache-2.0
// Relaxations of a requirement that no configuration meets.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sysc/choose/requirement.hpp"

namespace curvecore::sysc {

/// One value of a requirement relaxed until a configuration meets the others.
///
/// | field    | meaning                                                                   |
/// |----------|---------------------------------------------------------------------------|
/// | name     | option without dashes                                                     |
/// | asked    | in mm, mm/s, Hz or words a second, as the option; LUT4 of a device        |
/// | possible | same unit, to about a twentieth, on the safe side                         |
/// | text     | "error 1.3 um instead of 1 um"                                            |
struct Relaxation {
    std::string name;
    double asked = 0;
    double possible = 0;
    std::string text;
};

/// Relaxes error, unit, radius, length, least radius, feed, sample rate, clock, host and device;
/// returns those that help alone. `tried` hears the percentage that is done.
std::vector<Relaxation> relaxations(const Requirement& requirement,
                                    const std::function<void(int)>& tried);

/// Length as text: "1.3 um"; the functions below give "10 m/min", "24 MHz".
std::string length_text(double mm);
std::string feed_text(double mm_per_s);
std::string frequency_text(double hz);

}  // namespace curvecore::sysc
