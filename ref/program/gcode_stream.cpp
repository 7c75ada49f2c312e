// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_stream.hpp"

#include "ref/program/input_error.hpp"

namespace curvecore::ref {

GcodeStream::GcodeStream(std::istream& text, const std::string& file, double fit_tolerance)
    : file_(file), lines_(text), interpreter_(file, fit_tolerance) {}

bool GcodeStream::next(Move& move) {
    while (moves_.empty() && !ended_) {
        try {
            read_block();
        } catch (const InputError&) {
            error_ = std::current_exception();
            ended_ = true;
            take(true);
        }
    }
    if (moves_.empty()) {
        if (error_) std::rethrow_exception(error_);
        return false;
    }
    move = moves_.front();
    moves_.pop_front();
    return true;
}

void GcodeStream::take(bool last) {
    const std::vector<Move> moves = interpreter_.take(last);
    moves_.insert(moves_.end(), moves.begin(), moves.end());
}

void GcodeStream::read_block() {
    const std::optional<std::string_view> line = lines_.next();
    bool ends = !line;
    if (line) {
        const Place place{file_, lines_.number()};
        const Block block(*line, place);
        if (block.percent && begun_) {
            if (!framed_) place.refuse("% ends a program that does not begin with %");
            ends = true;
        } else {
            framed_ = framed_ || block.percent;
            begun_ = begun_ || block.percent || !block.empty();
            ends = !block.percent && !interpreter_.execute(block, place);
        }
    }
    take(false);
    if (!ends) return;
    const Program rest = interpreter_.finish();
    moves_.insert(moves_.end(), rest.moves.begin(), rest.moves.end());
    aux_axes_ = rest.aux_axes;
    warnings_ = rest.warnings;
    ended_ = true;
}

}  // namespace curvecore::ref
