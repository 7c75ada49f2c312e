// SPDX-License-Identifier: Apache-2.0
// A part planned, drawn by the bit-true kernel and checked in one thread, for a page in a browser.
#pragma once

#include <string>
#include <vector>

namespace curvecore::sysc {

struct DrawnPart {
    std::string json;    // data of the report's page, and chords of equal traffic beside it
    std::string report;  // that page, report.html
};

/// Plans and draws a part as `curvecore run --on kernel` does, and writes samples.csv.
/// @param arguments FILE and options, as `curvecore plan` takes them
/// @throws ref::InputError, UsageError; std::bad_alloc
DrawnPart draw_part(std::vector<std::string> arguments);

}  // namespace curvecore::sysc
