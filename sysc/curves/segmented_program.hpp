// SPDX-License-Identifier: Apache-2.0
// A program segmented for one configuration: by the planner, as finely as equal data rate allows.
#pragma once

#include <string>

#include "ref/geometry/geometry.hpp"
#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// Narrow words can be bought with very many segments. To make configurations comparable, each may
/// have `most_segments` in all; a configuration that needs more for the requested limit gets the
/// least of the limits 2, 4, 8 .. times as large with which it can be planned.
///
/// | field    | unit  | meaning                                                             |
/// |----------|-------|---------------------------------------------------------------------|
/// | segments |       | none: not drawable with any limit                                   |
/// | limit    | units | every segment's derived bound is below it                           |
/// | refused  |       | why the limit is not the requested one; empty: it is                |
struct SegmentedProgram {
    std::vector<ref::Segment> segments;
    double limit = 0;
    std::string refused;
};

class Segmenter {
  public:
    /// @throws ref::InputError: the widest words that exist cannot draw the program either, or the
    /// machine cannot
    Segmenter(const ref::Program& program, const ref::Machine& machine, double unit_mm,
              double limit, int times_segments);

    SegmentedProgram segment(const CoreParameters& format) const;

    /// Number of segments with Order 12, CoefBits 36, GuardBits 12.
    std::size_t reference_segments() const { return reference_segments_; }
    std::size_t most_segments() const { return most_segments_; }

  private:
    bool fits(const CoreParameters& format, double limit, SegmentedProgram& segmented) const;

    const ref::Program& program_;
    const ref::Machine& machine_;
    double unit_mm_;
    double limit_;
    std::size_t reference_segments_ = 0;
    std::size_t most_segments_ = 0;
};

}  // namespace curvecore::sysc
