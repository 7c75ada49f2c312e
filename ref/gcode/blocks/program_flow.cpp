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
                         std::optional<Dialect> dialect)
    : file_(file), lines_(text, file, dialect), parameters_(parameters), runs_(1) {
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
    if (runs_.size() == 1) return;
    const Run& run = runs_.back();
    if (++blocks_without_move_ > kMostBlocksWithoutMove) {
        place().refuse(fmt::format("{} blocks without a move: does {} of line {} ever end?",
                                   kMostBlocksWithoutMove, run.word.name(), run.part.line()));
    }
    if (++blocks_again_ > kMostBlocksAgain) {
        place().refuse(fmt::format("{} blocks of loops and calls: does {} of line {} ever end?",
                                   kMostBlocksAgain, run.word.name(), run.part.line()));
    }
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
            const std::vector<double> values = arguments(word);
            return enter(run_of({Kind::kSub, word.label}), &values);
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
        const std::optional<OWord> found = word();
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

ProgramFlow::Run* ProgramFlow::running_sub() {
    auto run = runs_.rbegin();
    while (run->kind == Run::Kind::kLoop) ++run;
    return run->kind == Run::Kind::kProgram ? nullptr : &*run;
}

void ProgramFlow::define(const OWord& word) {
    arguments(word);
    Run& run = runs_.back();
    if (run.kind != Run::Kind::kProgram) {
        place().refuse(fmt::format("{} inside of {}: a sub is defined on its own", word.name(),
                                   run.word.name()));
    }
    const auto known = subs_.find(word.label);
    if (known == subs_.end()) {
        const KeptPart part = keep(word);
        subs_.emplace(word.label, part);
        return;
    }
    const KeptPart& sub = known->second;
    if (sub.text != run.text() || sub.begin != run.at - 1) {
        place().refuse(fmt::format("{} is there already, in line {}", word.name(), sub.line()));
    }
    run.at = sub.end;  // found by a call
}

void ProgramFlow::end_sub(const OWord& word) {
    Run* const sub = running_sub();
    const bool returns = word.kind == Kind::kReturn;  // whatever its label
    if (sub == nullptr || (!returns && sub->word.label != word.label)) {
        place().refuse(returns ? fmt::format("{} outside of a sub", word.name())
                               : fmt::format("{} outside of o{} sub", word.name(), word.label));
    }
    if (sub->kind == Run::Kind::kNumber) {
        place().refuse(
            fmt::format("{} where M98 has called {}: M99 ends it", word.name(), sub->word.name()));
    }
    if (word.kind == Kind::kEndsub && !sub->ifs.empty()) {
        place().refuse(
            fmt::format("{} within o{} if, which began in the sub", word.name(), sub->ifs.back()));
    }
    const std::vector<double> values = arguments(word);
    value_returned_ = !values.empty();
    value_ = value_returned_ ? values.front() : 0;
    leave_sub();
}

void ProgramFlow::enter(Run run, const std::vector<double>* arguments) {
    try {
        if (arguments != nullptr) {
            parameters_.enter(*arguments);
        } else {
            parameters_.enter_sharing();
        }
    } catch (const ParameterError& error) {
        place().refuse(fmt::format("{}: {} is called by itself?", error.what(), run.word.name()));
    }
    if (run.called_in == 0) run.called_in = place().program_line;
    run.at = run.part.begin + 1;
    runs_.push_back(std::move(run));
    on_call();
}

void ProgramFlow::leave_sub() {
    while (runs_.back().kind == Run::Kind::kLoop) runs_.pop_back();
    runs_.pop_back();
    parameters_.leave();
    on_return();
}

void ProgramFlow::call_number(int number, int times) {
    if (times == 0) return;
    Run run = run_of({Kind::kNumber, std::to_string(number)});
    run.left = times;
    enter(std::move(run), nullptr);
}

bool ProgramFlow::return_from_number() {
    Run* const sub = running_sub();
    if (sub == nullptr) return false;
    if (sub->kind == Run::Kind::kSub) {
        place().refuse(
            fmt::format("M99 in {}: o{} endsub ends it", sub->word.name(), sub->word.label));
    }
    Run again = *sub;
    leave_sub();
    if (--again.left > 0) enter(std::move(again), nullptr);
    return true;
}

/// Returns the sub, or the program of that number, that a call names.
ProgramFlow::Run ProgramFlow::run_of(const OWord& begin) {
    const bool sub = begin.kind == Kind::kSub;
    std::map<std::string, KeptPart>& known = sub ? subs_ : numbers_;
    if (known.count(begin.label) == 0) {
        const std::shared_ptr<const KeptText> file =
            file_of_sub(file_, begin.label, lines_.dialect());
        if (!file) keep_rest();
        std::optional<KeptPart> part = find_sub(file ? file : runs_[0].text(), begin, parameters_);
        if (!part) {
            place().refuse(file ? fmt::format("{} has no {}", file->file, begin.name())
                                : fmt::format("there is no {}: neither in this program nor in a "
                                              "file beside it",
                                              begin.name()));
        }
        known.emplace(begin.label, *part);
    }
    Run run;
    run.kind = sub ? Run::Kind::kSub : Run::Kind::kNumber;
    run.word = begin;
    run.part = known.at(begin.label);
    return run;
}

void ProgramFlow::keep_rest() {
    Run& program = runs_.front();
    if (program.text()) return;
    auto rest = std::make_shared<KeptText>(KeptText{file_, {}});
    while (std::optional<ProgramLine> line = lines_.next()) rest->lines.push_back(std::move(*line));
    program.part = {rest, 0, rest->lines.size()};
}

}  // namespace curvecore::ref
