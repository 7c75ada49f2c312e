// SPDX-License-Identifier: Apache-2.0
// Closed-form curves against high precision, their invariants, and their refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <random>
#include <string>

#include "ref/curve/helix.hpp"
#include "ref/curve/line.hpp"
#include "ref/moves/arc_geometry.hpp"
#include "ref/plan/segment_curve.hpp"

namespace curvecore::ref::curve_test {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
using Vector = Eigen::Matrix<Real, 3, 1>;

Vector wide(const Vec3& v) { return v.cast<Real>(); }

double largest(const Vector& v) { return static_cast<double>(v.cwiseAbs().maxCoeff()); }

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    Vec3 direction() {
        std::normal_distribution<double> gauss;
        return Vec3(gauss(engine_), gauss(engine_), gauss(engine_)).normalized();
    }

  private:
    std::mt19937 engine_;
};

struct ArcCase {
    Vec3 start, centre, normal;
    double angle, advance;
};

ArcCase random_arc(Random& random) {
    const Vec3 normal = random.direction();
    const Vec3 centre = random.direction() * random.uniform(0, 100);
    const double radius = random.log_uniform(1e-2, 1e3);
    const Vec3 start = centre + normal.cross(random.direction()).normalized() * radius;
    return {start, centre, normal, random.uniform(0.1, 12), random.uniform(-50, 50)};
}

TEST(Curve, LineRunsFromStartToEnd) {
    const Vec3 start(1, -2, 3);
    const Vec3 end(4, 2, 15);
    const Line<double> line(start, end);
    EXPECT_EQ(line.length(), 13);
    EXPECT_EQ(line.curvature(), 0);
    EXPECT_EQ(line.position(0), start);
    EXPECT_LT((line.position(13) - end).norm(), 1e-14);
    EXPECT_LT((line.tangent(5) - Vec3(3, 4, 12) / 13).norm(), 1e-15);
    EXPECT_THROW(Line<double>(start, start), std::invalid_argument);
}

TEST(Curve, DoubleHelixAgreesWithHighPrecision) {
    Random random(1);
    double worst = 0;  // in units of the rounding of the largest number involved
    for (int n = 0; n < 500; ++n) {
        const ArcCase arc = random_arc(random);
        const Helix<double> helix(arc.start, arc.centre, arc.normal, arc.angle, arc.advance);
        const Helix<Real> exact(wide(arc.start), wide(arc.centre), wide(arc.normal),
                                Real(arc.angle), Real(arc.advance));
        for (int i = 0; i <= 8; ++i) {
            const double s = helix.length() * i / 8;
            const double scale = helix.length() + helix.radius() + arc.centre.norm();
            const double error = largest(wide(helix.position(s)) - exact.position(Real(s)));
            worst = std::max(worst, error / (scale * std::ldexp(1.0, -53)));
            EXPECT_LT(largest(wide(helix.tangent(s)) - exact.tangent(Real(s))), 1e-13);
        }
    }
    EXPECT_LT(worst, 4);
    EXPECT_GT(worst, 0.25) << "the bound is idle";
}

TEST(Curve, HelixKeepsItsInvariants) {
    Random random(2);
    const Real step("1e-12");
    for (int n = 0; n < 50; ++n) {
        const ArcCase arc = random_arc(random);
        Vector normal = wide(arc.normal);
        normal.normalize();
        Vector radial = wide(arc.start - arc.centre);
        radial -= normal * normal.dot(radial);
        const Vector centre = wide(arc.centre);
        const Real angle(arc.angle);
        const Real advance(arc.advance);
        const Helix<Real> helix(centre + radial, centre, normal, angle, advance);
        for (int i = 0; i <= 8; ++i) {
            const Real s = helix.length() * i / 8;
            const Vector from_centre = helix.position(s) - centre;
            const Real height = normal.dot(from_centre);
            EXPECT_LT(abs(height - advance * i / 8), Real("1e-44"));
            EXPECT_LT(abs((from_centre - normal * height).norm() - helix.radius()), Real("1e-44"));
            EXPECT_LT(abs(helix.tangent(s).norm() - 1), Real("1e-47"));
            // Central differences: unit speed along the tangent, curvature across it.
            const Vector ahead = helix.position(s + step);
            const Vector behind = helix.position(s - step);
            EXPECT_LT(((ahead - behind) / (2 * step) - helix.tangent(s)).norm(), Real("1e-18"));
            const Vector bend = (helix.tangent(s + step) - helix.tangent(s - step)) / (2 * step);
            EXPECT_LT(abs(bend.norm() / helix.curvature() - 1), Real("1e-18"));
            // Counter-clockwise about the normal.
            EXPECT_GT(normal.dot(from_centre.cross(helix.tangent(s))), 0);
        }
    }
}

TEST(Curve, WholeTurnsReturnToTheStart) {
    const Helix<double> circle(Vec3(25, 0, 7), Vec3(0, 0, 7), Vec3::UnitZ(), 4 * M_PI);
    EXPECT_DOUBLE_EQ(circle.length(), 100 * M_PI);
    EXPECT_DOUBLE_EQ(circle.curvature(), 1 / 25.0);
    EXPECT_LT((circle.position(circle.length()) - Vec3(25, 0, 7)).norm(), 1e-13);
    EXPECT_LT((circle.position(circle.length() / 8) - Vec3(0, 25, 7)).norm(), 1e-13);
}

TEST(Curve, ArcThroughThreePointsPassesThemInOrder) {
    Random random(3);
    for (int n = 0; n < 1000; ++n) {
        const ArcCase arc = random_arc(random);
        const double angle = random.uniform(0.2, 6.2);
        const Helix<double> drawn(arc.start, arc.centre, arc.normal, angle);
        const double via = random.uniform(0.2, 0.8) * drawn.length();
        const Vec3 middle = drawn.position(via);
        const Vec3 end = drawn.position(drawn.length());
        const SpaceArc found = arc_through(arc.start, middle, end);
        const Helix<double> again(arc.start, found.centre, found.normal, found.angle);
        // Three points a chord apart fix the circle to their rounding times (R / chord)^2.
        const double chord = std::min(
            {(middle - arc.start).norm(), (end - middle).norm(), (end - arc.start).norm()});
        const double scale = arc.centre.norm() + drawn.radius();
        const double ratio = drawn.radius() / chord;
        const double bound = 64 * std::ldexp(scale, -53) * (1 + ratio * ratio);
        EXPECT_LT((found.centre - arc.centre).norm(), bound);
        EXPECT_LT((again.position(again.length()) - end).norm(), bound);
        EXPECT_LT((again.position(via) - middle).norm(), bound);
        EXPECT_GT(found.normal.dot(arc.normal), 0.999);
    }
}

template <class Make>
std::string refusal(Make make) {
    try {
        make();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Curve, ImpossibleArcsAreRefusedWithTheReason) {
    const Vec3 o = Vec3::Zero();
    const Vec3 x = Vec3::UnitX();
    const Vec3 z = Vec3::UnitZ();
    EXPECT_EQ(refusal([&] { Helix<double>(x, o, z, 1); }), "accepted");
    EXPECT_EQ(refusal([&] { Helix<double>(x, o, z, 0); }), "the angle of an arc is positive");
    EXPECT_EQ(refusal([&] { Helix<double>(x, o, z, std::nan("")); }),
              "the angle of an arc is positive");
    EXPECT_EQ(refusal([&] { Helix<double>(x, o, z * 1.001, 1); }),
              "the normal of a circle has the length 1");
    EXPECT_EQ(refusal([&] { Helix<double>(o, o, z, 1); }), "a circle starts away from its centre");
    EXPECT_EQ(refusal([&] { Helix<double>(x + z, o, z, 1); }),
              "a circle starts in the plane of its centre");
    EXPECT_EQ(refusal([&] { arc_through(o, x, 2 * x); }),
              "the arc's three points lie on a straight line");
}

/// A quarter turn at most, whose path stays below `reach` units.
Segment random_segment(Random& random, double radius, double reach) {
    Segment segment;
    ArcPiece& arc = segment.arc();
    const Vec3 axis = random.direction();
    arc.normal = axis.cross(random.direction()).normalized();
    arc.tangent = axis.cross(arc.normal);
    arc.radius = radius;
    const double pitch = random.uniform(-1.5, 1.5);
    arc.cos_pitch = std::cos(pitch);
    arc.advance = axis * std::sin(pitch);
    segment.start = random.direction() * std::max(0.0, random.uniform(-reach, reach));
    const double quarter = M_PI / 2 * radius / arc.cos_pitch;
    segment.length = static_cast<std::uint64_t>(std::ldexp(std::min(quarter, reach), 16));
    segment.aux_start = {random.uniform(-reach, reach)};
    segment.aux_advance = {random.uniform(-0.5, 0.5)};
    return segment;
}

Vector widest_position(const Segment& segment, double s) {
    const ArcPiece& arc = segment.arc();
    const Real path(s);
    Vector position = wide(segment.start) + wide(arc.advance) * path;
    if (arc.radius > 0) {
        const Real radius(arc.radius);
        const Real angle = path * Real(arc.cos_pitch) / radius;
        position +=
            (wide(arc.tangent) * sin(angle) - wide(arc.normal) * (Real(1) - cos(angle))) * radius;
    }
    return position;
}

struct Worst {
    double units = 0;     // error per axis
    double relative = 0;  // of the larger of |start| and s, in 2^-53
};

Worst worst_of(unsigned seed, double smallest_radius, double largest_radius, double reach) {
    Random random(seed);
    Worst worst;
    for (int n = 0; n < 4000; ++n) {
        const double radius = n % 8 == 0 ? 0 : random.log_uniform(smallest_radius, largest_radius);
        Segment segment = random_segment(random, radius == 0 ? 1e9 : radius, reach);
        if (radius == 0) {
            segment.curve = ArcPiece();
            segment.arc().advance = random.direction();
        }
        for (const double part : {0.0, random.uniform(0, 1e-3), random.uniform(0, 1), 1.0}) {
            const double s = std::ldexp(std::floor(part * double(segment.length)), -16);
            const double error =
                largest(wide(exact_position(segment, s)) - widest_position(segment, s));
            const double scale = std::max(segment.start.norm(), s);
            worst.units = std::max(worst.units, error);
            worst.relative = std::max(worst.relative, error / std::ldexp(scale, -53));
            const Real aux = Real(segment.aux_start[0]) + Real(segment.aux_advance[0]) * Real(s);
            EXPECT_LT(abs(Real(exact_aux(segment, 0, s)) - aux),
                      std::ldexp(std::max(reach, s), -52));
        }
    }
    return worst;
}

// 10 um to 1 m at 1 nm, anywhere in a machine of 1 m.
TEST(SegmentCurve, StaysBelowAMillionthOfAUnit) {
    const Worst worst = worst_of(4, 1e4, 1e9, 1e9);
    EXPECT_LT(worst.units, 1e-6);
    EXPECT_LT(worst.relative, 8);
    EXPECT_GT(worst.relative, 2) << "the bound is idle";
}

// Radii far beyond the machine: as good, because only the chord is computed, never the centre.
TEST(SegmentCurve, LargeRadiiLoseNothing) {
    const Worst worst = worst_of(5, 1e9, 1e14, 1e9);
    EXPECT_LT(worst.units, 1e-6);
    EXPECT_LT(worst.relative, 8);
}

// The largest coordinates of 32-bit positions.
TEST(SegmentCurve, HoldsToTheEndsOfTheWords) {
    const Worst worst = worst_of(6, 1e2, 2.1e9, 2.1e9);
    EXPECT_LT(worst.units, 1e-6);
    EXPECT_LT(worst.relative, 8);
}

TEST(SegmentCurve, AgreesWithTheHelix) {
    Random random(7);
    for (int n = 0; n < 200; ++n) {
        const Segment segment = random_segment(random, random.log_uniform(1e4, 1e9), 1e8);
        const ArcPiece& arc = segment.arc();
        const Vec3 axis = arc.normal.cross(arc.tangent);
        const double length = std::ldexp(double(segment.length), -16);
        const Helix<double> helix(segment.start, segment.start - arc.normal * arc.radius, axis,
                                  arc.cos_pitch * length / arc.radius,
                                  arc.advance.dot(axis) * length);
        for (int i = 0; i <= 4; ++i) {
            const double s = length * i / 4;
            EXPECT_LT((exact_position(segment, s) - helix.position(s)).norm(),
                      std::ldexp(arc.radius + segment.start.norm() + length, -49));
        }
    }
}

}  // namespace curvecore::ref::curve_test
