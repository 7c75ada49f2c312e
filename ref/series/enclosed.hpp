// SPDX-License-Identifier: Apache-2.0
// An arithmetic that carries errors, in which the interpreter draws a network's words.
#pragma once

#include <cmath>

namespace curvecore::ref {

/// A number, and a bound of its distance from the real number that a word stands for.
///
/// | field    | meaning                                                                        |
/// |----------|--------------------------------------------------------------------------------|
/// | value    | that of the exact curve at the exact place                                     |
/// | rounding | by the roundings of this step alone, to first order: what an error bound adds  |
/// | drift    | by all else: the words' curve and place are others, and errors multiply        |
struct Enclosed {
    double value = 0;
    double rounding = 0;
    double drift = 0;

    Enclosed() = default;
    Enclosed(double exact) : value(exact) {}
    Enclosed(double number, double by_rounding, double by_drift)
        : value(number), rounding(by_rounding), drift(by_drift) {}

    double error() const { return rounding + drift; }
    double size() const { return std::abs(value); }
    /// Bound of the word's size.
    double reach() const { return size() + error(); }

    Enclosed& operator+=(const Enclosed& more) {
        value += more.value;
        rounding += more.rounding;
        drift += more.drift;
        return *this;
    }
};

inline Enclosed operator+(Enclosed a, const Enclosed& b) { return a += b; }
inline Enclosed operator-(const Enclosed& a) { return {-a.value, a.rounding, a.drift}; }
inline Enclosed operator*(const Enclosed& a, const Enclosed& b) {
    return {a.value * b.value, a.size() * b.rounding + b.size() * a.rounding,
            a.size() * b.drift + b.size() * a.drift + a.error() * b.error()};
}
inline Enclosed operator/(const Enclosed& a, int exact) {
    return {a.value / exact, a.rounding / exact, a.drift / exact};
}

}  // namespace curvecore::ref
