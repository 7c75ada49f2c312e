// SPDX-License-Identifier: Apache-2.0
// The moves of a tool as those of a machine's joints.
#pragma once

#include <optional>
#include <string>

#include "ref/joints/tool_series.hpp"
#include "ref/machine/machine.hpp"
#include "ref/moves/move_source.hpp"
#include "ref/segment/plan_options.hpp"

namespace curvecore::ref {

/// Shares of PlanOptions::error_limit: how far a series may be off the joints' exact place, and its
/// words off the series. Together half of it, so that two samples' distance keeps the limit.
constexpr double kJointShare = 0.125;
constexpr double kWordShare = 0.375;

/// Gives each move as pieces that are a series of the joints, of Kind::kJoints, each no longer than
/// a step of the core. Angles go on from move to move: they count turns.
class JointMoves {
  public:
    /// @param machine outlives it
    JointMoves(MoveSource source, std::string file, const Machine& machine,
               const PlanOptions& options);

    /// Gives the next piece; returns false if there is none.
    /// @throws InputError of the source; at a place that the machine does not reach, or so near to
    /// a singular one that a joint goes beyond [KINS] JOINT_RATIO
    bool next(Move& piece);

  private:
    struct Reach {
        VectorSeries<kToolOrders> series;  // of the joints
        VectorSeries<kToolOrders> tool;
        double length;
    };

    Reach longest_from(double s) const;
    bool keeps(const VectorSeries<kJointOrders>& drawn, double s, double length) const;
    void go_on(Vec3& joints) const;
    Vec3 joints_at(double s) const;
    Move piece_of(const Reach& reach, double length) const;
    [[noreturn]] void out_of_reach(double s) const;
    [[noreturn]] void refuse(const std::string& reason) const;
    void check_travel() const;
    void begin();
    void check_letters() const;
    void check_rates(const VectorSeries<kToolOrders>& series, double s) const;

    MoveSource source_;
    std::string file_;
    const Machine& machine_;
    const Machine tool_;  // with axes of its own
    int orders_;          // of the series that the core draws
    double tolerance_;    // mm, degrees
    double longest_;      // mm of the tool's path
    double stretch_;
    Move move_;                 // the tool's
    double length_ = 0;         // of it, mm
    double done_ = 0;           // of that
    std::optional<Vec3> last_;  // joints
};

}  // namespace curvecore::ref
