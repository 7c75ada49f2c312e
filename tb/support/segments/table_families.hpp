// SPDX-License-Identifier: Apache-2.0
// Seeded curves of every table that is shipped for programs, with their closed forms.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "ref/curve/drawn/table_piece.hpp"
#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"

namespace curvecore::tb {

/// A curve in mm: its rows, and the place at a path length from its start.
struct TableCase {
    ref::TablePiece piece;
    double length = 0;
    std::function<ref::Vec3(double s)> at;
};

class TableFamilies {
  public:
    /// @param folder that of the tables, ref/curves
    TableFamilies(const std::string& folder, std::uint64_t seed) : folder_(folder), random_(seed) {}

    static const std::vector<std::string>& names() {
        static const std::vector<std::string> kNames{
            "archimedean", "catenary", "clothoid", "ellipse", "involute", "quintic", "spiral"};
        return kNames;
    }
    /// The table, which is kept.
    std::shared_ptr<const ref::CurveTable> table(const std::string& name) {
        auto& table = tables_[name];
        if (!table) {
            auto read = std::make_shared<ref::CurveTable>(
                ref::read_curve_table(folder_ + "/" + name + ".net"));
            read->powers = ref::row_powers(*read);
            table = read;
        }
        return table;
    }

    TableCase next(const std::string& name) {
        turn_frame();
        TableCase made = name == "archimedean" ? archimedean()
                         : name == "catenary"  ? catenary()
                         : name == "clothoid"  ? clothoid()
                         : name == "ellipse"   ? ellipse()
                         : name == "involute"  ? involute()
                         : name == "quintic"   ? quintic()
                                               : spiral();
        made.piece.table = table(name).get();
        return made;
    }

  private:
    using Vec3 = ref::Vec3;

    double real(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    double size() { return std::exp(real(std::log(2.0), std::log(100.0))); }  // mm

    void turn_frame() {
        const auto any = [&] { return Vec3(real(-1, 1), real(-1, 1), real(-1, 1)); };
        e1_ = any().normalized();
        e2_ = e1_.cross(any()).normalized();
        origin_ = 100 * any();
    }
    /// A place of the curve's plane.
    Vec3 in_plane(double x, double y) const { return x * e1_ + y * e2_; }

    /// Curves of a frame T, N = T turned to the left, at an angle in the plane.
    TableCase framed(double angle, double theta, const std::vector<double>& further) const {
        TableCase made;
        made.piece.theta = theta;
        made.piece.tangent = in_plane(std::cos(angle), std::sin(angle));
        made.piece.normal = in_plane(-std::sin(angle), std::cos(angle));
        std::copy(further.begin(), further.end(), made.piece.further.begin());
        return made;
    }
    /// A curve by its parameter, which a path length has.
    template <class Parameter, class Place>
    TableCase with(TableCase made, double length, Parameter parameter, Place place) const {
        made.length = length;
        made.at = [=, origin = origin_, frame = *this](double s) {
            const auto [x, y] = place(parameter(s));
            return Vec3(origin + frame.in_plane(x, y));
        };
        return made;
    }
    using Pair = std::pair<double, double>;

    /// The parameter of a path length, between 0 and `most`: `path` grows with it.
    template <class Path>
    static double inverted(const Path& path, double s, double least, double most) {
        for (int n = 0; n < 200; ++n) {
            const double middle = (least + most) / 2;
            (path(middle) < s ? least : most) = middle;
        }
        return (least + most) / 2;
    }
    template <class Function>
    static double integral(const Function& of, double from, double to) {
        constexpr int kParts = 32;
        double sum = 0;
        for (int part = 0; part < kParts; ++part) {
            sum += boost::math::quadrature::gauss<double, 20>::integrate(
                of, from + (to - from) * part / kParts, from + (to - from) * (part + 1) / kParts);
        }
        return sum;
    }

    TableCase involute() {
        const double r = size();
        const double t0 = real(0.6, 3);
        const double t1 = t0 + real(0.5, 3);
        return with(
            framed(t0, 1 / r, {1 / t0}), r * (t1 * t1 - t0 * t0) / 2,
            [=](double s) { return std::sqrt(t0 * t0 + 2 * s / r); },
            [=](double t) {
                return Pair(r * (std::cos(t) + t * std::sin(t)),
                            r * (std::sin(t) - t * std::cos(t)));
            });
    }
    TableCase spiral() {
        const double r = size();
        const double c = real(0, 1) < 0.5 ? -real(0.05, 0.5) : real(0.05, 0.5);
        const double grow = std::sqrt(1 + c * c);
        const double turned = real(0.5, 4);
        return with(
            framed(std::atan2(1, c), c, {1 / (r * grow)}), r * grow / c * std::expm1(c * turned),
            [=](double s) { return std::log1p(s * c / (r * grow)) / c; },
            [=](double p) {
                return Pair(r * std::exp(c * p) * std::cos(p), r * std::exp(c * p) * std::sin(p));
            });
    }
    TableCase catenary() {
        const double b = 1 / size();
        const double slope = real(-1.2, 1);
        const double from = std::tan(slope) / b;
        return with(
            framed(slope, b, {std::cos(slope), std::sin(slope)}), real(0.5, 3) / b,
            [=](double s) { return from + s; },
            [=](double s) {
                return Pair(std::asinh(b * s) / b, std::sqrt(1 + b * b * s * s) / b);
            });
    }
    TableCase archimedean() {
        const double b = 1 / size();
        const double p0 = real(0, 10);
        const double p1 = p0 + real(0.5, 7);
        const auto path = [=](double p) {
            return (p * std::sqrt(1 + p * p) + std::asinh(p)) / (2 * b);
        };
        return with(
            framed(p0 + std::atan2(p0, 1), b, {p0, 1 / std::sqrt(1 + p0 * p0)}),
            path(p1) - path(p0), [=](double s) { return inverted(path, s + path(p0), p0, p1 + 1); },
            [=](double p) { return Pair(p / b * std::cos(p), p / b * std::sin(p)); });
    }
    TableCase clothoid() {
        const double kappa = real(-0.5, 0.5);
        const double sigma = real(-0.02, 0.02);
        const auto angle = [=](double s) { return (kappa + sigma * s / 2) * s; };
        TableCase made = framed(0, sigma, {});
        made.piece.advance = Vec3::Constant(kappa);
        return with(
            made, real(2, 30), [](double s) { return s; },
            [=](double s) {
                return Pair(integral([&](double at) { return std::cos(angle(at)); }, 0, s),
                            integral([&](double at) { return std::sin(angle(at)); }, 0, s));
            });
    }
    TableCase ellipse() {
        const double a = size();
        const double b = a * std::exp(real(-1, 1));
        const double mu = 1 / std::max(a, b);
        const double p0 = real(-3, 3);
        const double p1 = p0 + real(0.5, 7);
        const auto speed = [=](double p) { return std::hypot(a * std::sin(p), b * std::cos(p)); };
        TableCase made;
        made.piece.theta = mu;
        made.piece.tangent = mu * a * e1_;
        made.piece.normal = mu * b * e2_;
        made.piece.further = {std::cos(p0), std::sin(p0), 1 / (mu * speed(p0))};
        const auto path = [=](double p) { return integral(speed, p0, p); };
        return with(
            made, path(p1), [=](double s) { return inverted(path, s, p0, p1 + 1); },
            [=](double p) { return Pair(a * std::cos(p), b * std::sin(p)); });
    }
    TableCase quintic() {
        const double size = this->size();
        std::array<Vec3, 5> v{e1_, {}, {}, {}, {}};  // of dr/du, by powers of u
        for (int n = 1; n <= 4; ++n) {
            v[n] = 0.4 / n * Vec3(real(-1, 1), real(-1, 1), real(-1, 1)) / std::pow(size, n);
        }
        const auto slope = [v](double u) {
            return Vec3(v[0] + u * (v[1] + u * (v[2] + u * (v[3] + u * v[4]))));
        };
        const double u1 = size * real(0.3, 1);
        const auto path = [slope](double u) {
            return integral([&](double at) { return slope(at).norm(); }, 0, u);
        };
        TableCase made;
        made.piece.tangent = v[0];
        made.piece.normal = v[1];
        made.piece.advance = 2 * v[2];
        for (int axis = 0; axis < 3; ++axis) {
            made.piece.further[axis] = 6 * v[3][axis];
            made.piece.further[3 + axis] = 24 * v[4][axis];
        }
        made.piece.further[6] = 1;
        made.length = path(u1);
        made.at = [=, origin = origin_](double s) {
            const double u = inverted(path, s, 0, u1 + size);
            return Vec3(origin + u * (v[0] + u * (v[1] / 2 +
                                                  u * (v[2] / 3 + u * (v[3] / 4 + u * v[4] / 5)))));
        };
        return made;
    }

    std::string folder_;
    std::mt19937_64 random_;
    std::map<std::string, std::shared_ptr<const ref::CurveTable>> tables_;
    Vec3 e1_, e2_, origin_;
};

}  // namespace curvecore::tb
