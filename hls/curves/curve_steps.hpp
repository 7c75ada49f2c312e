// SPDX-License-Identifier: Apache-2.0
// A kernel that is made of a table (ref/curves/curve_table.hpp) stands on this: where a segment and
// a step begin, its auxiliary axes, and how a line is rounded. The kernels of this folder are made,
// by target curve_kernels; kernel_text.hpp writes them.
#pragma once

#include "hls/sampling.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

/// A format with the further words of a table's segments.
template <class C, int Words>
struct WithFurther : C {
    static constexpr int kFurtherWords = Words;
    using Further = typename C::Coef[Words == 0 ? 1 : Words];
};

template <class C>
class CurveSteps : protected C {
  protected:
    using Coef = typename C::Coef;
    using Fine = typename C::Fine;
    using Product = typename C::Product;

    using FineParameter = typename C::FineParameter;

    CurveSteps() = default;
    /// `rows`: of the table, up to one without a name.
    CurveSteps(const C& format, const char* curve, const WordRow* rows) : C(format) {
        C::note_rows(curve, rows);
    }

    /// A word of a row, as the format keeps it.
    template <class Row>
    Coef keep(Row row, int order, const Coef& word) const {
        return C::keep(static_cast<int>(row), order, word);
    }

    void open(const SegmentWords<C>& segment) {
        k_ = segment.step_exponent;
        lambda_ = segment.lambda;
        for (int axis = 0; axis < C::kAxes; ++axis) {
            start_[axis] = segment.start[axis];
            origin_[axis] = segment.start[axis];
            if (axis >= 3) rate_[axis] = segment.advance[axis];
        }
    }
    /// Steps between this one's scale and the segment's: s = lambda - k.
    int down() const { return lambda_ - k_; }

    void move_auxiliary() {
        for (int axis = 3; axis < C::kAxes; ++axis) {
            origin_[axis] = Fine(origin_[axis] + to_fine<C>(*this, rate_[axis], k_));
        }
    }
    void move_origin(const Coef* move) {
        for (int axis = 0; axis < 3; ++axis) {
            origin_[axis] = Fine(origin_[axis] + to_fine<C>(*this, move[axis], k_));
        }
    }
    void place_origin(const Coef* place) {
        for (int axis = 0; axis < 3; ++axis) {
            origin_[axis] = Fine(start_[axis] + to_fine<C>(*this, place[axis], lambda_));
        }
    }
    Coef tau_of(const Word<kLengthBits + 1>& offset) const { return to_tau<C>(*this, offset, k_); }
    /// Sets the fine position d into the step.
    void draw(const Coef* d, const Coef& tau, Fine* out) const {
        for (int axis = 0; axis < C::kAxes; ++axis) {
            const Coef by = axis < 3 ? d[axis] : rounded(times(rate_[axis], tau), C::kUnitFrac);
            out[axis] = Fine(origin_[axis] + to_fine<C>(*this, by, k_));
        }
    }

    /// The one rounding of a line.
    template <class Sum>
    static Coef rounded(const Sum& sum, int shift) {
        return Coef(round_shift(Product(sum), shift));
    }
    /// The same of a line with `>>`, whose bits hold the sum with `lift` bits more.
    template <int Bits, class Out = Coef, class Sum>
    static Out scaled_down(const Sum& sum, int lift, int shift) {
        return Out(round_shift(Word<Bits>(Word<Bits>(sum) * (Word<Bits>(1) << lift)), shift));
    }
    /// A word with ParameterGuard fraction bits more, and one without them again.
    FineParameter guarded(const Coef& word) const {
        return FineParameter(FineParameter(word) * (FineParameter(1) << C::kParameterGuard));
    }
    Coef unguarded(const FineParameter& word) const {
        return Coef(round_shift(word, C::kParameterGuard));
    }
    template <class Term>
    static Product lifted(const Term& term, int by) {
        return Product(Product(term) * (Product(1) << by));
    }

    static Product times(const Coef& a, const Coef& b) { return Product(Product(a) * Product(b)); }
    /// a/i, with CoefBits - 1 fraction bits more; exact where i is 1.
    Product over(const Coef& a, int i) const {
        return Product(Product(a) * Product(reciprocal(i, C::kUnitFrac)));
    }
    static Coef before(const Coef* row, int i) { return i < 0 ? Coef(0) : row[i]; }
    /// An order that is named; 0 above Order.
    Coef named(const Coef* row, int order) const {
        return order <= C::kOrder ? row[order] : Coef(0);
    }
    /// Order n of a product of two series.
    static Product series_times(const Coef* a, const Coef* b, int n) {
        return convolved(a, b, n, n);
    }
    /// Order n of a Stieltjes integral, before its 1/n: the sum of u_j Ds_{n-j}, j < n.
    static Product stieltjes(const Coef* u, const Coef* ds, int n) {
        return convolved(u, ds, n, n - 1);
    }
    /// The sum of orders 1 .. last: how far a series goes in a step.
    static Product sum(const Coef* row, int last) {
        Product all = 0;
        for (int i = 1; i <= last; ++i) all = Product(all + Product(row[i]));
        return all;
    }
    /// The polynomial of orders last, last - by .. first in x, each product rounded once. Its sums
    /// are kept as orders of their row.
    template <class Row>
    Coef horner(Row of, const Coef* row, const Coef& x, int first, int last, int by,
                int shift) const {
        Coef all = row[last];
        for (int i = last - by; i >= first; i -= by) {
            all = keep(of, i, Coef(row[i] + rounded(times(all, x), shift)));
        }
        return all;
    }
    template <class Row>
    Coef in_tau(Row of, const Coef* row, const Coef& tau) const {
        const Coef all = horner(of, row, tau, 1, C::kOrder, 1, C::kUnitFrac);
        return rounded(times(all, tau), C::kUnitFrac);
    }
    template <class Row>
    Coef odd(Row of, const Coef* row, const Coef& x, int shift) const {
        return horner(of, row, x, 1, C::kOrder - 1 + C::kOrder % 2, 2, shift);
    }
    template <class Row>
    Coef even(Row of, const Coef* row, const Coef& x, int shift) const {
        const Coef all = horner(of, row, x, 2, C::kOrder - C::kOrder % 2, 2, shift);
        return rounded(times(all, x), shift);
    }

    Fine origin_[C::kMostAxes] = {};  // of the step

  private:
    static Product convolved(const Coef* a, const Coef* b, int n, int last) {
        Product all = 0;
        for (int j = 0; j <= last; ++j) {
            all = Product(all + times(a[j], b[n - j]));
        }
        return all;
    }

    int k_ = 0;
    int lambda_ = 0;
    Fine start_[C::kMostAxes] = {};
    Coef rate_[C::kMostAxes] = {};  // of auxiliary axes
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
