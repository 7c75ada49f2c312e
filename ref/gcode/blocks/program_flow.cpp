// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/blocks/program_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace curvecore::ref {
namespace {

using Kind = OWord::Kind;

}  // namespace

ProgramFlow::ProgramFlow(std::istream& text, const std::string& file, ProgramParameters& parameters,
                         std::optional<Dialect> dialect, std::vector<std::string> folders)
    : stream_(text),
      file_(file),
      folders_(std::move(folders)),
      lines_(text, file, dialect),
      parameters_(parameters),
      runs_(1) {
    parameters_.compute("_value", [this] { return value_; });
    parameters_.compute("_value_returned", [this] { return value_returned_ ? 1 : 0; });
    parameters_.compute("_call_level", [this] { return parameters_.calls(); });
    parameters_.compute("_line", [this] { return line_.number; });
}

Place ProgramFlow::place() const {
    if (!text_) return {file_, line_.number};
    return {text_->file, line_.number,
            text_->file == file_ ? line_.number : runs_.back().called_in};
}

const ProgramLine* ProgramFlow::next() {
    while (true) {
        if (!fetch()) {
            const Run& run = runs_.back();
            if (run.kind != Run::Kind::kProgram) {
                refuse_unended(run.word, run.text()->place(run.part.begin));
            }
            if (!run.ifs.empty()) {
                place().refuse(fmt::format("the program ends within o{0} if: o{0} endif is missing",
                                           run.ifs.back()));
            }
            return nullptr;
        }
        count();
        if (obey_macro()) continue;
        const std::optional<OWord> found = word();
        if (!found) return &line_;
        obey(*found);
    }
}

/// Fetches the next line of what runs; returns false if there is none.
bool ProgramFlow::fetch() {
    Run& run = runs_.back();
    if (run.text()) {
        if (run.at == run.part.end) return false;
        line_ = run.text()->lines[run.at++];
    } else {
        std::optional<ProgramLine> line = lines_.next();
        if (!line) return false;
        line_ = std::move(*line);
    }
    text_ = run.text();
    return true;
}

void ProgramFlow::count() {
    const Run& run = runs_.back();
    const bool in_program = run.kind == Run::Kind::kProgram;
    if (in_program && goto_line_ == 0) return;
    const auto refuse = [&](int blocks, const char* which) {
        place().refuse(fmt::format("{} blocks {}: does {} of line {} ever end?", blocks, which,
                                   in_program ? "GOTO" : run.word.name(),
                                   in_program ? goto_line_ : run.part.line()));
    };
    if (++blocks_without_move_ > kMostBlocksWithoutMove) {
        refuse(kMostBlocksWithoutMove, "without a move");
    }
    if (++blocks_again_ > kMostBlocksAgain) refuse(kMostBlocksAgain, "of loops and calls");
}

std::optional<OWord> ProgramFlow::word() const {
    return read_o_word(line_.words, parameters_, place());
}

std::vector<double> ProgramFlow::arguments(const OWord& word) const {
    return o_word_arguments(word, line_.words, parameters_, place());
}

void ProgramFlow::obey(const OWord& word) {
    switch (word.kind) {
        case Kind::kNumber:
            arguments(word);
            if (const Run* sub = running_sub()) {
                place().refuse(fmt::format("o{} begins before the M99 of {}, which was called",
                                           word.label, sub->word.name()));
            }
            return;
        case Kind::kSub:
            return define(word);
        case Kind::kEndsub:
        case Kind::kReturn:
            return end_sub(word);
        case Kind::kCall: {
            std::vector<double> values = arguments(word);
            Run run = run_of({Kind::kSub, word.label});
            run.arguments = std::move(values);
            return enter(std::move(run));
        }
        case Kind::kIf:
            if (!is_true(word)) return skip_branches(word, false);
            runs_.back().ifs.push_back(word.label);
            return;
        case Kind::kElseif:
        case Kind::kElse:
        case Kind::kEndif:
            return end_branch(word);
        case Kind::kBreak:
        case Kind::kContinue:
            return leave_loop(word);
        case Kind::kEndwhile:
        case Kind::kEndrepeat:
            return repeat_loop(word);
        case Kind::kWhile:
        case Kind::kDo:
        case Kind::kRepeat:
            return in_loop(word) ? repeat_loop(word) : begin_loop(word);
    }
}

/// Ends a branch that was executed; the others of this if are skipped.
void ProgramFlow::end_branch(const OWord& word) {
    std::vector<std::string>& ifs = runs_.back().ifs;
    if (ifs.empty() || ifs.back() != word.label) {
        place().refuse(fmt::format("{} without o{} if", word.name(), word.label));
    }
    ifs.pop_back();
    if (word.kind != Kind::kEndif) skip_branches(word, true);
}

/// Skips to the branch to be executed, or behind the endif. `done`: one of them was executed.
void ProgramFlow::skip_branches(const OWord& begin, bool done) {
    const int line = line_.number;
    while (fetch()) {
        const std::optional<OWord> found = read_o_word_ahead(line_.words, parameters_, place());
        if (!found || found->label != begin.label || of_subs(found->kind)) continue;
        const bool branch = found->kind == Kind::kElse || found->kind == Kind::kElseif;
        if (found->kind == Kind::kEndif) return;
        if (!branch) {
            place().refuse(fmt::format("{} inside of o{} if: give it another number", found->name(),
                                       begin.label));
        }
        if (!done && (found->kind == Kind::kElse || is_true(*found))) {
            runs_.back().ifs.push_back(begin.label);
            return;
        }
    }
    Place{text_ ? text_->file : file_, line}.refuse(
        fmt::format("{} lacks its o{} endif", begin.name(), begin.label));
}

/// Returns true if the word is the innermost loop's own, at its begin or its end.
bool ProgramFlow::in_loop(const OWord& word) const {
    const Run& run = runs_.back();
    return run.kind == Run::Kind::kLoop && run.word.label == word.label &&
           (run.word.kind == word.kind || last_of(run.word).kind == word.kind);
}

void ProgramFlow::begin_loop(const OWord& word) {
    Run loop;
    loop.kind = Run::Kind::kLoop;
    loop.word = word;
    loop.called_in = runs_.back().called_in;
    if (word.kind == Kind::kRepeat) {
        loop.left =
            static_cast<int>(std::clamp(std::floor(arguments(word).front() + 0.5), 0.0, 2e9));
    }
    loop.part = keep(word);
    loop.at = loop.part.begin + (word.kind == Kind::kWhile ? 0 : 1);
    if (loop.left > 0) runs_.push_back(std::move(loop));
}

/// Keeps the loop or sub that begins with the current line; execution continues behind it.
KeptPart ProgramFlow::keep(const OWord& begin) {
    Run& outer = runs_.back();
    if (outer.text()) {
        const KeptText& text = *outer.text();
        const std::size_t first = outer.at - 1;
        while (outer.at < outer.part.end) {
            const std::optional<OWord> found = text.word(outer.at, parameters_);
            if (found && ends(begin, *found, text.place(outer.at))) {
                return {outer.text(), first, ++outer.at};
            }
            ++outer.at;
        }
        refuse_unended(begin, text.place(first));
    }
    auto text = std::make_shared<KeptText>(KeptText{file_, {line_}});
    while (std::optional<ProgramLine> line = lines_.next()) {
        text->lines.push_back(std::move(*line));
        const std::size_t last = text->lines.size() - 1;
        const std::optional<OWord> found = text->word(last, parameters_);
        if (found && ends(begin, *found, text->place(last))) return {text, 0, last + 1};
    }
    refuse_unended(begin, text->place(0));
}

void ProgramFlow::repeat_loop(const OWord& word) {
    Run& run = runs_.back();
    if (!in_loop(word)) {
        place().refuse(fmt::format("{} without its loop", word.name()));
    }
    if (!run.ifs.empty()) {
        place().refuse(
            fmt::format("{} within o{} if, which began in the loop", word.name(), run.ifs.back()));
    }
    bool again = false;
    if (word.kind == Kind::kEndwhile) {
        run.at = run.part.begin;
        return;
    }
    if (word.kind == Kind::kWhile) {
        again = is_true(word);
    } else {
        arguments(word);
        again = --run.left > 0;
    }
    if (!again) {
        runs_.pop_back();
    } else if (word.kind != run.word.kind) {
        run.at = run.part.begin + 1;
    }
}

void ProgramFlow::leave_loop(const OWord& word) {
    arguments(word);
    auto run = runs_.rbegin();
    while (run->kind == Run::Kind::kLoop && run->word.label != word.label) ++run;
    if (run->kind != Run::Kind::kLoop) {
        place().refuse(fmt::format("{} outside of a loop o{}", word.name(), word.label));
    }
    runs_.erase(run.base(), runs_.end());
    if (word.kind == Kind::kBreak) {
        runs_.pop_back();
    } else {
        runs_.back().ifs.clear();
        runs_.back().at = runs_.back().part.end - 1;
    }
}

}  // namespace curvecore::ref
