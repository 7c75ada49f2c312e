// SPDX-License-Identifier: Apache-2.0
// The bound of a family of arcs against its segments, and its prediction of the planner's cuts
// against the planner.
#include "ref/geometry/arc_cover.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "ref/format/path_words.hpp"
#include "ref/geometry/geometry.hpp"
#include "sysc/curves/built_in_curves.hpp"

namespace curvecore::tb::arc_cover_test {
using namespace sysc;

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(engine_);
    }
    double spread(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    int whole(int low, int high) { return static_cast<int>(uniform(low, high + 1)); }
    ref::Vec3 direction() {
        return ref::Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
    }
    ref::CoreParameters format() {
        const bool polynomial = uniform(0, 1) < 0.5;
        return {whole(2, 12), whole(18, 36), 32, whole(2, 12), polynomial};
    }

  private:
    std::mt19937_64 engine_;
};

ref::Segment segment_of(Random& random, double radius, double length, int step_exponent) {
    ref::Segment segment;
    ref::ArcPiece& arc = segment.arc();
    arc.radius = radius;
    segment.length = static_cast<std::uint64_t>(length * 65536);
    segment.step_exponent = step_exponent;
    arc.cos_pitch = 1;
    arc.normal = random.direction();
    arc.tangent = arc.normal.unitOrthogonal();
    const double kind = random.uniform(0, 1);
    if (kind < 0.3) {
        arc.cos_pitch = random.uniform(0, 1);
        arc.advance = arc.normal.cross(arc.tangent) * std::sqrt(1 - arc.cos_pitch * arc.cos_pitch);
    } else if (kind < 0.4) {
        arc.advance = arc.normal;
        arc.normal = arc.tangent = ref::Vec3::Zero();
        arc.radius = arc.cos_pitch = 0;
    }
    return segment;
}

/// Largest ratio of a segment's own bound to the family's; radii `beyond` times below the least.
double worst_ratio(int segments, double beyond) {
    Random random(1);
    double worst = 0;
    for (int n = 0; n < segments; ++n) {
        const ref::CoreParameters format = random.format();
        const double least = random.spread(20, 1e9);
        const double most = least * random.uniform(1, 1.5);
        const int k = random.whole(0, 27);
        const double longest =
            std::min(M_PI_2 * most, std::ldexp(random.uniform(0.01, 1) < 0.5 ? 4 : 4096, k));
        if (std::ldexp(1 / least, k) > ref::kMostTheta) continue;
        const double family = ref::family_bound(format, {least, most, longest, k});
        const double radius = random.uniform(least, most) / beyond;
        const double length =
            std::min(longest, M_PI_2 * radius) * (n % 2 == 0 ? 1 : random.uniform(0, 1));
        const ref::Segment segment = segment_of(random, radius, length, k);
        worst = std::max(worst, ref::segment_bound(format, segment) / family);
    }
    return worst;
}

TEST(FamilyBound, IsAboveEverySegmentOfTheFamily) {
    const double worst = worst_ratio(100000, 1);
    EXPECT_LE(worst, 1 + 1e-12);
    EXPECT_GT(worst, 0.98);
}

TEST(FamilyBound, IsBelowThatOfTighterArcs) { EXPECT_GT(worst_ratio(100000, 1.2), 1.05); }

TEST(FamilyBound, GrowsWithTheLength) {
    Random random(2);
    for (int n = 0; n < 20000; ++n) {
        const ref::CoreParameters format = random.format();
        const double radius = random.spread(20, 1e9);
        const int k = random.whole(0, static_cast<int>(std::log2(radius)) - 1);
        const double length = random.spread(1, M_PI_2 * radius);
        EXPECT_LE(ref::family_bound(format, {radius, radius, length, k}),
                  ref::family_bound(format, {radius, radius, length * 1.1, k}) * (1 + 1e-12));
    }
}

/// Arcs of a quarter turn and more, by the planner.
class PlannedArc {
  public:
    PlannedArc(Random& random, const ref::CoreParameters& format, double radius, double limit) {
        ref::Program program;
        program.file = "arc";
        ref::Move move;
        move.line = 1;
        move.kind = ref::Move::Kind::kArc;
        move.feed = 10;
        move.normal = random.direction();
        const ref::Vec3 outward = move.normal.unitOrthogonal();
        move.start = outward * radius;
        move.angle = random.uniform(M_PI_2, 2 * M_PI);
        move.end = radius * (outward * std::cos(move.angle) +
                             move.normal.cross(outward) * std::sin(move.angle));
        program.moves.push_back(move);
        ref::PlanOptions options;
        options.unit_mm = 1;
        options.format = format;
        options.error_limit = limit;
        options.advise = false;
        segments = ref::make_geometry(program, unlimited_machine(), options).segments;
    }

    std::vector<ref::Segment> segments;
};

TEST(ArcCover, ThePlannerRefusesNoneAndKeepsItsRates) {
    Random random(3);
    int planned = 0;
    for (int n = 0; n < 2000; ++n) {
        const ref::CoreParameters format = random.format();
        const double most = random.spread(10, 1e9);
        const double least = most / std::sqrt(2.0);
        const double limit = random.spread(0.1, 10);
        const ref::ArcCover cover = ref::arc_cover(format, least, most, limit);
        if (cover.longest == 0 || cover.longest < most / 5000) continue;
        const double radius = random.uniform(least, most);
        const ref::ArcCover own = ref::arc_cover(format, radius, radius, limit);
        const PlannedArc arc(random, format, radius, limit);
        ++planned;
        double shortest = 1e300;
        double densest = 0;
        for (const ref::Segment& segment : arc.segments) {
            const double length = static_cast<double>(segment.length) / 65536;
            const double steps = std::ceil(std::ldexp(length, -segment.step_exponent));
            EXPECT_LE(segment.bound, limit);
            shortest = std::min(shortest, length);
            densest = std::max(densest, steps / length);
        }
        // An arc that exceeds its length word is cut into equal parts.
        const double cut = ref::kLongestSegment / 2;
        EXPECT_GE(shortest, 0.99 * std::min({cover.shortest, own.shortest, cut})) << n;
        EXPECT_LE(densest, 1.01 * std::max(cover.steps_per_unit, own.steps_per_unit)) << n;
    }
    EXPECT_GT(planned, 1000);
}

TEST(ArcCover, RefusesALimitBelowTheRoundings) {
    ref::CoreParameters format;
    format.guard_bits = 4;
    EXPECT_EQ(ref::arc_cover(format, 1e6, 1e6, 0.05).longest, 0);
    EXPECT_GT(ref::arc_cover(format, 1e6, 1e6, 0.1).longest, 0);
}

}  // namespace curvecore::tb::arc_cover_test
