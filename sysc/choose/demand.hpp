// SPDX-License-Identifier: Apache-2.0
// Load that the required curves put on a core with given words: the proof of the error, and its
// price in segments and integration steps per second.
#pragma once

#include <vector>

#include "ref/curve/cubic.hpp"
#include "sysc/choose/requirement.hpp"

namespace curvecore::sysc {

/// | field        | unit  | meaning                                                             |
/// |--------------|-------|---------------------------------------------------------------------|
/// | drawable     |       | every curve of the requirement has segments whose bound keeps the   |
/// |              |       | limit                                                               |
/// | bound        | units | the largest of these bounds                                         |
/// | segments     | 1/s   | at most, at the required feed or the feed that the machine allows   |
/// | steps        | 1/s   | integration steps, at most, at the same feed                        |
struct Load {
    bool drawable = true;
    double bound = 0;
    double segments = 0;
    double steps = 0;

    bool within(const Load& most) const {
        return drawable && segments <= most.segments && steps <= most.steps;
    }
};

constexpr double kSegmentWords = 17;  // on the bus, hls/words.hpp

struct Demand {
    Load arcs;
    Load splines;

    bool drawable() const { return arcs.drawable && splines.drawable; }
    double segments() const;
    double bound() const;
};

/// Derivation of the load.
///
/// Arcs, helices and lines: the radii from least_radius_mm to radius_mm are cut into ranges of a
/// half octave; ref::arc_cover() bounds every arc of a range, in any plane and direction, and finds
/// segments that keep the limit. No arc is sampled: the bound holds for all. Premise: X Y Z alone;
/// rates apply to arcs of a quarter turn or more and to lines as long as the longest segment of the
/// largest radius, since a shorter move is one segment on any core.
///
/// Splines: the planner halves a cubic until the derived bound of every piece keeps the limit, and
/// refuses it otherwise, so every drawn cubic is proven; there is a smallest GuardBits for the
/// limit. The number of pieces is not bounded for all cubics; it is counted for seeded ones of each
/// shape (bends, S bends, inflexions, hairpins, near cusps, straight) as long as the requirement
/// and a thirtieth of it, and the planner slows down where another cubic needs more.
class DemandModel {
  public:
    explicit DemandModel(const Requirement& requirement);

    /// Returns the loads of words in this unit with the planner's limit in units. The search ends
    /// early where a load exceeds `most`; its result is then a lower bound.
    Demand demand(const CoreParameters& format, double unit_mm, double limit,
                  const Load& most) const;

  private:
    /// A seeded cubic, mm, with the machine's times along it.
    struct Curve {
        ref::Cubic cubic;
        double length;
        std::vector<double> paths;  // ends of stretches of constant speed, mm
        std::vector<double> times;  // s

        double time(double path) const;
    };

    void add_curve(const ref::Cubic& shape, double length);
    Load arc_load(const CoreParameters& format, double unit_mm, double limit,
                  const Load& most) const;
    Load spline_load(const CoreParameters& format, double unit_mm, double limit,
                     const Load& most) const;

    const Requirement requirement_;
    std::vector<Curve> curves_;
};

}  // namespace curvecore::sysc
