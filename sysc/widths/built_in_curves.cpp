// SPDX-License-Identifier: Apache-2.0
#include "sysc/widths/built_in_curves.hpp"

#include "sysc/widths/arc_families.hpp"
#include "sysc/widths/spline_families.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kNanometre = 1e-6;  // mm: the unit of the families of splines

ref::Move spline_move(const ref::Cubic& curve) {
    ref::Move move;
    move.kind = ref::Move::Kind::kCubic;
    move.feed = 10;
    move.cubic = {curve.a * kNanometre, curve.b * kNanometre, curve.c * kNanometre,
                  curve.d * kNanometre};
    move.start = move.cubic.position(0);
    move.end = move.cubic.position(1);
    return move;
}

}  // namespace

ref::Program built_in_curves(CurveSet set) {
    ref::Program program;
    program.file = "built-in curves";
    if (set != CurveSet::kSplines) {
        ArcMaker maker(1);
        for (const ArcFamily& family : arc_families()) program.moves.push_back(maker.next(family));
    }
    if (set != CurveSet::kArcs) {
        SplineMaker maker(1);
        for (const SplineFamily& family : spline_families()) {
            program.moves.push_back(spline_move(maker.next(family)));
        }
    }
    int line = 0;
    for (ref::Move& move : program.moves) move.line = ++line;
    return program;
}

ref::Machine unlimited_machine() {
    ref::Machine machine;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.min = -1e9;
        axis.max = 1e9;
    }
    return machine;
}

}  // namespace curvecore::sysc
