// SPDX-License-Identifier: Apache-2.0
// The motion of a program or of a window of it: what was planned before is given, and where more
// follows the motion can be cut.
#pragma once

#include "ref/feed/window_motion.hpp"

namespace curvecore::ref {

class FeedWindow {
  public:
    /// @param given the motion of the first planned moves
    /// @param cut planned move before which there is no acceleration; 0: none yet
    FeedWindow(const FeedTask& task, const std::vector<GivenRun>& given, std::size_t cut);

    /// Plans by options.effort. Returns false if the given motion cannot be continued.
    bool plan();
    /// Makes the same motion with a cut, as far as the cut allows.
    bool cut_before(std::size_t cut);

    WindowMotion motion() const;

  private:
    bool plan_one(Stretch& stretch);
    bool pass_and_improve(Stretch& stretch);
    bool pass_cut(Stretch& stretch);
    bool keep_windows();
    void look_near_changes();
    template <class Cap>
    void lower(Stretch& stretch, Cap cap, Cap end) const;

    FeedTask task_;
    std::size_t cut_;
    StretchPlanner planner_;
    std::vector<Stretch> stretches_;
    std::size_t open_;             // the first planned move that is not given
    std::uint64_t given_end_ = 0;  // quanta
};

}  // namespace curvecore::ref
