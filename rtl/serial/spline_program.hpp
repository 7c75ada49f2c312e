// SPDX-License-Identifier: Apache-2.0
// Cubics at constant path speed as a program for one multiplier: [Chikurov] Fig. 10 with anchors,
// every word as in hls/curves/spline.hpp. A Stieltjes node is one word
// per order, which the sequencer repeats for every product.
#pragma once

#include "rtl/serial/arc_program.hpp"
#include "rtl/serial/spline_places.hpp"

namespace curvecore::serial {

inline Word sum_of(Address d, Address a, Address b, Scale scale) {
    Word word = make(d, kZero, a, b, scale);
    word.repeat = true;
    return word;
}
inline Word part_of_sum(Address a, Address b) {
    Word word;
    word.a = a;
    word.b = b;
    word.more = true;
    return word;
}
inline Word over_order(Address d, Address a, Scale scale) {
    Word word = make(d, kZero, a, kReciprocal, scale);
    word.first = true;
    return word;
}
inline Word marked(Word word) {
    word.mark = true;
    return word;
}
inline Word waiting(Word word) {
    word.wait = true;
    return word;
}
inline void add(Words& words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
}
template <class Make>
Words for_axes(Make&& word) {
    return {word(0), word(1), word(2)};
}

/// Makes the words that a segment's steps share, and v and phi of its start.
inline void spline_load(Program& program) {
    Words words = for_axes(
        [](int axis) { return make(three_a(axis), a_of(axis), a_of(axis), kOne, kLessThree); });
    words.back().mark = true;
    add(words, for_axes([](int axis) {
            return make(two_c(axis), kZero, advance(axis), kOne, kLessThree);
        }));
    words.push_back(make(kLowerV, kZero, kZero, kZero));
    words.push_back(make(in_row(kPhi), kZero, kTheta, kOne, kCoef));
    add(words, for_axes([](int axis) {
            return make(step_a(axis), kZero, a_of(axis), right(kAScale), kUnit);
        }));
    Words scaled = for_axes([](int axis) {
        return make(six_a(axis), kZero, three_a(axis), right(kThreeAScale), kUnit);
    });
    scaled.front().wait = true;
    add(words, scaled);
    add(words, for_axes([](int axis) {
            return make(step_a(axis), step_a(axis), a_of(axis), left(kAScale), kLessSix);
        }));
    add(words, for_axes([](int axis) {
            return make(six_a(axis), six_a(axis), three_a(axis), left(kThreeAScale), kLessSix);
        }));
    words.back().mark = true;
    program.frame(words, kHalt);
}

/// Moves v and phi a step farther; i = Order.
inline void spline_step(Program& program) {
    Words words{marked(sum_of(kMoved, above(in_row(kLowerQ, kInner)), kOne, kCoef)),
                sum_of(in_row(kPhi), in_row(kPhi, kInner), kOne, kCoef),
                waiting(make(kLowerV, kLowerV, kMoved, right(kMovedScale)))};
    add(words, auxiliary_origins());
    words.insert(words.begin() + 7,
                 marked(make(kLowerV, kLowerV, kMoved, left(kMovedScale), kLessSix)));
    program.frame(words, kHalt);
}

/// Makes V, W, phi, S, Q and the origin of v.
inline Words anchor() {
    Words words = for_axes(
        [](int axis) { return make(mean(axis), b_of(axis), three_a(axis), kLowerV, kSame); });
    words.front().wait = true;
    words.back().mark = true;
    add(words,
        for_axes([](int axis) { return make(slope(axis), b_of(axis), three_a(axis), kLowerV); }));
    add(words,
        for_axes([](int axis) { return make(e_of(axis), b_of(axis), a_of(axis), kLowerV); }));
    Words speed = for_axes([](int axis) {
        return make(in_row(kV + axis), two_c(axis), mean(axis), kLowerV, kLessThree);
    });
    speed.front().wait = true;
    speed.back().mark = true;
    add(words, speed);
    add(words, for_axes([](int axis) {
            return make(in_row(kW + axis), kZero, slope(axis), right(kSlopeScale));
        }));
    add(words,
        for_axes([](int axis) { return make(f_of(axis), advance(axis), e_of(axis), kLowerV); }));
    const Address V[3] = {in_row(kV), in_row(kV + 1), in_row(kV + 2)};
    add(words, {waiting(part_of_sum(V[0], V[0])), part_of_sum(V[1], V[1]),
                marked(make(kNorm, kZero, V[2], V[2]))});
    add(words, for_axes([](int axis) {
            const Address W = in_row(kW + axis);
            return make(W, W, slope(axis), left(kSlopeScale), kLessSix);
        }));
    words.push_back(waiting(marked(make(kSpeedWord, kZero, kNorm, in_row(kPhi), kCoef))));
    add(words, for_axes([](int axis) {
            return to(kOrigin, 12 + axis, kZero, f_of(axis), kLowerV, kUnit);
        }));
    words.push_back(waiting(marked(make(kMinusSpeed, kZero, kSpeedWord, kMinusOne, kCoef))));
    add(words,
        for_axes([](int axis) { return make(step_b(axis), kZero, in_row(kW + axis), kQuarter); }));
    const Address phi = in_row(kPhi);
    add(words, {waiting(part_of_sum(kMinusOne, kMinusTwo)),
                marked(make(kNewton, kZero, kMinusSpeed, phi, kLessSix)),
                waiting(marked(make(phi, phi, kNewton, phi, kMoreFour))),
                waiting(marked(make(kSquareOfPhi, kZero, phi, phi))),
                waiting(marked(make(kCubeOfPhi, kZero, kSquareOfPhi, phi))),
                waiting(make(in_row(kQ), kZero, kCubeOfPhi, kMinusOne, kCoef))});
    return words;
}

/// Makes one order i of the network; R an order behind. A sum that needs the results just marked
/// waits; less urgent words stand in between, and between the three that add up to DP.
inline Words network_order() {
    const Address phi = in_row(kPhi, kOrder);
    const Address earlier_phi = below(in_row(kPhi, kRest));
    Words words{waiting(over_order(in_row(kLowerQ, kOrder), below(phi), kUnit))};
    add(words, for_axes([&](int axis) {
            return sum_of(in_row(kDV + axis, kOrder), in_row(kW + axis, kInner), earlier_phi,
                          kCoef);
        }));
    words.back().mark = true;
    words.push_back(sum_of(kSquareOfPhi, in_row(kPhi, kInner), earlier_phi, kUnit));
    const Address DP = in_row(kDP, kOrder);
    const auto power = [&](int axis) {
        Word word = sum_of(DP, in_row(kV + axis, kInner), in_row(kDV + axis, kRest), kUnit);
        if (axis > 0) word.c = DP;
        return word;
    };
    words.push_back(waiting(power(0)));
    add(words, for_axes([](int axis) {
            return over_order(in_row(kV + axis, kOrder), in_row(kDV + axis, kOrder), kMoreOne);
        }));
    words.push_back(power(1));
    add(words, for_axes([](int axis) {
            return make(in_row(kW + axis, kOrder), kZero, six_a(axis), in_row(kLowerQ, kOrder),
                        kCoef);
        }));
    words.push_back(marked(power(2)));
    words.push_back(make(below(in_row(kR, kOrder)), kZero, kSquareOfPhi, kMinusThreeHalves, kUnit));
    const Address dphi = in_row(kDphi, kOrder);
    add(words, {waiting(marked(sum_of(dphi, in_row(kQ, kInner), in_row(kDP, kRest), kLessThree))),
                waiting(over_order(phi, dphi, kMoreOne)),
                marked(sum_of(kDQ, in_row(kR, kInner), in_row(kDphi, kRest), kUnit)),
                waiting(over_order(in_row(kQ, kOrder), kDQ, kUnit))});
    return words;
}

/// Makes the anchor, orders 1 .. Order - 1, and the last one's q.
inline void spline_expand(Program& program) {
    Words words = anchor();
    words.back().mark = true;
    program.frame(words, kNext);
    program.frame(network_order(), kLoop);
    const Address next{kReciprocal.base + 1, kOrder};
    program.frame({make(above(in_row(kLowerQ, kOrder)), kZero, in_row(kPhi, kOrder), next)}, kHalt,
                  3);
}

/// Makes the series of the displacements, for the series mode: orders 1 .. Order.
inline void spline_series(Program& program) {
    Words words = for_axes([](int axis) {
        return sum_of(kSeriesDX[axis], in_row(kV + axis, kInner), below(in_row(kPhi, kRest)),
                      kUnit);
    });
    words.back().mark = true;
    words.push_back(waiting(over_order(in_row(kX[0], kOrder), kSeriesDX[0], kUnit)));
    words.push_back(over_order(in_row(kX[1], kOrder), kSeriesDX[1], kUnit));
    words.push_back(over_order(in_row(kX[2], kOrder), kSeriesDX[2], kUnit));
    program.frame(words, kLoopHalt);
}

/// Makes a sample in polynomial mode: q(tau), then the cubic in it.
inline void spline_polynomial(Program& program) {
    const Address sum = kSquare;
    const Address q = in_row(kLowerQ, kOrder);
    program.frame({make(sum, q, above(q), kTau)}, kSkip, 3);
    program.frame({make(sum, q, sum, kTau)}, kLoop, 3);
    program.frame({make(kSine, kZero, sum, kTau)}, kNext, 3);
    program.frame(for_axes([](int axis) {
                      return make(inward(axis), step_b(axis), step_a(axis), kSine, kCoef);
                  }),
                  kNext, 3);
    program.frame(for_axes([](int axis) {
                      return make(accumulator(axis), in_row(kV + axis), inward(axis), kSine, kCoef);
                  }),
                  kNext, 3);
    displacements(program, for_axes([](int axis) {
                      return to(kSample, axis, kZero, accumulator(axis), kSine, kUnit);
                  }));
}

/// Writes a' of each axis once more, for the bank of a step that is not its segment's first.
inline void spline_keep(Program& program) {
    Words words =
        for_axes([](int axis) { return make(step_a(axis), kZero, step_a(axis), kOne, kCoef); });
    words.front().wait = true;
    program.frame(words, kHalt, 3);
}

inline void spline_parts(Program& program) {
    program.part("SplineLoad");
    spline_load(program);
    program.part("SplineStep");
    spline_step(program);
    program.part("SplineExpand");
    spline_expand(program);
    program.part("SplineSeries");
    spline_series(program);
    program.part("SplinePolynomial");
    spline_polynomial(program);
    program.part("SplineKeep");
    spline_keep(program);
}

}  // namespace curvecore::serial
