// SPDX-License-Identifier: Apache-2.0
// A plan drawn by the path's kernel, tick by tick, and its limits over windows.
#pragma once

#include "hls/path_kernel.hpp"
#include "tb/support/judge/drawn_limits.hpp"

namespace curvecore::tb {

class TickRun {
  public:
    TickRun(const ref::Plan& plan, const ref::Machine& machine)
        : plan_(plan),
          cursor_(plan),
          meter_(machine, plan.unit_mm, plan.tick_s, 1, 3 + plan.aux_axes, 0, kManyWindows) {
        take();
    }

    /// Returns true while pieces are left.
    bool active() const { return next_ == 0 || kernel_.active(); }

    std::size_t begun() const { return next_; }      // pieces
    std::uint64_t s() const { return cursor_.s(); }  // quanta of the path

    /// Draws a tick at a rate of time, 2^16 = 1.
    void tick(std::int32_t rate, bool hold = false) {
        const auto feed = [this](hls::ProfileWords& words) {
            if (next_ == plan_.pieces.size()) return false;
            words = hls::to_words(plan_.pieces[next_++]);
            return true;
        };
        cursor_.advance(static_cast<std::uint64_t>(hls::to_int(kernel_.tick(rate, feed, hold))));
        take();
    }

    sysc::LimitLoads finish() { return meter_.finish(); }

  private:
    void take() {
        const ref::Vec3 point = curve_.on(cursor_.segment()).position(cursor_.local());
        meter_.take(ref::exact_point(cursor_.segment(), point, cursor_.local()), cursor_.index());
    }

    const ref::Plan& plan_;
    hls::PathKernel kernel_;
    sysc::PathCursor cursor_;
    ref::CurveFollower curve_;
    sysc::LimitMeter meter_;
    std::size_t next_ = 0;
};

}  // namespace curvecore::tb
