// SPDX-License-Identifier: Apache-2.0
// Random blocks with arcs as programs write them, rounded to some decimals, and the curve that each
// defines: computed here from the printed numbers, without the reader's code.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <random>
#include <string>

#include "ref/curve/vec3.hpp"

namespace curvecore::tb {

using Real = long double;
using Flat = std::complex<Real>;  // mm, in the arc's plane

/// An arc r(u) = centre + start's radius turned by sweep u + (gap at the end) u.
struct WrittenArc {
    int normal_axis = 2;
    Flat start, end, centre;
    Real low = 0, high = 0;  // along the normal, at start and end
    Real sweep = 0;          // signed, counter-clockwise positive; whole turns included
    double radius_word = 0;  // of R; 0: I J K
    std::string modes;       // lines before it, which also go to its start
    std::string block;

    /// Distance by which roundings of doubles may move the centre, mm: with R its height over the
    /// chord is a root.
    double loose() const {
        if (radius_word == 0) return 0;
        const Real square = 8e-15L * radius() * (std::abs(start) + std::abs(end) + radius());
        const Real height = std::abs(centre - (start + end) / Real(2));
        return static_cast<double>(square / std::max(height, std::sqrt(square)));
    }
    Real radius() const { return std::abs(start - centre); }
    Real mismatch() const { return std::abs(std::abs(end - centre) - radius()); }
    ref::Vec3 place(Flat at, Real height) const {
        ref::Vec3 point;
        point[(normal_axis + 1) % 3] = static_cast<double>(at.real());
        point[(normal_axis + 2) % 3] = static_cast<double>(at.imag());
        point[normal_axis] = static_cast<double>(height);
        return point;
    }
    ref::Vec3 at(Real u) const {
        const auto turned = [this](Real angle) {
            return centre + (start - centre) * std::polar<Real>(1, angle);
        };
        return place(turned(sweep * u) + u * (end - turned(sweep)), low + u * (high - low));
    }
    /// Distance of a point of the machine from the circle about the given centre.
    double off_circle(const ref::Vec3& point) const {
        const Flat flat(point[(normal_axis + 1) % 3], point[(normal_axis + 2) % 3]);
        return static_cast<double>(std::abs(std::abs(flat - centre) - radius()));
    }
};

class ArcWriter {
  public:
    explicit ArcWriter(unsigned seed) : random_(seed) {}

    /// Next arc: sweeps of up to 359.99 degrees, nearly full ones often; up to three turns; 2 to 5
    /// decimals.
    WrittenArc next() {
        for (;;) {
            WrittenArc arc = any();
            const Real most = inch_ ? Real(0.0127) : Real(0.005);
            const Real least = std::abs(arc.end - arc.centre);
            const bool allowed =
                arc.mismatch() < most * Real(0.999) ||
                (arc.mismatch() < 100 * most && arc.mismatch() < Real(0.000999) * least);
            const Real too_wide = std::abs(arc.end - arc.start) / 2 - std::abs(arc.radius_word);
            if (arc.radius_word != 0 && too_wide > most * Real(0.499)) continue;
            if (allowed && arc.radius() > Real(0.001) && least > Real(0.001)) return arc;
        }
    }

    bool one_of(int n) { return random_() % static_cast<unsigned>(n) == 0; }
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

  private:
    static constexpr Real kTurn = 2 * 3.14159265358979323846264338327950288L;

    /// Writes a number; `value` becomes the written one, in mm.
    std::string word(char letter, Real value, Real& written) const {
        const std::string text =
            fmt::format("{:.{}f}", static_cast<double>(value / unit()), decimals_);
        written = std::stold(text) * unit();
        return fmt::format(" {}{}", letter, text);
    }
    Real unit() const { return inch_ ? Real(25.4L) : Real(1); }
    Real rounded(Real value) const {
        Real written = 0;
        word('X', value, written);
        return written;
    }

    double sweep() {
        switch (random_() % 4) {
            case 0:
                return uniform(350, 359.99);
            case 1:
                return one_of(2) ? uniform(0.001, 2) : uniform(178, 182);
            default:
                return uniform(0.1, 359.99);
        }
    }

    WrittenArc any() {
        WrittenArc arc;
        decimals_ = 2 + static_cast<int>(random_() % 4);
        inch_ = one_of(3);
        const bool clockwise = one_of(2);
        const bool incremental = one_of(2);
        const bool absolute_centre = one_of(3);
        const bool by_radius = one_of(4);
        const int turns = one_of(4) ? 2 + static_cast<int>(random_() % 2) : 1;
        arc.normal_axis = static_cast<int>(random_() % 3);
        const auto a = static_cast<std::size_t>((arc.normal_axis + 1) % 3);
        const auto b = static_cast<std::size_t>((arc.normal_axis + 2) % 3);
        const auto n = static_cast<std::size_t>(arc.normal_axis);

        const Real radius = std::exp(uniform(std::log(0.05), std::log(150)));
        const Real towards = uniform(0, 6.2832);
        const Real angle = static_cast<Real>(sweep()) / 360 * kTurn * (clockwise ? -1 : 1);
        arc.start = {rounded(uniform(-20, 20)), rounded(uniform(-20, 20))};
        arc.low = rounded(uniform(-5, 5));
        const Flat centre = arc.start - std::polar(radius, towards);
        const Flat end = centre + std::polar(radius, towards + angle);
        const Real high = one_of(2) ? arc.low : arc.low + uniform(-3, 3);

        arc.modes = fmt::format("{} {} G90 F600\nG0", inch_ ? "G20" : "G21",
                                n == 2   ? "G17"
                                : n == 1 ? "G18"
                                         : "G19");
        Real written = 0;
        arc.modes += word("XYZ"[a], arc.start.real(), written);
        arc.modes += word("XYZ"[b], arc.start.imag(), written);
        arc.modes += word("XYZ"[n], arc.low, written) + "\n";

        std::string& text = arc.block;
        text = fmt::format("{} {} {}", incremental ? "G91" : "G90",
                           absolute_centre ? "G90.1" : "G91.1", clockwise ? "G2" : "G3");
        const auto axis = [&](std::size_t i, Real from, Real to) {
            text += word("XYZ"[i], incremental ? to - from : to, written);
            return incremental ? from + written : written;
        };
        arc.end = {axis(a, arc.start.real(), end.real()), axis(b, arc.start.imag(), end.imag())};
        arc.high = axis(n, arc.low, high);
        if (by_radius) {
            const Real half = std::abs(arc.end - arc.start) / 2;
            const bool wide = std::abs(angle) > kTurn / 2;
            text += word('R', wide ? -radius : radius, written);
            if (written == 0) return any();
            arc.radius_word = static_cast<double>(written);
            centre_of(arc, half, written, clockwise);
        } else {
            const auto offset = [&](std::size_t i, Real from, Real to) {
                text += word("IJK"[i], absolute_centre ? to : to - from, written);
                return absolute_centre ? written : from + written;
            };
            arc.centre = {offset(a, arc.start.real(), centre.real()),
                          offset(b, arc.start.imag(), centre.imag())};
        }
        arc.sweep = std::arg((arc.end - arc.centre) / (arc.start - arc.centre));
        if (clockwise) arc.sweep = -arc.sweep;
        // Ends in one direction, to 1e-9 mm, are a whole turn.
        if (arc.sweep * arc.radius() < 1e-9L) arc.sweep += kTurn;
        arc.sweep += kTurn * (turns - 1);
        if (clockwise) arc.sweep = -arc.sweep;
        if (turns > 1) text += fmt::format(" P{}", turns);
        text += "\n";
        return arc;
    }

    /// Sets the centre to an intersection of the circles about both ends with the radius: the one
    /// from which the end is seen within half a turn, or beyond it for a negative radius.
    static void centre_of(WrittenArc& arc, Real half, Real radius, bool clockwise) {
        arc.centre = (arc.start + arc.end) / Real(2);
        const Real far = (std::abs(radius) - half) * (std::abs(radius) + half);
        if (half == 0 || far <= 0) return;
        const Flat left = (arc.end - arc.start) / (2 * half) * Flat(0, 1);
        const bool on_left = (radius > 0) != clockwise;
        arc.centre += std::sqrt(far) * left * Real(on_left ? 1 : -1);
    }

    std::mt19937 random_;
    int decimals_ = 3;
    bool inch_ = false;
};

}  // namespace curvecore::tb
