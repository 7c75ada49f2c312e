// SPDX-License-Identifier: Apache-2.0
#include "ref/program/gcode_stream.hpp"

namespace curvecore::ref {

bool GcodeStream::read() {
    const std::optional<std::string_view> line = lines_.next();
    if (!line) return false;
    const Place place{file_, lines_.number()};
    const Block block(words_of(*line, place), place, parameters_);
    if (block.percent && begun_) {
        if (!framed_) place.refuse("% ends a program that does not begin with %");
        return false;
    }
    framed_ = framed_ || block.percent;
    begun_ = begun_ || block.percent || !block.empty();
    return block.percent || interpreter_.execute(block, place);
}

}  // namespace curvecore::ref
