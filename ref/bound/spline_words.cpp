// SPDX-License-Identifier: Apache-2.0
// Fraction bits are counted from W = CoefBits: `frac` stands for a word with W + frac of them.
#include "ref/bound/spline_words.hpp"

#include <algorithm>

namespace curvecore::ref {
namespace {

constexpr int kA = -2;  // coefficients
constexpr int kU = -1;  // tau, v, V, weights
constexpr int kW = 1;   // W, 6a', DV, DP
constexpr int kS = -3;  // phi^2
constexpr int kQ = -4;
constexpr int kR = -5;

constexpr int kNoWord = 99;

/// The words of a node, hls/curves/spline.hpp: fraction bits of its D_i and of its x_i, and the
/// order, below Order, up to which they are made.
struct NodeWords {
    int rate = kNoWord;
    int coefficient = kNoWord;
    int below = 0;
};

constexpr std::array<NodeWords, kSpline.size()> node_words() {
    std::array<NodeWords, kSpline.size()> words{};
    words[kSpline.node("u")] = {kNoWord, kA, 0};  // its rate is phi's word
    words[kSpline.node("P")] = {kW, kNoWord, 1};
    words[kSpline.node("phi")] = {0, kA, 1};
    words[kSpline.node("Q")] = {kQ, kQ, 2};
    words[kSpline.node("R")] = {kNoWord, kR, 2};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        words[kSpline.node("Wx") + axis] = {kNoWord, kW, 2};
        words[kSpline.node("Vx") + axis] = {kW, kU, 1};
        words[kSpline.node("Px") + axis] = {kW, kNoWord, 1};
        words[kSpline.node("x") + axis] = {kA, kA, 0};
    }
    return words;
}
constexpr std::array<NodeWords, kSpline.size()> kWords = node_words();

/// Bound of every word of that format.
constexpr double limit(int frac) { return frac < 0 ? 1 << (-1 - frac) : 0.5 / (1 << frac); }

bool power_of_two(int i) { return (i & (i - 1)) == 0; }

/// The word of the segment that holds `exact`.
Enclosed quantised(double exact, int frac) {
    const double word = std::ldexp(std::floor(std::ldexp(exact, frac) + 0.5), -frac);
    return {exact, 0, std::abs(word - exact)};
}

std::array<Enclosed, 3> quantised(const Vec3& exact, int frac) {
    return {quantised(exact[0], frac), quantised(exact[1], frac), quantised(exact[2], frac)};
}

}  // namespace

SplineWords::SplineWords(const CoreParameters& format, const Segment& segment)
    : order_(format.order),
      bits_(format.coef_bits),
      last_bit_(std::ldexp(1.0, -bits_)),
      polynomial_(format.polynomial()),
      shift_(segment.spline().lambda - segment.step_exponent),
      a_(quantised(segment.spline().a, bits_ + kA)),
      b_(quantised(segment.spline().b, bits_ + kA)),
      c_(quantised(segment.spline().c, bits_ + kA)),
      three_a_{3 * a_[0], 3 * a_[1], 3 * a_[2]},
      six_a_(constants()),
      network_(kSplineWiring, order_, six_a_) {}

/// a' and 6a' of the load.
std::array<Enclosed, 3> SplineWords::constants() {
    const double square = std::ldexp(1.0, -2 * shift_);
    std::array<Enclosed, 3> six_a;
    for (std::size_t k = 0; k < 3; ++k) {
        within(three_a_[k], kA, Shorten::kPiece);
        step_a_[k] = square * a_[k];
        if (shift_ > 0) step_a_[k] = rounded(step_a_[k], kU);
        within(step_a_[k], kU, Shorten::kSteps);
        six_a[k] = 2 * square * three_a_[k];
        if (shift_ > 2) six_a[k] = rounded(six_a[k], kW);
        within(six_a[k], kW, Shorten::kSteps);
    }
    return six_a;
}

double SplineWords::half(int frac) const { return limit(frac) * last_bit_; }

/// Adds half a last bit of error. A word below half a last bit is 0, and wrong by its value.
Enclosed SplineWords::rounded(const Enclosed& exact, int frac) const {
    const bool vanishes = exact.reach() < half(frac);
    return {exact.value, vanishes ? exact.size() : exact.rounding + half(frac), exact.drift};
}

const Enclosed& SplineWords::within(const Enclosed& word, int frac, Shorten otherwise) {
    if (!(word.reach() < limit(frac))) shorten_ = std::max(shorten_, otherwise);
    return word;
}

Enclosed SplineWords::word(const Enclosed& exact, int frac, Shorten otherwise) {
    return within(rounded(exact, frac), frac, otherwise);
}

void SplineWords::anchor(double place, double drift, double prediction) {
    const Enclosed v(place, 0, drift);
    const double per_step = std::ldexp(1.0, -shift_);
    std::array<Enclosed, 3> V, W;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto piece = Shorten::kPiece;
        const Enclosed bend = three_a_[k] * v;
        const Enclosed slope = within(b_[k] + rounded(bend, kA), kA, piece);
        const Enclosed mean = within(b_[k] + rounded(bend / 2, kA), kA, piece);
        V[k] = within(c_[k] + rounded(2 * mean * v, kU), kU, piece);
        W[k] = 2 * per_step * slope;
        if (shift_ > 4) W[k] = rounded(W[k], kW);
        half_W_[k] = word(W[k] / 2, kU, Shorten::kSteps);
        place_origin(k, v);
    }
    open(V, W, polished(V, prediction));
}

/// The place of the step: e = a v + b, f = e v + c, d = f v.
void SplineWords::place_origin(std::size_t k, const Enclosed& v) {
    const auto piece = Shorten::kPiece;
    const Enclosed e = within(b_[k] + rounded(a_[k] * v, kA), kA, piece);
    const Enclosed f = within(c_[k] + rounded(e * v, kA), kA, piece);
    word(f * v, kA, piece);
}

/// Newton's step from a phi that is (1 + prediction) / |V|. m and z know |V| by that phi.
/// What the prediction missed is squared.
Enclosed SplineWords::polished(const std::array<Enclosed, 3>& V, double prediction) {
    Enclosed norm;
    double along = 0, off = 0;  // V . e(V); |e(V)|^2 of the drift
    for (const Enclosed& axis : V) {
        norm += axis * axis;
        along += axis.size() * axis.rounding;
        off += axis.drift * axis.drift;
    }
    word(norm, kU, Shorten::kPiece);
    const double speed = std::sqrt(norm.value);
    const double p = 1 / speed;
    const double drift = std::sqrt(off);
    const double m = 2 * p * along + (1 + p) * half(kU);
    within({speed, m, drift + (speed + drift) * prediction}, kU, Shorten::kSteps);
    within({0, p * m + half(3), (2 + prediction) * prediction}, 3, Shorten::kSteps);
    const double rounding = p * p * p * along + p * p * (p + 1) / 2 * half(kU) + p / 2 * half(3) +
                            half(kA) + 1.5 * p * prediction * prediction * (1 + prediction);
    const Enclosed phi(p, rounding, p / std::max(0.0, 1 - p * drift) - p);
    return within(phi, kA, Shorten::kPiece);
}

void SplineWords::open(const std::array<Enclosed, 3>& V, const std::array<Enclosed, 3>& W,
                       const Enclosed& phi) {
    const auto piece = Shorten::kPiece;
    const Enclosed square = word(phi * phi, kS, piece);
    state_ = State{};
    for (std::size_t k = 0; k < 3; ++k) {
        state_[spline_node::kV + k] = V[k];
        state_[spline_node::kW + k] = within(W[k], kW, Shorten::kSteps);
    }
    state_[spline_node::kPhi] = phi;
    state_[spline_node::kQ] = word(-(square * phi), kQ, piece);
    state_[spline_node::kR] = word(-3 * square, kR, piece);
}

void SplineWords::expand() {
    q_words_ = 1;
    network_.expand(state_, *this);
}

bool SplineWords::made(std::size_t node, int order) const {
    const bool x = node >= spline_node::kX && node < spline_node::kX + 3;
    return order <= order_ - kWords[node].below && !(x && polynomial_);
}

Enclosed SplineWords::rate(std::size_t node, int order, const Enclosed& exact) {
    const int frac = kWords[node].rate;
    Enclosed& word = rate_[node];
    word = exact;
    if (frac == kNoWord) return word;
    if (node != spline_node::kSum) word = rounded(word, frac);  // a sum of words is one
    if (made(node, order)) within(word, frac, Shorten::kSteps);
    return word;
}

Enclosed SplineWords::coefficient(std::size_t node, int order, const Enclosed& exact) {
    const NodeWords& words = kWords[node];
    if (words.coefficient == kNoWord) return exact;
    const bool divided = words.rate != kNoWord || node == spline_node::kU;
    Enclosed word = exact;
    if (divided && !power_of_two(order)) {
        word.rounding += rate_[node].size() * half(kU);  // rounding of the weight
    }
    if (node == spline_node::kR) {  // -3 S, and S is a word
        word.rounding += 3 * half(kS);
        within(word / 3, kS, Shorten::kSteps);
    }
    const bool same = order == 1 && (node == spline_node::kU || words.rate == words.coefficient);
    if (!same) word = rounded(word, words.coefficient);
    if (made(node, order)) within(word, words.coefficient, Shorten::kSteps);
    if (node == spline_node::kU && word.size() + word.rounding > half(kA)) {
        q_words_ = order;
    }
    return word;
}

namespace {

/// The interval low .. high.
struct Span {
    double low = 0, high = 0;

    Span wider(double by) const { return {low - by, high + by}; }
    double reach() const { return std::max(-low, high); }
};

Span operator+(const Enclosed& word, const Span& more) {
    return Span{word.value + more.low, word.value + more.high}.wider(word.error());
}

Span operator*(const Span& a, const Span& b) {
    const double products[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return {*std::min_element(products, products + 4), *std::max_element(products, products + 4)};
}

}  // namespace

void SplineWords::sample(double fraction) {
    const Span tau{0, fraction};
    const auto stage = [&](const Span& sum, int frac) {
        within({sum.reach()}, frac, Shorten::kSteps);
        return sum;
    };
    const auto horner = [&](std::size_t node) {
        Span sum;
        for (int i = order_; i >= 1; --i) {
            sum = stage(series(node, i) + sum, kA);
            sum = (sum * tau).wider(half(kA));
        }
        return sum;
    };
    if (!polynomial_) {
        for (std::size_t k = 0; k < 3; ++k) horner(spline_node::kX + k);
        return;
    }
    const Span q = horner(spline_node::kU);
    for (std::size_t k = 0; k < 3; ++k) {
        const Span a = step_a_[k] + Span{};
        const Span e = stage(half_W_[k] + (a * q).wider(half(kU)), kU);
        const Span f = stage(state_[spline_node::kV + k] + (e * q).wider(half(kU)), kU);
        stage((f * q).wider(half(kU)), kA);
    }
}

void SplineWords::hand_on(double next, double drift) {
    Enclosed moved, phi = state_[spline_node::kPhi];
    for (int i = 1; i <= order_; ++i) moved += q(i);
    for (int i = 1; i < order_; ++i) phi += this->phi(i);
    within(moved, kA, Shorten::kSteps);
    within(phi, kA, Shorten::kSteps);
    within({next, 0, drift}, kU, Shorten::kPiece);
}

SplineState<double> SplineWords::state() const {
    SplineState<double> exact{};
    std::transform(state_.begin(), state_.end(), exact.begin(),
                   [](const Enclosed& word) { return word.value; });
    return exact;
}

std::array<double, 3> SplineWords::six_a() const {
    return {six_a_[0].value, six_a_[1].value, six_a_[2].value};
}

}  // namespace curvecore::ref
