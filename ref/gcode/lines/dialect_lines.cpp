// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/lines/dialect_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/gcode/lines/code_words.hpp"
#include "ref/gcode/lines/fanuc_lines.hpp"
#include "ref/gcode/lines/marlin_lines.hpp"
#include "ref/gcode/lines/program_lines.hpp"

namespace curvecore::ref {
namespace {

bool begins(std::string_view text, std::string_view with) {
    return text.substr(0, with.size()) == with;
}

class NgcLines : public DialectLines {
  public:
    void read(std::string_view text, ProgramLine& line, const Place& place) override {
        line.words = words_of(text, place);
        refuse_macro(line.words, place);
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
            line.words = words_of(text, place);
            return;
        }
        line.note = code.substr(0, code.find('='));
        line.waits = true;
        if (code.rfind("$J=", 0) == 0) line.warning = "a jog ($J) is not drawn";
    }
};

}  // namespace

void refuse_macro(std::string_view words, const Place& place) {
    if (begins(words, "/")) words.remove_prefix(1);
    if (begins(words, "N")) {
        words.remove_prefix(std::min(words.find_first_not_of("0123456789", 1), words.size()));
    }
    for (const std::string_view macro : {"IF[", "WHILE[", "GOTO", "G65P", "G66P"}) {
        if (!begins(words, macro)) continue;
        place.refuse(
            fmt::format("{}.. is of Fanuc's macros: O-words say the same, as o100 if [..] "
                        "and o100 call [..]",
                        macro));
    }
}

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
