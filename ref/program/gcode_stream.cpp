// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_stream.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace curvecore::ref {
namespace {

constexpr int kMostTimes = 1'000'000'000;
/// Letters of G65's arguments: #1 is A, #26 is Z.
constexpr std::string_view kArguments = "ABCIJKDEF H M   QRSTUVWXYZ";

/// Takes G65's words out of the block; returns them as #1 .. #30.
std::vector<double> macro_arguments(Block& block) {
    std::vector<double> arguments(ProgramParameters::kArguments, 0.0);
    for (std::size_t i = 0; i < kArguments.size(); ++i) {
        const char letter = kArguments[i];
        if (letter != ' ' && letter != 'M' && block.has(letter)) arguments[i] = block.take(letter);
        if (letter != 'M' || block.m.empty()) continue;
        arguments[i] = block.m.front();
        block.m.clear();
    }
    return arguments;
}

}  // namespace

GcodeStream::GcodeStream(std::istream& text, const std::string& file, const GcodeOptions& options)
    : file_(file),
      recognised_(!options.dialect),
      interpreter_(file_, options.fit_tolerance, parameters_, options.start, options.table.get()),
      flow_(text, file_, parameters_, options.dialect, options.start.folders) {
    const ProgramStart& start = options.start;
    if (!start.startup.empty()) {
        const Place place{start.ini, start.startup_line};
        interpreter_.execute({words_of(start.startup, place), place, parameters_}, place);
    }
    flow_.on_call = [this] { kept_.emplace_back(); };
    flow_.on_return = [this] { end_call(); };
}

bool GcodeStream::read() {
    const ProgramLine* const line = flow_.next();
    if (line == nullptr) return false;
    const Place place = flow_.place();
    if (!line->warning.empty()) interpreter_.warn(line->warning, place);
    if (line->curve) interpreter_.name_curve(*line->curve, place);
    if (!line->note.empty()) {
        interpreter_.note(line->note, line->waits, place);
        return true;
    }
    Block block(line->words, place, parameters_);
    if (const std::optional<int> code = block.take_m({70, 71, 72, 73})) keep_modes(*code, place);
    const bool macro = block.take_g(650);
    const std::optional<int> call = block.take_m({98, 99});
    if (!call && !macro) return interpreter_.execute(block, place);
    const char* const name = macro ? "G65" : "M98";
    std::optional<int> number;
    int times = 1;
    if (block.has('P')) number = whole_number('P', block.take('P'), 0, kMostTimes, place);
    if (call == 99) {
        return interpreter_.execute(block, place) && flow_.return_from_number(number);
    }
    if (!number) place.refuse(fmt::format("{} without P, the number of a program", name));
    if (block.has('L')) times = whole_number('L', block.take('L'), 0, kMostTimes, place);
    std::optional<std::vector<double>> arguments;
    if (macro) arguments = macro_arguments(block);
    if (!interpreter_.execute(block, place)) return false;
    flow_.call_number(*number, times, std::move(arguments));
    return true;
}

/// Executes M70 save, M71 forget, M72 restore, M73 save and restore when the call returns.
void GcodeStream::keep_modes(int code, const Place& place) {
    Kept& kept = kept_.back();
    if (code == 72) {
        if (!kept.state) place.refuse("M72 without M70 or M73 in this sub, or in the program");
        interpreter_.restore(*kept.state);
    } else {
        kept.restores = code == 73;
        kept.state.reset();
        if (code != 71) kept.state = interpreter_.state();
    }
}

void GcodeStream::end_call() {
    const Kept kept = kept_.back();
    kept_.pop_back();
    if (kept.restores && kept.state) interpreter_.restore(*kept.state);
}

Program GcodeStream::finish() {
    Program rest = interpreter_.finish();
    if (recognised_ && flow_.dialect() != Dialect::kLinuxcnc) {
        rest.warnings.insert(rest.warnings.begin(),
                             fmt::format("{}: warning: read as G-code of {}, which its first lines "
                                         "are of; --dialect names another",
                                         file_, name_of(flow_.dialect())));
    }
    return rest;
}

std::vector<Move> GcodeStream::take(bool last) {
    std::vector<Move> moves = interpreter_.take(last);
    if (!moves.empty()) flow_.moved();
    return moves;
}

}  // namespace curvecore::ref
