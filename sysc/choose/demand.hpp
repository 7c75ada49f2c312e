// SPDX-License-Identifier: Apache-2.0
// What the required curves ask of a core with given words: the proof of the error, and its price in
// segments and integration steps per second.
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
/// | segments     | 1/s   | at most, at the required feed or what the machine allows              |
/// | steps        | 1/s   | the same of integration steps                                       |
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

/// The thread of the proof.
///
/// Arcs, helices and lines: the radii from least_radius_mm to radius_mm are cut into ranges of a
/// half octave; ref::arc_cover() bounds every arc of a range, in any plane and direction,
/// and finds segments that keep the limit. No arc is tried: the bound holds for all. Premise:
/// X Y Z alone; rates are of arcs of a quarter turn or more and of lines as long as the longest
/// segment of the largest radius, since a shorter move is a segment whatever the core is.
///
/// Splines: the planner halves a cubic until the derived bound of every piece keeps the limit, and
/// refuses it otherwise, so what is drawn is proven; there is a smallest GuardBits for the limit.
/// How many pieces that takes is not bounded for all cubics; it is counted for seeded ones of each
/// shape (bends, S bends, inflexions, hairpins, near cusps, straight) as long as the requirement
/// and a thirtieth of it, and the planner slows down where another cubic asks for more.
class DemandModel {
  public:
    explicit DemandModel(const Requirement& requirement);

    /// The loads of words in this unit with the planner's limit in units. The search ends early,
    /// with what it has, where a load is beyond `most`: then it is a lower bound.
    Demand demand(const CoreParameters& format, double unit_mm, double limit,
                  const Load& most) const;

  private:
    /// A seeded cubic, mm, and when the machine is where on it.
    struct Curve {
        ref::Cubic cubic;
        double length;
        std::vector<double> paths;  // mm, of the ends of stretches of one speed
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
