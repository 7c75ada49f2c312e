// SPDX-License-Identifier: Apache-2.0
#include "ref/moves/block_stream.hpp"

#include "ref/text/input_error.hpp"

namespace curvecore::ref {

bool BlockStream::next(Move& move) {
    const auto keep = [this](const std::vector<Move>& moves) {
        moves_.insert(moves_.end(), moves.begin(), moves.end());
    };
    while (moves_.empty() && !ended_) {
        try {
            ended_ = !read();
            keep(take(false));
            if (!ended_) continue;
            const Program rest = finish();
            keep(rest.moves);
            aux_axes_ = rest.aux_axes;
            warnings_ = rest.warnings;
        } catch (const InputError&) {
            error_ = std::current_exception();
            ended_ = true;
            keep(take(true));
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

}  // namespace curvecore::ref
