// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_stream.hpp"

#include <algorithm>

namespace curvecore::ref {
namespace {

constexpr int kMostTimes = 1'000'000'000;

}  // namespace

GcodeStream::GcodeStream(std::istream& text, const std::string& file, double fit_tolerance)
    : file_(file),
      interpreter_(file_, fit_tolerance, parameters_),
      flow_(text, file_, parameters_) {}

bool GcodeStream::read() {
    const std::string* const words = flow_.next();
    if (words == nullptr) return false;
    const Place place = flow_.place();
    Block block(*words, place, parameters_);
    const std::optional<int> call = block.take_m({98, 99});
    if (!call) return interpreter_.execute(block, place);
    int number = 0;
    int times = 1;
    if (call == 98) {
        if (!block.has('P')) place.refuse("M98 without P, the number of a program");
        number = whole_number('P', block.take('P'), 0, kMostTimes, place);
        if (block.has('L')) times = whole_number('L', block.take('L'), 0, kMostTimes, place);
    }
    if (!interpreter_.execute(block, place)) return false;
    if (call == 99) return flow_.return_from_number();
    flow_.call_number(number, times);
    return true;
}

std::vector<Move> GcodeStream::take(bool last) {
    std::vector<Move> moves = interpreter_.take(last);
    if (!moves.empty()) flow_.moved();
    return moves;
}

}  // namespace curvecore::ref
