// SPDX-License-Identifier: Apache-2.0
#include "ref/series/paper_words.hpp"

#include <algorithm>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr int kPlaces = 1000;

/// Fraction bits of a word that holds values up to `most` and one bit more.
int fraction_bits(double most, int coef_bits) {
    int exponent = 0;
    std::frexp(most, &exponent);
    return coef_bits - 2 - exponent;
}

}  // namespace

PaperWords::Words::Words(const Cubic& cubic, int coef_bits)
    : limit(std::ldexp(1.0, coef_bits - 1)) {
    NetworkInterpreter<double, kSpline.size(), 3> network(kSpline, 1,
                                                          spline_parameters<double>(cubic));
    SplineState<double> most{};
    for (int i = 0; i <= kPlaces; ++i) {
        const auto& series = network.expand(spline_state(cubic, static_cast<double>(i) / kPlaces));
        for (std::size_t node = 0; node < most.size(); ++node) {
            for (const double value : series[node]) {
                most[node] = std::max(most[node], std::abs(value));
            }
        }
    }
    for (std::size_t node = 0; node < most.size(); ++node) {
        frac[node] = fraction_bits(most[node], coef_bits);
    }
}

PaperWords::Real PaperWords::Words::keep(std::size_t node, const Real& value) {
    const Real word = floor(ldexp(value, frac[node]) + 0.5);
    overflow = overflow || !(word >= -limit && word < limit);
    return ldexp(word, -frac[node]);
}

PaperWords::Axes PaperWords::parameters(const Cubic& cubic, int coef_bits) {
    const int frac = fraction_bits(6 * cubic.a.cwiseAbs().maxCoeff(), coef_bits);
    Axes six_a = spline_parameters<Real>(cubic);
    for (Real& word : six_a) word = ldexp(floor(ldexp(word, frac) + 0.5), -frac);
    return six_a;
}

PaperWords::PaperWords(const Cubic& cubic, int order, int coef_bits, double u0, double step)
    : cubic_{cubic.a / step, cubic.b / step, cubic.c / step, Vec3::Zero()},
      start_(cubic.d),
      unit_(step),
      words_(cubic_, coef_bits),
      network_(kSpline, order, parameters(cubic_, coef_bits)),
      state_(spline_state(cubic_, Real(u0))) {
    for (std::size_t node = 0; node < state_.size(); ++node) {
        state_[node] = words_.keep(node, state_[node]);
    }
}

bool PaperWords::step() {
    const auto& series = network_.expand(state_, words_);
    for (std::size_t node = 0; node < state_.size(); ++node) {
        Real sum(0);
        for (const Real& term : series[node]) sum += term;
        state_[node] = words_.keep(node, sum);
    }
    return !words_.overflow;
}

Vec3 PaperWords::position() const {
    Vec3 place;
    for (std::size_t k = 0; k < 3; ++k) {
        place[static_cast<Eigen::Index>(k)] = static_cast<double>(state_[spline_node::kX + k]);
    }
    return start_ + unit_ * place;
}

}  // namespace curvecore::ref
