// SPDX-License-Identifier: Apache-2.0
// The bound, term by term, in the order in which hls/curves/spline.hpp makes the errors.
//
// Letters: W coefficient width, P order, G guard bits; L = 2^lambda units; h = 2^k units per step;
// f, the fraction of a step that the segment uses; T = V / |V|.
//
// Errors are of two kinds. An error of v is one along the path, and the equation dv/ds = 1/|V(v)|
// does not contain s: a shift along the path stays as long as it is, however fast the curve goes
// on. So the shifts of all steps add up, and an axis sees |T_axis| of them. All other errors belong
// to one sample: the anchor makes each step's curve afresh from the polynomial.
//
// With ParameterGuard v adds up finely and a step starts d away from it, where v is rounded for the
// products. That is a shift of this step alone; but it keeps its length in path and is put back as
// a length in v, so that unit d (|V| - |V at the step's end|) of it stays.
#include "ref/bound/spline_bound.hpp"

#include <algorithm>
#include <cmath>

#include "ref/format/path_words.hpp"

namespace curvecore::ref {
namespace {

constexpr int kTail = 6;  // orders above P that are summed one by one

/// The real number that a coefficient's word stands for, less what it should be.
Vec3 word_error(const Vec3& exact, int frac) {
    Vec3 error;
    for (int k = 0; k < 3; ++k) {
        error[k] = std::ldexp(std::floor(std::ldexp(exact[k], frac) + 0.5), -frac) - exact[k];
    }
    return error;
}

/// The polynomial alone, drawn by a parameter: no series of x, y and z.
struct AsDrawn : Exact {
    explicit AsDrawn(const CoreParameters& format) : polynomial(format.polynomial()) {}
    bool asks(std::size_t node, int /*order*/) const {
        return !polynomial || node < spline_node::kX || node >= spline_node::kX + 3;
    }

    bool polynomial;
};

class Walk {
  public:
    Walk(const CoreParameters& format, const Segment& segment)
        : format_(format),
          segment_(segment),
          spline_(segment.spline()),
          unit_(std::ldexp(1.0, spline_.lambda)),
          h_(std::ldexp(1.0, segment.step_exponent)),
          g_(half_bit(format.guard_bits)),
          words_(format, segment),
          a_(word_error(spline_.a, format.coef_bits - 2)),
          b_(word_error(spline_.b, format.coef_bits - 2)),
          c_(word_error(spline_.c, format.coef_bits - 2)),
          network_(kSplineWiring, format.order + kTail, words_.six_a()) {}

    SplineError run(double give_up) {
        const double steps = static_cast<double>(segment_.length) * kQuantum / h_;
        give_up_ = give_up;
        for (double done = 0; done < steps; ++done) {
            const double fraction = std::min(1.0, steps - done);
            step(fraction, done + 1 < steps);
            result_.shorten = std::max(words_.shorten(), result_.shorten);
            if (result_.shorten != Shorten::kNothing || given_up()) return result_;
        }
        for (const double advance : segment_.aux_advance) {
            auxiliary(advance, steps);
        }
        return result_;
    }

  private:
    bool given_up() const {
        return result_.total() > give_up_ || result_.along > kAlongShare * give_up_;
    }

    /// Adds one integration step: its sample's errors to the result, its shifts to the sums.
    void step(double f, bool another) {
        const int order = format_.order;
        words_.anchor(v_, drift(), prediction_);
        if (words_.shorten() != Shorten::kNothing || !converges()) return;
        network_.expand(words_.state(), AsDrawn(format_));
        const double q_end = powers(series(spline_node::kU), f);
        const double next = v_ + h_ / unit_ * q_end;
        const Vec3 velocity = V(v_);
        const Vec3 velocity_end = V(next);
        const double turn = (velocity_end - velocity).squaredNorm();
        const double speed =
            std::min(1.0, std::max(velocity.norm(), velocity_end.norm()) + turn / 2);

        // A series cut after P: if its error is too large, no word is asked.
        const double cut = tail(series(spline_node::kU), f) * speed * h_;
        result_.along = std::max(result_.along, shift_truncation_ + cut);
        if (given_up()) return;
        words_.expand();
        words_.sample(f);
        if (words_.shorten() != Shorten::kNothing) return;

        // The cubic's words: another curve at the same v, and another path length up to it.
        const double moved = next - v_;
        const double along = std::max(std::abs(velocity.normalized().dot(V_error(v_))),
                                      std::abs(velocity_end.normalized().dot(V_error(next))));
        shift_rounding_ += unit_ * along * moved;

        // The words q_i.
        double words = 0;
        double power = 1;
        for (int i = 1; i <= order; ++i) words += words_.q(i).rounding * (power *= f);
        sample(f, q_end, cut, words * speed * h_, speed, velocity, velocity_end);
        if (!another) return;

        // On to the next step: the same at f = 1.
        shift_truncation_ += cut;
        shift_rounding_ += words * speed * h_;
        v_ = next;
        const double end_speed = velocity_end.norm();
        const double rounded = round_parameter(velocity.norm(), end_speed);
        predict(rounded + (words * h_ + cut / speed) / unit_, end_speed);
        words_.hand_on(v_, drift());
        // Tries the best prediction: if that fails as well, the piece is too slow or too bent
        // there.
        if (words_.shorten() == Shorten::kSteps) words_.anchor(v_, drift(), 0);
    }

    /// Bound of v's error by the shifts along the path.
    double drift() const {
        return (shift_truncation_ + shift_rounding_ + shown_rounding_) / (unit_ * V(v_).norm());
    }

    /// A step goes at most half the way to where the series may cease to converge: |W| d + 3 |a|
    /// d^2 = (sqrt 2 - 1) |V| for some d in q, and h = |V| d / 2.
    bool converges() {
        const SplineState<double> state = words_.state();
        const auto vector = [](const double* x) { return Vec3(x[0], x[1], x[2]); };
        const Vec3 V = vector(&state[spline_node::kV]);
        const Vec3 W = vector(&state[spline_node::kW]);
        const Vec3 six_a = vector(words_.six_a().data());
        const double speed = V.norm();
        const double d = 2 / speed;
        const bool near = W.norm() * d + six_a.norm() / 2 * d * d <= (std::sqrt(2.0) - 1) * speed;
        if (!near) result_.shorten = Shorten::kSteps;
        return near;
    }

    /// Rounds v, unless the shift is exact; returns its distance from where phi is predicted.
    double round_parameter(double from_speed, double speed) {
        const int guard = format_.parameter_guard;
        const int shift = spline_.lambda - segment_.step_exponent - 1;
        const double half = shift > 0 ? half_bit(format_.coef_bits - 1) : 0;
        if (shown_rounding_ > 0) shift_rounding_ += unit_ * half * std::abs(from_speed - speed);
        if (shift > guard) shift_rounding_ += std::ldexp(unit_ * half * speed, -guard);
        shown_rounding_ = guard > 0 ? unit_ * half * speed : 0;
        return guard > 0 ? 2 * half : half;
    }

    /// Predicts the relative error of the series' last phi against 1 / |V| of a v that is `aside`
    /// of it.
    void predict(double aside, double speed) {
        prediction_ = aside * bend() / speed;
        for (int i = 0; i <= format_.order + kTail; ++i) {
            const bool made = i < format_.order;
            const double exact = series(spline_node::kPhi)[static_cast<std::size_t>(i)];
            prediction_ += speed * (made ? words_.phi(i).rounding : std::abs(exact));
        }
    }

    void sample(double f, double q, double cut, double words, double speed, const Vec3& velocity,
                const Vec3& velocity_end) {
        const int width = format_.coef_bits;
        const double half = half_bit(width - 2);
        const double fine = half_bit(width - 1);
        // tau is cut to W-1 bits, of whole quanta; the length is a difference of rounded lengths.
        const double along = std::max(0.0, h_ * 2 * fine - kQuantum) + kQuantum + shift_rounding_ +
                             shown_rounding_ + words +
                             (format_.polynomial() ? words_.q_words() * half * speed * h_ : 0);
        result_.along_rounding = std::max(result_.along_rounding, along);
        result_.along = std::max(result_.along, along + shift_truncation_ + cut);
        const Vec3 tangent = velocity.normalized();
        const Vec3 tangent_end = velocity_end.normalized();
        const double sagitta = (tangent_end - tangent).squaredNorm() / 4;
        const double shown = v_ + q * h_ / unit_;
        SplineError worst;
        for (int k = 0; k < 3; ++k) {
            const double share =
                std::min(1.0, std::max(std::abs(tangent[k]), std::abs(tangent_end[k])) + sagitta);
            const std::size_t axis = static_cast<std::size_t>(k);
            const double aside = format_.polynomial() ? polynomial(k, q) : horner(k, f);
            const double curve =
                unit_ * std::abs(((a_[k] * shown + b_[k]) * shown + c_[k]) * shown);
            SplineError error;
            error.rounding = share * along + curve + h_ * aside + origin(k);
            error.truncation =
                share * shift_truncation_ +
                (format_.polynomial() ? share * cut : h_ * tail(series(spline_node::kX + axis), f));
            if (error.total() > worst.total()) worst = error;
        }
        if (worst.total() > result_.total()) {
            result_.truncation = worst.truncation;
            result_.rounding = worst.rounding;
        }
    }

    /// Errors of e = B' + a' q, f = V + e q, d = f q: those of the words and one rounding each.
    double polynomial(int k, double q) const {
        const int width = format_.coef_bits;
        const bool bent = spline_.a[k] != 0;
        const bool turned = bent || spline_.b[k] != 0;
        const double e = words_.half_W(k).rounding + words_.step_a(k).rounding * q +
                         (bent ? half_bit(width - 1) : 0);
        const double f = words_.V(k).rounding + e * q + (turned ? half_bit(width - 1) : 0);
        return f * q + half_bit(width - 2);
    }

    /// Error of the axis' own series: its words, and a Horner stage for each that is not 0.
    double horner(int k, double f) const {
        const double half = half_bit(format_.coef_bits - 2);
        double sum = 0;
        double power = 1;
        int stages = 1;
        for (int i = 1; i <= format_.order; ++i) {
            const Enclosed& x = words_.x(k, i);
            sum += x.rounding * (power *= f);
            if (x.size() + x.rounding > half) stages = i;
        }
        return sum + stages * half;
    }

    /// Errors of the start word, three products of the origin, two shifts to fine positions (no
    /// exact one).
    double origin(int k) const {
        const double half = half_bit(format_.coef_bits - 2);
        const int exact = format_.coef_bits - 2 - format_.guard_bits;
        double error = g_ + (segment_.step_exponent < exact ? g_ : 0);
        if (v_ == 0) return error;
        const bool bent = spline_.a[k] != 0;
        const bool turned = bent || spline_.b[k] != 0;
        error += spline_.lambda < exact ? g_ : 0;
        return error + unit_ * half * (1 + (turned ? v_ : 0) + (bent ? v_ * v_ : 0));
    }

    void auxiliary(double advance, double steps) {
        if (advance == 0) return;
        const double word = half_bit(format_.coef_bits - 2);
        const double m = std::max(0.0, std::ceil(steps) - 1);
        const bool exact = segment_.step_exponent >= format_.coef_bits - 2 - format_.guard_bits;
        const double shift = std::max(0.0, h_ * word - kQuantum) + kQuantum;  // along the path
        const double error = h_ * (steps * word + word) + g_ + (exact ? 0 : (m + 1) * g_) +
                             std::max(1.0, std::abs(advance)) * shift;
        if (error > result_.total()) {
            result_.truncation = 0;
            result_.rounding = error;
        }
    }

    /// Sum of the orders above P at tau = f, and of a geometric rest.
    double tail(const Series<double>& terms, double f) const {
        const std::size_t first = static_cast<std::size_t>(format_.order) + 1;
        const std::size_t last = first + kTail - 1;
        double sum = 0;
        double power = std::pow(f, static_cast<double>(first));
        for (std::size_t i = first; i < last; ++i, power *= f) sum += std::abs(terms[i]) * power;
        // The singularity is at least two steps away: the rest is at most the last term again.
        return sum + 2 * std::abs(terms[last]) * power;
    }

    /// Sum of all orders at tau = f except order 0.
    static double powers(const Series<double>& terms, double f) {
        double sum = 0;
        for (std::size_t i = terms.size() - 1; i >= 1; --i) sum = (sum + terms[i]) * f;
        return sum;
    }

    const Series<double>& series(std::size_t node) const { return network_.series()[node]; }
    double bend() const { return (2 * spline_.b + 6 * v_ * spline_.a).norm(); }  // |dV/dv|
    Vec3 V(double v) const { return spline_.c + v * (2 * spline_.b + 3 * v * spline_.a); }
    Vec3 V_error(double v) const { return c_ + v * (2 * b_ + 3 * v * a_); }

    const CoreParameters& format_;
    const Segment& segment_;
    const SplinePiece& spline_;
    double unit_, h_, g_;
    SplineWords words_;
    Vec3 a_, b_, c_;
    double give_up_ = 0;
    double v_ = 0;
    double prediction_ = 0;
    double shift_truncation_ = 0;
    double shift_rounding_ = 0;
    double shown_rounding_ = 0;  // rounding of v in this step's products
    NetworkInterpreter<double, kSpline.size(), 3> network_;
    SplineError result_;
};

}  // namespace

SplineError spline_error(const CoreParameters& format, const Segment& segment, double give_up) {
    return Walk(format, segment).run(give_up);
}

}  // namespace curvecore::ref
