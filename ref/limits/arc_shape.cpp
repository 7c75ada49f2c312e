// SPDX-License-Identifier: Apache-2.0
#include "ref/limits/arc_shape.hpp"

#include <algorithm>

#include "ref/limits/limits.hpp"

namespace curvecore::ref {
namespace {

constexpr int kPoints = 4;  // points of a stretch besides its end

class ArcStretcher {
  public:
    ArcStretcher(const Move& move, const Machine& machine) : move_(move), machine_(machine) {}

    void stretch(double from, double to) {
        const PathShape shape = path_shape(move_, from, to);
        double best = 0;
        for (int i = 0; i <= kPoints; ++i) {
            const double at = from + (to - from) * i / kPoints;
            best = std::max(best, speed(path_shape(move_, at, at)));
        }
        if (speed(shape) >= kLeastShare * best) {
            stretches.push_back({from, to, shape});
            return;
        }
        const double middle = (from + to) / 2;
        stretch(from, middle);
        stretch(middle, to);
    }

    std::vector<ArcStretch> stretches;

  private:
    double speed(const PathShape& shape) const {
        const double v = top_speed(shape, machine_);
        return move_.rapid || move_.feed <= 0 ? v : std::min(v, move_.feed / shape.rate);
    }

    const Move& move_;
    const Machine& machine_;
};

}  // namespace

std::vector<ArcStretch> arc_stretches(const Move& move, const Machine& machine) {
    ArcStretcher stretcher(move, machine);
    stretcher.stretch(0, 1);
    return std::move(stretcher.stretches);
}

}  // namespace curvecore::ref
