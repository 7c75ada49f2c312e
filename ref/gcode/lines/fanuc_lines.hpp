// SPDX-License-Identifier: Apache-2.0
// Fanuc's lines: numbers of axes without a point, G4, M98, '/2' and assignments without brackets.
#pragma once

#include "ref/gcode/lines/code_words.hpp"
#include "ref/gcode/lines/dialect_lines.hpp"

namespace curvecore::ref {

class FanucLines : public DialectLines {
  public:
    void read(std::string_view text, ProgramLine& line, const Place& place) override;

  private:
    /// Restores after G80 the motion from before the cycle. @return true if words changed
    bool end_cycle(std::vector<CodeWord>& words);

    bool add_increments(std::vector<CodeWord>& words) const;

    bool inches_ = false;
    bool absolute_ = true;
    std::string motion_;  // number of the G code; empty: none yet
};

}  // namespace curvecore::ref
