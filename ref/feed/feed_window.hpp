// SPDX-License-Identifier: Apache-2.0
// The motion of a program or of a window of it: what was planned before is given, and where more
// follows the motion can be cut.
#pragma once

#include "ref/feed/window_motion.hpp"

namespace curvecore::ref {

class FeedWindow {
  public:
    /// @param slowed each planned move, for the core's queues; both outlive the window
    /// @param cut planned move before which there is no acceleration; 0: none yet
    FeedWindow(const FeedTask& task, const std::vector<Slowed>& slowed, std::size_t cut);

    /// Makes the motion from the stretches, by options.effort, within limits over windows of time.
    /// Returns false if the given motion cannot be continued.
    bool solve();
    /// Makes it again with a cut, as far as the cut allows.
    bool cut_before(std::size_t cut);

    WindowMotion motion() const;
    /// Returns the same motion at 1 / `factor` of its speed.
    WindowMotion slower_motion(double factor) const;

  private:
    bool solve(Stretch& stretch);
    bool pass_cut(Stretch& stretch);
    bool keep_windows();
    void look_near_changes();
    template <class Cap>
    void lower(Stretch& stretch, Cap cap, Cap end) const;

    const FeedTask& task_;
    std::size_t cut_;
    StretchSolver solver_;
    std::vector<Stretch> stretches_;
    std::size_t open_;             // the first planned move that is not given
    std::uint64_t given_end_ = 0;  // quanta
};

}  // namespace curvecore::ref
