// SPDX-License-Identifier: Apache-2.0
// Marlin's lines: one command each, with words that may lack their number.
//
// E becomes A, in mm, whose zero never moves: G92 E is applied here. G0 is G1, with a feed of 25
// mm/s until there is an F. Arguments of M codes do not affect the path.
#pragma once

#include "ref/gcode/lines/code_words.hpp"
#include "ref/gcode/lines/dialect_lines.hpp"

namespace curvecore::ref {

class MarlinLines : public DialectLines {
  public:
    void read(std::string_view text, ProgramLine& line, const Place& place) override;

  private:
    void read_m(std::vector<CodeWord> words, ProgramLine& line);
    void read_g(std::vector<CodeWord> words, ProgramLine& line, const Place& place);
    std::string moved(std::vector<CodeWord> words, const Place& place);
    std::string redefined(const std::vector<CodeWord>& words, const Place& place);
    static std::string dwell(const std::vector<CodeWord>& words, const Place& place);
    double extruder(const CodeWord& word, const Place& place) const;

    bool relative_ = false;    // G91
    bool e_relative_ = false;  // M83, or G91
    double unit_ = 1;          // mm
    double e_ = 0;             // mm, as the program counts
    double zero_ = 0;          // mm, of E on A
    bool feed_given_ = false;
};

}  // namespace curvecore::ref
