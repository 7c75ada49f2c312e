// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/stops/planned_branches.hpp"

#include <algorithm>
#include <cmath>

#include "ref/feed/stops/queue_cover.hpp"
#include "ref/feed/stops/stop_branch.hpp"
#include "ref/format/path_words.hpp"
#include "ref/numeric/unlimited.hpp"

namespace curvecore::ref {
namespace {

// Distances between branches: some tenth of a stop from full speed; or this little path, while the
// stop, a short one then, does not get long by it.
constexpr double kApartTime = 24e-3;     // s
constexpr double kSlowApartTime = 0.15;  // s
constexpr double kApartPath = 0.5;       // mm
constexpr double kSpareShare = 0.05;     // share of a queue for what is not sent steadily:
constexpr double kCutWords = 112;        // branches that are cut at its ends, and closer ones

class BranchPlanner {
  public:
    BranchPlanner(const Program& program, const Machine& machine, const Geometry& geometry,
                  const PlanOptions& options, const Plan& plan)
        : course_(program, machine, geometry, plan, kStopShare),
          reach_(static_cast<double>(stop_reach(machine, plan.tick_s))),
          distance_(longest_piece({machine, plan.unit_mm, plan.tick_s})),
          most_spare_(std::max(0.0, kSpareShare * covered_words(options) - kCutWords)),
          spare_(most_spare_),
          words_per_tick_(std::max(0.0, 1 - (kCutWords + most_spare_) / covered_words(options)) *
                          covered_words(options, plan)),
          branch_steps_(static_cast<std::size_t>(options.core.branch_steps)) {
        std::uint64_t start = 0;
        std::uint64_t s = 0;
        for (const ProfilePiece& piece : plan.pieces) {
            // A piece begins in the tick that ends there, the first one in its own first tick.
            due_.push_back(start + kStopLead - (start > 0 ? 1 : 0));
            path_.push_back(s);
            start += piece.ticks;
            s += piece.ds;
        }
        end_ = start;
    }

    void add(const PieceStretch& stretch) {
        course_.add(stretch);
        find_until(course_.cells().back().from - reach_);
    }
    std::vector<PlannedBranch> finish() {
        find_until(kUnlimited);
        return std::move(branches_);
    }

    /// Sets the ticks from each branch in which the next one, or the end, comes; none if that is
    /// too far, or if its stop then takes more than `most` ticks of the profile.
    void set_waits(double most, std::vector<PlannedBranch>& branches) const {
        for (std::size_t i = 0; i < branches.size(); ++i) {
            const bool last = i + 1 == branches.size();
            const std::uint64_t next = last ? end_ : due_[branches[i + 1].piece];
            const std::uint64_t gap = next - due_[branches[i].piece];
            // A branch that passes at another rate is reported up to kStopLead ticks after its
            // place.
            const std::uint64_t wait = gap + kStopLead;
            const double stop = last ? 0 : ticks_passed(branches[i + 1].steps);
            const bool far = gap > distance_.slow_ticks || static_cast<double>(wait) + stop > most;
            branches[i].wait = far ? kNoWait : static_cast<std::uint32_t>(wait);
        }
    }

  private:
    /// Looks for a branch as far as the course is known up to this tick: before the last piece that
    /// is near enough and leaves the core the time to load it, else before the next one.
    void find_until(double tick) {
        while (next_ < due_.size() && due_[next_] < end_) {
            const std::size_t first = next_;
            std::size_t piece = first;
            while (piece + 1 < due_.size() && near(piece + 1)) ++piece;
            if (static_cast<double>(due_[piece]) > tick) return;
            next_ = piece + 1;
            if (!carried(piece)) continue;
            StopSteps steps = steps_before(piece);
            for (; piece > first && !loaded(piece, steps.size()); steps = steps_before(piece)) {
                --piece;
            }
            if (steps.empty() || !loaded(piece, steps.size()) || !carried(piece)) continue;
            spare_ = std::min(most_spare_, spare_at(piece));
            branches_.push_back({piece, 1, std::move(steps)});
            next_ = piece + 1;
            while (next_ < due_.size() && due_[next_] <= due_[piece] + kStopLead) ++next_;
        }
    }

    bool near(std::size_t piece) const {
        if (branches_.empty() || due_[piece] >= end_) return false;
        const std::size_t last = branches_.back().piece;
        return distance_.holds(due_[piece] - due_[last], path_[piece] - path_[last]);
    }

    /// Returns the words of the queue that are left for closer branches: from branch to branch the
    /// words are at most those that it carries steadily, and most_spare_.
    double spare_at(std::size_t piece) const {
        if (branches_.empty()) return most_spare_;
        const PlannedBranch& last = branches_.back();
        const double words = static_cast<double>(branch_words(last)) +
                             kProfileBusWords * static_cast<double>(piece - last.piece);
        return spare_ + words_per_tick_ * static_cast<double>(due_[piece] - due_[last.piece]) -
               words;
    }
    /// Returns true if the queue carries the words since then.
    bool carried(std::size_t piece) const { return spare_at(piece) >= 0; }

    /// Returns true if the core loads so many steps, and what stands before and behind them, in the
    /// ticks of the piece before.
    bool loaded(std::size_t piece, std::size_t steps) const {
        constexpr std::size_t kOthers = 3;  // ticks: the stop, the piece, a queue that begins anew
        if (branch_steps_ == 0 || piece == 0) return true;
        return steps / branch_steps_ + 1 + kOthers <= due_[piece] - due_[piece - 1];
    }

    StopSteps steps_before(std::size_t piece) {
        const auto due = static_cast<double>(due_[piece]);
        if (!branches_.empty()) {
            const PlannedBranch& last = branches_.back();
            const auto before = static_cast<double>(due_[last.piece]);
            course_.forget_before(before);
            if (course_.even(before, due + ticks_passed(last.steps) + 1)) return last.steps;
        }
        return stop_steps(course_, due_[piece]);
    }

    ProfileCourse course_;
    double reach_;
    Reach distance_;
    double most_spare_;  // words
    double spare_;       // behind the last branch
    double words_per_tick_;
    std::size_t branch_steps_;
    std::vector<std::uint64_t> due_;   // ticks, of the pieces
    std::vector<std::uint64_t> path_;  // quanta, before them
    std::uint64_t end_ = 0;
    std::size_t next_ = 0;  // piece that may have a branch
    std::vector<PlannedBranch> branches_;
};

}  // namespace

Reach longest_piece(const PieceGrid& grid) {
    constexpr std::uint64_t kLeast = kStopLead + 1;  // ticks
    const auto ticks = [&](double time) {
        return std::max(kLeast, static_cast<std::uint64_t>(std::floor(time / grid.tick)));
    };
    return {ticks(kApartTime), ticks(kSlowApartTime),
            static_cast<std::uint64_t>(kApartPath / grid.quantum), kLeast};
}

bool carries_branches(const Machine& machine, const PlanOptions& options, const Plan& plan) {
    const Reach longest = longest_piece({machine, plan.unit_mm, plan.tick_s});
    return covered_words(options, plan) * static_cast<double>(longest.slow_ticks) >=
           kProfileBusWords;
}

double ticks_passed(const StopSteps& steps) {
    double sum = 0;
    double rate = 1;
    double slope = 0;
    for (const StopStep& step : steps) {
        const double n = step.ticks;
        const double change = std::ldexp(step.change, -32);
        sum += n * rate + n * (n + 1) / 2 * (slope + change * (n + 2) / 3);
        rate += n * slope + n * (n + 1) / 2 * change;
        slope += n * change;
    }
    return sum;
}

void set_branches(const Program& program, const Machine& machine, const Geometry& geometry,
                  const PlanOptions& options, Plan& plan) {
    BranchPlanner planner(program, machine, geometry, options, plan);
    const PieceGrid grid(machine, plan.unit_mm, plan.tick_s);
    walk_pieces(plan, geometry, grid, [&](const PieceStretch& stretch) { planner.add(stretch); });
    plan.branches = planner.finish();
    drop_uncovered(options, plan);
    const double most = plan.stop_ticks;
    planner.set_waits(most, plan.branches);
    // A machine that stops at once would stop later if it waited for a branch.
    const auto waits = [&](const PlannedBranch& branch) { return branch.wait != kNoWait; };
    if (std::none_of(plan.branches.begin(), plan.branches.end(), waits) ||
        kStopLead + ticks_passed(plan.branches.front().steps) > most) {
        plan.branches.clear();
    }
}

std::size_t profile_words(const Plan& plan) {
    std::size_t words = kProfileBusWords * plan.pieces.size();
    const PlannedBranch* before = nullptr;
    for (const PlannedBranch& branch : plan.branches) {
        words += branch_words(branch, before);
        before = &branch;
    }
    return words;
}

std::uint64_t longest_stop(const Plan& plan) {
    std::uint64_t most = 0;
    std::uint64_t wait = plan.branches.empty() ? 0 : kStopLead;
    for (const PlannedBranch& branch : plan.branches) {
        most = std::max(most, wait + ticks_of(branch.steps));
        wait = branch.wait;
    }
    return std::max(most, wait);
}

}  // namespace curvecore::ref
