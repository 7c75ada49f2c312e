// SPDX-License-Identifier: Apache-2.0
// Subs and programs of a number: their calls, and their ends.
#include <fmt/format.h>

#include <utility>

#include "ref/gcode/blocks/program_flow.hpp"

namespace curvecore::ref {
namespace {

using Kind = OWord::Kind;

}  // namespace

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
    if (!run.text() || sub.text->file != file_ || sub.line() != line_.number) {
        place().refuse(fmt::format("{} is there already, in line {}", word.name(), sub.line()));
    }
    run.at += sub.end - sub.begin - 1;  // found by a call
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

void ProgramFlow::enter(Run run) {
    try {
        if (run.arguments) {
            parameters_.enter(*run.arguments);
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

void ProgramFlow::call_number(int number, int times, std::optional<std::vector<double>> arguments) {
    if (times == 0) return;
    Run run = run_of({Kind::kNumber, std::to_string(number)});
    run.left = times;
    run.arguments = std::move(arguments);
    enter(std::move(run));
}

bool ProgramFlow::return_from_number(std::optional<int> line) {
    Run* const sub = running_sub();
    if (sub == nullptr) {
        if (line) go_to(*line);
        return line.has_value();
    }
    if (sub->kind == Run::Kind::kSub) {
        place().refuse(
            fmt::format("M99 in {}: o{} endsub ends it", sub->word.name(), sub->word.label));
    }
    Run again = *sub;
    leave_sub();
    if (line) {
        go_to(*line);
    } else if (--again.left > 0) {
        enter(std::move(again));
    }
    return true;
}

/// Returns the sub, or the program of that number, that a call names.
ProgramFlow::Run ProgramFlow::run_of(const OWord& begin) {
    const bool sub = begin.kind == Kind::kSub;
    std::map<std::string, KeptPart>& known = sub ? subs_ : numbers_;
    if (known.count(begin.label) == 0) {
        const std::shared_ptr<const KeptText> file =
            file_of_sub(file_, folders_, begin.label, lines_.dialect());
        if (!file) keep_rest();
        std::optional<KeptPart> part = find_sub(file ? file : runs_[0].text(), begin, parameters_);
        if (!part) {
            place().refuse(file ? fmt::format("{} has no {}", file->file, begin.name())
                                : fmt::format("there is no {}: neither in this program nor in a "
                                              "file beside it{}",
                                              begin.name(),
                                              folders_.empty() ? "; --machine FILE.ini names more "
                                                                 "folders (SUBROUTINE_PATH)"
                                                               : ", nor in the .ini's folders"));
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
