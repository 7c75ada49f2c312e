// SPDX-License-Identifier: Apache-2.0
// The dialect of a G-code program. The reader's language is LinuxCNC's RS274/NGC; the others are
// translated to it line by line.
//
// | dialect  | what is other there                                                              |
// |----------|----------------------------------------------------------------------------------|
// | grbl     | lines of $ and ? are for the controller: they are noted; % has no meaning        |
// | fanuc    | numbers of axes without a point count 0.001 mm (0.0001 inch) and G4 P and X with- |
// |          | out one milliseconds, G4 X is a time, M98 P of 5 to 8 figures has its times ahead,|
// |          | U V W are increments of X Y Z                                                    |
// | marlin   | E is an auxiliary axis (A, in mm), one command a line, G0 has a feed, G4 P is in  |
// |          | milliseconds, G28 homes, what heats, fans and levels is noted                     |
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace curvecore::ref {

enum class Dialect { kLinuxcnc, kGrbl, kFanuc, kMarlin };
constexpr std::array<std::string_view, 4> kDialectNames{"linuxcnc", "grbl", "fanuc", "marlin"};

inline std::string_view name_of(Dialect dialect) {
    return kDialectNames[static_cast<int>(dialect)];
}

/// Recognises a dialect by features that no other has: a line of $, the number of a program
/// together with numbers that end in a point, an extruder's words.
class DialectFinder {
  public:
    /// Reads the next line. @return the dialect as soon as no further line can change it
    std::optional<Dialect> look_at(std::string_view text);
    /// Number of lines that had words.
    int lines() const { return lines_; }

  private:
    int lines_ = 0;
    bool numbered_ = false;    // O1234
    bool bare_point_ = false;  // X10.
};

}  // namespace curvecore::ref
