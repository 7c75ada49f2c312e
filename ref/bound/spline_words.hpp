// SPDX-License-Identifier: Apache-2.0
// Every word of one step of the spline core, with its errors, and whether all keep their ranges.
#pragma once

#include <array>
#include <cmath>

#include "ref/bound/error_bound.hpp"
#include "ref/plan/segment.hpp"
#include "ref/series/enclosed.hpp"
#include "ref/series/interpreter.hpp"
#include "ref/series/spline_state.hpp"

namespace curvecore::ref {

/// Half a last bit of a word with `frac` fraction bits.
inline double half_bit(int frac) { return std::ldexp(0.5, -frac); }

/// The part that must be shorter so that every word keeps its range.
enum class Shorten { kNothing, kSteps, kPiece };

/// The network of Fig. 10 about a point v, in a step's own scale (hls/curves/spline.hpp): tau = s
/// / h runs over a step of h = 2^k units, q = (v' - v) 2^lambda / h is its parameter, W and 6a'
/// carry h / 2^lambda and its square. Drawn by the network's table in an arithmetic that carries
/// errors.
///
/// Each product passes on its factors' errors, each rounding adds half a last bit, each weight 1/i
/// that is no power of two half a last bit of its own. Each word is held against its range: those
/// of the anchor, of every order, the sums handed on to the next step, and a sample's.
///
/// For Anchor = 1. Source: load, anchor, orders, step and sample of hls/curves/spline.hpp.
class SplineWords : public Exact {
  public:
    using State = SplineState<Enclosed>;

    SplineWords(const CoreParameters& format, const Segment& segment);

    /// Opens a step at v, where v may be off by `drift`, and the last step's phi may differ from 1
    /// / |V| by a fraction of `prediction`.
    void anchor(double v, double drift, double prediction);
    /// Makes the network's words of order 0: V and W by axis, phi, and Q and R that follow from it.
    void open(const std::array<Enclosed, 3>& V, const std::array<Enclosed, 3>& W,
              const Enclosed& phi);
    /// Makes the words of orders 1 .. Order.
    void expand();
    /// Makes the words of samples in the first `fraction` of the step.
    void sample(double fraction);
    /// Hands on the sums: q's to v, which becomes `next` within `drift`, and phi's.
    void hand_on(double next, double drift);

    Shorten shorten() const { return shorten_; }

    /// The exact numbers of order 0, and the parameters 6a'.
    SplineState<double> state() const;
    std::array<double, 3> six_a() const;

    const Enclosed& q(int i) const { return series(spline_node::kU, i); }
    const Enclosed& phi(int i) const { return series(spline_node::kPhi, i); }
    const Enclosed& W(int axis, int i) const { return series(spline_node::kW, i, axis); }
    const Enclosed& x(int axis, int i) const { return series(spline_node::kX, i, axis); }
    int q_words() const { return q_words_; }  // q_1 .. q_n may differ from 0

    /// The sampler's words: V, B' and a'.
    const Enclosed& V(int axis) const { return state_[spline_node::kV + std::size_t(axis)]; }
    const Enclosed& half_W(int axis) const { return half_W_[std::size_t(axis)]; }
    const Enclosed& step_a(int axis) const { return step_a_[std::size_t(axis)]; }

    // The interpreter passes each number through these.
    Enclosed rate(std::size_t node, int order, const Enclosed& value);
    Enclosed coefficient(std::size_t node, int order, const Enclosed& value);

  private:
    const Enclosed& series(std::size_t node, int i, int axis = 0) const {
        return network_.series()[node + std::size_t(axis)][std::size_t(i)];
    }

    double half(int frac) const;  // half a last bit
    std::array<Enclosed, 3> constants();
    bool made(std::size_t node, int order) const;
    Enclosed rounded(const Enclosed& exact, int frac) const;
    const Enclosed& within(const Enclosed& word, int frac, Shorten otherwise);
    Enclosed word(const Enclosed& exact, int frac, Shorten otherwise);
    void place_origin(std::size_t axis, const Enclosed& v);
    Enclosed polished(const std::array<Enclosed, 3>& V, double prediction);
    void sample_axis(std::size_t axis, double low, double high);

    const int order_;
    const int bits_;
    const double last_bit_;  // 2^-CoefBits
    const bool polynomial_;
    const int shift_;  // lambda - k
    Shorten shorten_ = Shorten::kNothing;
    std::array<Enclosed, 3> a_, b_, c_, three_a_, step_a_{}, six_a_, half_W_{};
    State state_{};
    NetworkInterpreter<Enclosed, kSpline.size(), 3> network_;
    std::array<Enclosed, kSpline.size()> rate_{};  // rates of this order
    int q_words_ = 1;
};

}  // namespace curvecore::ref
