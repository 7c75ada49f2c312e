// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/window_motion.hpp"

#include <algorithm>

namespace curvecore::ref {

WindowMotion::WindowMotion(std::vector<Stretch> stretches, const Geometry& geometry,
                           const PieceGrid& grid, double last_dwell)
    : stretches_(std::move(stretches)), geometry_(&geometry), grid_(grid), last_dwell_(last_dwell) {
    double time = 0;
    for (Stretch& stretch : stretches_) {
        stretch.zones = {};
        stretch.caps = {};
        stretch.given = {};
        time += stretch.dwell;
        auto phase = stretch.phases.begin();
        long double place = 0;
        for (std::size_t i = stretch.first; i <= stretch.last; ++i) {
            for (; phase + 1 != stretch.phases.end() && (phase + 1)->s <= place; ++phase) {
                time += phase->duration;
            }
            const double t = time_at(*phase, 0, static_cast<double>(place));
            times_.push_back(time + t);
            speeds_.push_back(i == stretch.first ? 0 : phase->speed(t));
            place += length_of(geometry_->moves[i], grid_);
        }
        for (; phase != stretch.phases.end(); ++phase) time += phase->duration;
    }
    times_.push_back(time);
}

/// Calls visit(stretch, first, end, motion) for every stretch with moves from `first` up to `end`.
template <class Visit>
void WindowMotion::each_part(std::size_t first, std::size_t end, Visit visit) const {
    for (const Stretch& stretch : stretches_) {
        const std::size_t from = std::max(first, stretch.first);
        const std::size_t to = std::min(end, stretch.last + 1);
        if (from >= to) continue;
        visit(stretch, from, to,
              part_of(stretch.phases, place_of(*geometry_, stretch, from, grid_),
                      place_of(*geometry_, stretch, to, grid_)));
    }
}

bool WindowMotion::begins_move(std::size_t move) const {
    return move == 0 || geometry_->moves[move].move != geometry_->moves[move - 1].move;
}

void WindowMotion::append(std::size_t first, std::size_t end,
                          std::vector<ProfilePiece>& pieces) const {
    each_part(first, end,
              [&](const Stretch& stretch, std::size_t from, std::size_t to, const auto& motion) {
                  if (from == stretch.first) append_rest(stretch.dwell, grid_, pieces);
                  std::uint64_t length = 0;
                  for (std::size_t i = from; i < to; ++i) length += geometry_->moves[i].length;
                  append_run(motion, length, grid_, pieces);
              });
}

void WindowMotion::append_last_dwell(std::vector<ProfilePiece>& pieces) const {
    append_rest(last_dwell_, grid_, pieces);
}

std::vector<GivenRun> WindowMotion::given(std::size_t first, std::size_t end) const {
    std::vector<GivenRun> runs;
    each_part(
        first, end,
        [&](const Stretch& /*stretch*/, std::size_t from, std::size_t to, const auto& motion) {
            runs.push_back({to - from, motion});
        });
    return runs;
}

}  // namespace curvecore::ref
