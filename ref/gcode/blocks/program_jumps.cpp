// SPDX-License-Identifier: Apache-2.0
// Conditions and jumps of Fanuc's macros: IF [..] GOTO, IF [..] THEN, GOTO.
#include <fmt/format.h>

#include <utility>

#include "ref/gcode/blocks/program_flow.hpp"
#include "ref/gcode/blocks/value_reader.hpp"
#include "ref/gcode/lines/macro_lines.hpp"

namespace curvecore::ref {

/// Executes a statement; returns false if a block is left of the line, as behind IF [..] THEN.
bool ProgramFlow::obey_macro() {
    const std::size_t begin = begin_of_words(line_.words);
    const bool asks = line_.words.compare(begin, 3, "IF[") == 0;
    if (!asks && line_.words.compare(begin, 4, "GOTO") != 0) return false;
    const std::string text = line_.words.substr(begin);
    const Place here = place();
    ValueReader reader(text, parameters_, here);
    const bool holds = !reader.take("IF") || reader.value("IF") != 0;
    if (asks && reader.take("THEN")) {
        if (!holds) return true;
        line_.words = reader.rest();
        return obey_macro();
    }
    if (!reader.take("GOTO")) {
        reader.refuse("IF [..] wants GOTO or THEN; o100 if [..] begins lines of its own");
    }
    const int number = reader.whole_value("GOTO");
    if (!reader.at_end()) reader.refuse(fmt::format("'{}' behind GOTO's number", reader.peek()));
    if (holds) go_to(number);
    return true;
}

void ProgramFlow::go_to(int number) {
    const Place here = place();
    goto_line_ = here.program_line;
    while (runs_.back().kind == Run::Kind::kLoop) runs_.pop_back();
    runs_.back().ifs.clear();
    const bool all = runs_.back().kind != Run::Kind::kProgram || keep_all();
    if (find_line(number)) return;
    here.refuse(fmt::format("GOTO {0}: no line N{0} in this program{1}", number,
                            all ? "" : " further on; to go back it must be a file"));
}

/// Makes the line of that number the next one, further on or else from the program's begin.
bool ProgramFlow::find_line(int number) {
    Run& run = runs_.back();
    const std::vector<ProgramLine>& lines = run.text()->lines;
    const auto is_program = [&](std::size_t at) {
        const std::optional<OWord> found = run.text()->word(at, parameters_);
        return found && found->kind == OWord::Kind::kNumber;
    };
    for (std::size_t at = run.at; at < run.part.end && !is_program(at); ++at) {
        if (number_of_line(lines[at].words) != number) continue;
        run.at = at;
        return true;
    }
    bool found = false;
    for (std::size_t at = run.at; at > run.part.begin; --at) {
        if (number_of_line(lines[at - 1].words) == number) {
            run.at = at - 1;
            found = true;
        }
        if (is_program(at - 1)) break;
    }
    return found;
}

/// Keeps all of the program's text; returns false if its stream cannot go back: its rest alone.
bool ProgramFlow::keep_all() {
    Run& program = runs_.front();
    if (all_kept_) return true;
    const std::streampos begin = 0;
    if (stream_.rdbuf()->pubseekpos(begin, std::ios::in) != begin) {
        keep_rest();
        return false;
    }
    const KeptText* const kept = program.text().get();
    const bool in_kept = kept != nullptr && program.at < kept->lines.size();
    const int last = in_kept ? kept->lines[program.at].number - 1 : lines_.number();
    auto all = std::make_shared<KeptText>(KeptText{file_, {}});
    ProgramLines lines(stream_, file_, lines_.dialect());
    while (std::optional<ProgramLine> line = lines.next()) {
        if (line->number <= last) program.at = all->lines.size() + 1;
        all->lines.push_back(std::move(*line));
    }
    program.part = {all, 0, all->lines.size()};
    all_kept_ = true;
    return true;
}

}  // namespace curvecore::ref
