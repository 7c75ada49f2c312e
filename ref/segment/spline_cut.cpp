// SPDX-License-Identifier: Apache-2.0
#include "ref/segment/spline_cut.hpp"

#include <cstring>
#include <utility>

namespace curvecore::ref {
namespace {

// Cuts kept: those of a window of moves (PlanOptions) and of the group after it that is checked.
constexpr std::size_t kRecent = 4096;
constexpr std::size_t kRecentPieces = 8192;  // of them all: some megabytes

}  // namespace

std::size_t KnownCuts::Hash::operator()(const Key& key) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t word : key) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return hash;
}

const SplineCut& KnownCuts::of(const Cubic& cubic, const CoreParameters& format, double limit,
                               const Aux& aux_advance, int max_pieces, double least_last_step) {
    if (!(format == format_) || limit != limit_ || max_pieces != max_pieces_) {
        recent_.clear();
        before_.clear();
        recent_pieces_ = 0;
        format_ = format;
        limit_ = limit;
        max_pieces_ = max_pieces;
    }
    Key key;
    std::size_t next = 0;
    const auto add = [&](double number) { std::memcpy(&key[next++], &number, sizeof number); };
    for (const Vec3& term : {cubic.a, cubic.b, cubic.c, cubic.d}) {
        for (const double number : term) add(number);
    }
    for (const double number : aux_advance) add(number);
    add(least_last_step);

    const auto known = recent_.find(key);
    if (known != recent_.end()) return known->second;
    const auto old = before_.find(key);
    SplineCut cut = old != before_.end() ? std::move(old->second)
                                         : cut_spline(cubic, format, limit, aux_advance, max_pieces,
                                                      least_last_step);
    if (old != before_.end()) before_.erase(old);
    if (recent_.size() >= kRecent || recent_pieces_ >= kRecentPieces) {
        before_ = std::move(recent_);
        recent_.clear();
        recent_pieces_ = 0;
    }
    recent_pieces_ += cut.pieces.size();
    return recent_.emplace(key, std::move(cut)).first->second;
}

}  // namespace curvecore::ref
