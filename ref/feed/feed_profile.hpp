// SPDX-License-Identifier: Apache-2.0
// Feed profile of a whole program: limits, stops and look-ahead to pieces.
#pragma once

#include "ref/segment/geometry.hpp"

namespace curvecore::ref {

/// Fills in pieces, duration, bounds of holds and the feed at both ends of every segment.
void plan_feed(const Program& program, const Machine& machine, const PlanOptions& options,
               const Geometry& geometry, Plan& plan);

}  // namespace curvecore::ref
