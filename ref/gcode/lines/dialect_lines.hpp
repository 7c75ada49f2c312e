// SPDX-License-Identifier: Apache-2.0
// Lines of another dialect, translated to RS274/NGC.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ref/gcode/lines/dialect.hpp"
#include "ref/text/place.hpp"

namespace curvecore::ref {

struct ProgramLine {
    int number = 0;  // in its file, from 1
    std::string words;
    std::optional<std::string> curve;  // what an active comment (curve, ..) has behind its comma
    std::string note;                  // a code that asks for more than motion, instead of words
    bool waits = false;                // the machine stands still at the note
    std::string warning;               // message to the user about it
};

/// A translator that remembers what earlier lines have set.
class DialectLines {
  public:
    virtual ~DialectLines() = default;
    /// Fills all of the line except its number. @throws InputError
    virtual void read(std::string_view text, ProgramLine& line, const Place& place) = 0;
};

std::unique_ptr<DialectLines> lines_in(Dialect dialect);

}  // namespace curvecore::ref
