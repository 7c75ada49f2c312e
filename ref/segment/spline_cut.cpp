// SPDX-License-Identifier: Apache-2.0
#include "ref/segment/spline_cut.hpp"

#include <cstring>
#include <utility>

namespace curvecore::ref {
namespace {

// Cuts kept: those of a window of moves (PlanOptions) and of what is checked behind it.
constexpr std::size_t kRecent = 5120;
constexpr std::size_t kRecentPieces = 10240;  // of them all: some megabytes

}  // namespace

std::size_t KnownCuts::Hash::operator()(const Key& key) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t word : key) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return hash;
}

std::size_t KnownCuts::size() const {
    const std::lock_guard lock(mutex_);
    return recent_.size() + before_.size();
}

/// Forgets cuts of another core or limit.
void KnownCuts::use(const CoreParameters& format, double limit, int max_pieces) {
    if (format == format_ && limit == limit_ && max_pieces == max_pieces_) return;
    recent_.clear();
    before_.clear();
    recent_pieces_ = 0;
    format_ = format;
    limit_ = limit;
    max_pieces_ = max_pieces;
}

/// Returns null if it is not kept.
SharedCut KnownCuts::known(const Key& key) {
    const auto recent = recent_.find(key);
    if (recent != recent_.end()) return recent->second;
    const auto old = before_.find(key);
    if (old == before_.end()) return {};
    SharedCut cut = old->second;
    before_.erase(old);
    keep(key, cut);
    return cut;
}

void KnownCuts::keep(const Key& key, const SharedCut& cut) {
    if (recent_.size() >= kRecent || recent_pieces_ >= kRecentPieces) {
        before_ = std::move(recent_);
        recent_.clear();
        recent_pieces_ = 0;
    }
    if (recent_.emplace(key, cut).second) recent_pieces_ += cut->pieces.size();
}

SharedCut KnownCuts::of(const Cubic& cubic, const CoreParameters& format, double limit,
                        const Aux& aux_advance, int max_pieces, double least_last_step) {
    Key key;
    std::size_t next = 0;
    const auto add = [&](double number) { std::memcpy(&key[next++], &number, sizeof number); };
    for (const Vec3& term : {cubic.a, cubic.b, cubic.c, cubic.d}) {
        for (const double number : term) add(number);
    }
    for (const double number : aux_advance) add(number);
    add(least_last_step);
    {
        const std::lock_guard lock(mutex_);
        use(format, limit, max_pieces);
        if (SharedCut cut = known(key)) return cut;
    }
    // Other threads need not wait for it, though two may cut the same cubic.
    auto cut = std::make_shared<const SplineCut>(
        cut_spline(cubic, format, limit, aux_advance, max_pieces, least_last_step));
    const std::lock_guard lock(mutex_);
    use(format, limit, max_pieces);
    keep(key, cut);
    return cut;
}

}  // namespace curvecore::ref
