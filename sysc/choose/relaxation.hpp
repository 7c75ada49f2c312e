// SPDX-License-Identifier: Apache-2.0
// What to give up of a requirement that no configuration keeps.
#pragma once

#include <string>
#include <vector>

#include "sysc/choose/requirement.hpp"

namespace curvecore::sysc {

/// One requirement alone given up so far that a configuration keeps the others.
///
/// | field    | meaning                                                                   |
/// |----------|---------------------------------------------------------------------------|
/// | name     | of the option, without dashes                                             |
/// | asked    | in mm, mm/s, Hz or words a second, as the option; a device's LUT4         |
/// | possible | the same: to about a twentieth, on the safe side                          |
/// | text     | "error 1.3 um instead of 1 um"                                            |
struct Relaxation {
    std::string name;
    double asked = 0;
    double possible = 0;
    std::string text;
};

/// Of error, unit, radius, length, least radius, feed, sample rate, clock, host, device: those that
/// help alone.
std::vector<Relaxation> relaxations(const Requirement& requirement);

/// "1.3 um", "10 m/min", "24 MHz"
std::string length_text(double mm);
std::string feed_text(double mm_per_s);
std::string frequency_text(double hz);

}  // namespace curvecore::sysc
