// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/dialect_lines.hpp"

#include "ref/gcode/lines/code_words.hpp"
#include "ref/gcode/lines/fanuc_lines.hpp"
#include "ref/gcode/lines/macro_lines.hpp"
#include "ref/gcode/lines/marlin_lines.hpp"
#include "ref/gcode/lines/program_lines.hpp"

namespace curvecore::ref {
namespace {

bool begins(std::string_view text, std::string_view with) {
    return text.substr(0, with.size()) == with;
}

/// Notes TinyG's homing, as G28.2 X0 Y0, to switches whose place is not known.
void note_homing(ProgramLine& line) {
    const std::vector<CodeWord> words = code_words(line.words);
    if (words.empty() || words[0].letter != 'G' || words[0].number != "28.2") return;
    line.note = line.words;
    line.words.clear();
    line.waits = true;
}

class NgcLines : public DialectLines {
  public:
    void read(std::string_view text, ProgramLine& line, const Place& place) override {
        line.words = with_o_words(words_of(text, place));
        note_homing(line);
        if (begins(line.words, "$")) {
            place.refuse("a line of grbl's: --dialect grbl notes it");
        }
    }
};

class GrblLines : public DialectLines {
  public:
    void read(std::string_view text, ProgramLine& line, const Place& place) override {
        const std::string code = bare_code(text);
        if (code == "%") return;
        if (code.empty() || std::string_view("$?!~").find(code[0]) == std::string_view::npos) {
            line.words = with_o_words(words_of(text, place));
            note_homing(line);
            return;
        }
        line.note = code.substr(0, code.find('='));
        line.waits = true;
        if (code.rfind("$J=", 0) == 0) line.warning = "a jog ($J) is not drawn";
    }
};

}  // namespace

std::unique_ptr<DialectLines> lines_in(Dialect dialect) {
    switch (dialect) {
        case Dialect::kGrbl:
            return std::make_unique<GrblLines>();
        case Dialect::kFanuc:
            return std::make_unique<FanucLines>();
        case Dialect::kMarlin:
            return std::make_unique<MarlinLines>();
        default:
            return std::make_unique<NgcLines>();
    }
}

}  // namespace curvecore::ref
