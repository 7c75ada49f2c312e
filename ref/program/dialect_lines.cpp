// SPDX-License-Identifier: Apache-2.0
#include "ref/program/dialect_lines.hpp"

#include "ref/program/code_words.hpp"
#include "ref/program/fanuc_lines.hpp"
#include "ref/program/marlin_lines.hpp"
#include "ref/program/program_lines.hpp"

namespace curvecore::ref {
namespace {

class NgcLines : public DialectLines {
  public:
    void read(std::string_view text, ProgramLine& line, const Place& place) override {
        line.words = words_of(text, place);
        if (!line.words.empty() && line.words[0] == '$') {
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
