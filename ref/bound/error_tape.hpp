// SPDX-License-Identifier: Apache-2.0
// Numbers that know how far the words of a core may be off them: every operation on words is
// bilinear, so with errors da and db
//
//     (a + da)(b + db) = a b + a db + b da + da db
//
// is exact. The part of first order is kept on a tape, and swept back from what is asked for; the
// last term, and each rounding, are errors of their own.
//
// Source: B. Christianson, Reverse accumulation and accurate rounding error estimates for Taylor
// series coefficients, Optimization Methods and Software 1, 1991.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace curvecore::ref {

/// The word nearest to a value, of so many fraction bits; ties go upwards.
inline double nearest_word(double value, int bits) {
    return std::ldexp(std::floor(std::ldexp(value, bits) + 0.5), -bits);
}

/// Operations in their order, each with the partials by its operands and an error of its own.
class ErrorTape {
  public:
    static constexpr int kNone = -1;  // the node of what has no error

    int add(double own, int a = kNone, double by_a = 0, int b = kNone, double by_b = 0) {
        nodes_.push_back({a, b, by_a, by_b, own});
        return static_cast<int>(nodes_.size()) - 1;
    }
    void clear() { nodes_.clear(); }
    double own(std::size_t node) const { return nodes_[node].own; }

    /// Partials of the outputs, a column each, by all nodes.
    Eigen::MatrixXd sweep(const std::vector<int>& outputs) const;

  private:
    struct Node {
        int a;
        int b;
        double by_a;
        double by_b;
        double own;
    };
    std::vector<Node> nodes_;
};

/// A number whose word is at most `error` off it, and has `bits` fraction bits at most.
struct TracedNumber {
    TracedNumber() = default;
    TracedNumber(double of) : value(of) {  // NOLINT(google-explicit-constructor)
        constexpr int kMost = 60;
        while (bits < kMost && std::ldexp(value, bits) != std::floor(std::ldexp(value, bits))) {
            ++bits;
        }
    }
    TracedNumber(double of, double off, int fraction_bits, ErrorTape* on, int at)
        : value(of), error(off), bits(fraction_bits), tape(on), node(at) {}

    bool zero() const { return value == 0 && error == 0; }

    double value = 0;
    double error = 0;
    int bits = 0;
    ErrorTape* tape = nullptr;
    int node = ErrorTape::kNone;
};

inline TracedNumber operator*(const TracedNumber& a, const TracedNumber& b) {
    if (a.zero() || b.zero()) return {};
    ErrorTape* const tape = a.tape != nullptr ? a.tape : b.tape;
    const double second = a.error * b.error;
    const double error = std::abs(a.value) * b.error + std::abs(b.value) * a.error + second;
    const int node =
        tape == nullptr ? ErrorTape::kNone : tape->add(second, a.node, b.value, b.node, a.value);
    return {a.value * b.value, error, a.bits + b.bits, tape, node};
}
inline TracedNumber operator+(const TracedNumber& a, const TracedNumber& b) {
    if (a.zero()) return b;
    if (b.zero()) return a;
    ErrorTape* const tape = a.tape != nullptr ? a.tape : b.tape;
    const int node = tape == nullptr ? ErrorTape::kNone : tape->add(0, a.node, 1, b.node, 1);
    return {a.value + b.value, a.error + b.error, std::max(a.bits, b.bits), tape, node};
}
inline TracedNumber& operator+=(TracedNumber& sum, const TracedNumber& by) {
    return sum = sum + by;
}
inline TracedNumber ldexp(const TracedNumber& of, int power) {
    TracedNumber made = of * TracedNumber(std::ldexp(1.0, power));
    made.bits = of.bits - power;
    return made;
}
/// The largest magnitude that the word may have.
inline TracedNumber abs(const TracedNumber& of) { return std::abs(of.value) + of.error; }
inline bool operator<(const TracedNumber& a, const TracedNumber& b) { return a.value < b.value; }

/// The roundings of a core's words, as arithmetic of a table (ref/curves/table_machine.hpp).
struct TracedWords {
    int coef_bits = 36;
    int guard_bits = 10;
    ErrorTape* tape = nullptr;

    TracedNumber rounded(const TracedNumber& sum, int fraction) const {
        return nearest(sum, coef_bits + fraction);
    }
    int guard() const { return 0; }
    TracedNumber position(const TracedNumber& sum) const { return nearest(sum, guard_bits); }
    TracedNumber weight(int i) const {
        const int bits = coef_bits - 1;
        const double exact = 1.0 / i;
        const double off = std::abs(nearest_word(exact, bits) - exact);
        return {exact, off, bits, tape, tape->add(off)};
    }

  private:
    TracedNumber nearest(const TracedNumber& sum, int bits) const {
        if (sum.bits <= bits) return sum;
        const double half = std::ldexp(0.5, -bits);
        return {sum.value, sum.error + half, bits, tape, tape->add(half, sum.node, 1)};
    }
};

}  // namespace curvecore::ref
