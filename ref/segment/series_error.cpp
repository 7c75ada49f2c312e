// SPDX-License-Identifier: Apache-2.0
#include "ref/segment/series_error.hpp"

#include <cmath>
#include <mutex>
#include <optional>

#include "ref/bound/table_bound.hpp"
#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr double kSteepest = 1.9990234375;  // of the words' 2, in any word

/// The bound of the steepest line, since what its place on the path is off, a slope multiplies;
/// with half a bit more in each word, which all round the same way.
double bound(const CoreParameters& core, int k) {
    TableSegment segment;
    for (const auto& [place, row] : core.table->bus) {
        const int bits = core.coef_bits + core.table->rows.at(row).fraction;
        const double slope = bus_place(place).field == "tangent" ? kSteepest : 0;
        segment.values[row].fill(slope + std::ldexp(0.5, -bits));
    }
    segment.k = segment.lambda = k;
    return table_error(*core.table, core, segment).worst();
}

}  // namespace

double series_error(const CoreParameters& core, int k) {
    static std::mutex mutex;
    static CoreParameters of;
    static std::array<std::optional<double>, kMaxStepExponent + 1> known;
    const std::lock_guard<std::mutex> lock(mutex);
    if (!(of == core)) {
        of = core;
        known = {};
    }
    std::optional<double>& error = known.at(static_cast<std::size_t>(k));
    if (!error) error = bound(core, k);
    return *error;
}

int longest_series_step(const CoreParameters& core, double limit) {
    int k = kMaxStepExponent;
    while (k >= 0 && !(series_error(core, k) <= limit)) --k;
    return k;
}

}  // namespace curvecore::ref
