// SPDX-License-Identifier: Apache-2.0
#include "ref/feed/planner.hpp"

#include "ref/feed/feed_profile.hpp"
#include "ref/program/input_error.hpp"
#include "ref/segment/geometry.hpp"

namespace curvecore::ref {

Plan make_plan(const Program& program, const Machine& machine, const PlanOptions& options) {
    Geometry geometry = make_geometry(program, machine, options);
    if (geometry.segments.empty()) {
        throw InputError(program.file, 0, "the program moves nothing");
    }
    Plan plan;
    plan.unit_mm = options.unit_mm;
    plan.tick_s = options.tick_s();
    plan.aux_axes = program.aux_axes;
    plan.segments = std::move(geometry.segments);
    plan_feed(program, machine, options, geometry, plan);
    return plan;
}

}  // namespace curvecore::ref
