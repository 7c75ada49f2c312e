// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_stream.hpp"

#include <fmt/format.h>

namespace curvecore::ref {
namespace {

constexpr int kMostTimes = 1'000'000'000;

}  // namespace

GcodeStream::GcodeStream(std::istream& text, const std::string& file, const GcodeOptions& options)
    : file_(file),
      recognised_(!options.dialect),
      interpreter_(file_, options.fit_tolerance, parameters_, options.start),
      flow_(text, file_, parameters_, options.dialect) {
    flow_.on_call = [this] { kept_.emplace_back(); };
    flow_.on_return = [this] { end_call(); };
}

bool GcodeStream::read() {
    const ProgramLine* const line = flow_.next();
    if (line == nullptr) return false;
    const Place place = flow_.place();
    if (!line->warning.empty()) interpreter_.warn(line->warning, place);
    if (!line->note.empty()) {
        interpreter_.note(line->note, line->waits, place);
        return true;
    }
    Block block(line->words, place, parameters_);
    if (const std::optional<int> code = block.take_m({70, 71, 72, 73})) keep_modes(*code, place);
    const std::optional<int> call = block.take_m({98, 99});
    if (!call) return interpreter_.execute(block, place);
    int number = 0;
    int times = 1;
    if (call == 98) {
        if (!block.has('P')) place.refuse("M98 without P, the number of a program");
        number = whole_number('P', block.take('P'), 0, kMostTimes, place);
        if (block.has('L')) times = whole_number('L', block.take('L'), 0, kMostTimes, place);
    }
    if (call == 99 && block.has('P')) {
        place.refuse("M99 with P would go on at another block: a call returns to its own");
    }
    if (!interpreter_.execute(block, place)) return false;
    if (call == 99) return flow_.return_from_number();
    flow_.call_number(number, times);
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
