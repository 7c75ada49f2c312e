// SPDX-License-Identifier: Apache-2.0
#include "sysc/curves/built_in_curves.hpp"

#include "ref/series/spline_tables.hpp"
#include "sysc/curves/arc_families.hpp"
#include "sysc/curves/spline_families.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kNanometre = 1e-6;  // mm: the unit of the families of splines

ref::Move spline_move(const ref::Cubic& curve, double unit) {
    ref::Move move;
    move.kind = ref::Move::Kind::kCubic;
    move.feed = 10;
    move.cubic = {curve.a * unit, curve.b * unit, curve.c * unit, curve.d * unit};
    move.start = move.cubic.position(0);
    move.end = move.cubic.position(1);
    return move;
}

}  // namespace

ref::Program built_in_curves(CurveSet set) {
    ref::Program program;
    program.file = "built-in curves";
    if (set == CurveSet::kPapers) {
        for (const ref::TestSpline& spline : ref::test_splines()) {
            program.moves.push_back(spline_move(spline.cubic, 1));
        }
    }
    if (set == CurveSet::kAll || set == CurveSet::kArcs) {
        ArcMaker maker(1);
        for (const ArcFamily& family : arc_families()) program.moves.push_back(maker.next(family));
    }
    if (set == CurveSet::kAll || set == CurveSet::kSplines) {
        SplineMaker maker(1);
        for (const SplineFamily& family : spline_families()) {
            program.moves.push_back(spline_move(maker.next(family), kNanometre));
        }
    }
    int line = 0;
    for (ref::Move& move : program.moves) move.line = ++line;
    return program;
}

std::string paper_curve_name(std::size_t move) { return ref::test_splines().at(move).name; }

ref::Machine unlimited_machine() {
    ref::Machine machine;
    for (ref::AxisLimits& axis : machine.axis) {
        axis.min = -ref::kUnlimitedTravel;
        axis.max = ref::kUnlimitedTravel;
    }
    return machine;
}

}  // namespace curvecore::sysc
