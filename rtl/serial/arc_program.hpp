// SPDX-License-Identifier: Apache-2.0
// Lines, arcs and helices as a program for one multiplier, from the networks' tables: [Chikurov]
// Figs. 2 and 8. A Riemann node is one word per order.
#pragma once

#include "ref/series/figures.hpp"
#include "rtl/serial/program_word.hpp"

namespace curvecore::serial {

using ref::kSineCosine;
using ref::kSpherical;

constexpr int kAngle = 6;  // coefficient rows: the six of Fig. 8, then the two of Fig. 2
constexpr Address coefficient(std::size_t node) { return in_row(static_cast<int>(node), kOrder); }
constexpr Address state(std::size_t node) { return in_row(static_cast<int>(node)); }
constexpr Address kWeight{0x80, kOrder};
constexpr Address kMinusWeight{0x90, kOrder};
constexpr Address node_sum(std::size_t node) { return {0xb0 + static_cast<int>(node)}; }
constexpr Address kSquare{0xd4, kContext};
constexpr Address kSine{0xd5, kContext};
constexpr Address kVersine{0xd6, kContext};
constexpr Address inward(int axis) { return {0xd8 + axis, kContext}; }

/// Adds one order of every node, from row `first` on.
template <class Network>
Words expansion(const Network& network, std::size_t first) {
    Words words;
    for (const std::size_t n : evaluation_order(network)) {
        const auto& node = network.nodes[n];
        words.push_back(make(coefficient(first + n), kZero,
                             below(coefficient(first + network.node(node.integrand))),
                             node.gain.factor < 0 ? kMinusWeight : kWeight));
        words.back().first = true;
    }
    return words;
}

inline void weights(Program& program) {
    Words words{make(kWeight, kZero, kReciprocal, kTheta)};
    words.resize(9);
    words.push_back(make(kMinusWeight, kZero, kWeight, kMinusOne, kCoef));
    program.frame(words, kLoopHalt, 11);
}

/// Adds the series of sine and cosine, for the polynomial mode; the versine has no constant term,
/// and the sine's polynomial may start an order above the last.
inline void angle(Program& program) {
    const std::size_t sine = kAngle + kSineCosine.node("y");
    const std::size_t cosine = kAngle + kSineCosine.node("z");
    program.frame(
        {make(state(cosine), kZero, kOne, kOne, kCoef), make(state(sine), kZero, kZero, kZero)},
        kNext);
    program.frame(expansion(kSineCosine, kAngle), kLoop, 11);
    program.frame({make(state(cosine), kZero, kZero, kZero),
                   make(above(coefficient(sine)), kZero, kZero, kZero)},
                  kHalt);
}

inline const std::size_t kOutput[3] = {kSpherical.node("x"), kSpherical.node("y"),
                                       kSpherical.node("z")};
inline const std::size_t kSpeed[3] = {kSpherical.node("F"), kSpherical.node("G"),
                                      kSpherical.node("H")};

/// Adds the sums' frame, then per order the nodes and their sums, then the advance in order 1.
inline void expand(Program& program) {
    Words clear;
    for (std::size_t n = 0; n < kSpherical.size(); ++n) {
        clear.push_back(make(node_sum(n), kZero, kZero, kZero));
    }
    program.frame(clear, kNext);
    Words order = expansion(kSpherical, 0);
    order.resize(9);
    for (std::size_t n = 0; n < kSpherical.size(); ++n) {
        order.push_back(make(node_sum(n), node_sum(n), coefficient(n), kOne, kCoef));
    }
    program.frame(order, kLoop);
    Words rate;
    for (int axis = 0; axis < 3; ++axis) {
        const Address first = above(state(kOutput[axis]));
        rate.push_back(make(first, first, advance(axis), kOne, kCoef));
    }
    program.frame(rate, kHalt, 5);  // samples come later than its results
}

/// Moves the auxiliary axes' origins a step farther.
inline Words auxiliary_origins() {
    Words words;
    for (int axis = 3; axis < 9; ++axis) {
        words.push_back(to(kOrigin, axis, kZero, advance(axis), kOne, kCoef));
    }
    return words;
}

inline void step(Program& program) {
    Words words;
    for (std::size_t n = 0; n < kSpherical.size(); ++n) {
        words.push_back(make(state(n), state(n), node_sum(n), kTheta));
    }
    for (int axis = 0; axis < 3; ++axis) {
        words.push_back(to(kOrigin, axis, node_sum(kOutput[axis]), advance(axis), kOne, kCoef));
    }
    program.frame(words, kNext);
    program.frame(auxiliary_origins(), kHalt);
}

/// Adds the end of a sample's program: `last` with the displacements of X Y Z, then the others'.
inline void displacements(Program& program, const Words& last) {
    program.frame(last, kHaltNoAux, 3);
    for (int first = 3; first < 9; first += 3) {
        Words words;
        for (int axis = first; axis < first + 3; ++axis) {
            words.push_back(to(kSample, axis, kZero, advance(axis), kTau, kUnit));
        }
        program.frame(words, first == 3 ? kHaltThreeAux : kHalt, 3);
    }
}

inline void series(Program& program) {
    Words top;
    Words loop;
    Words last;
    for (int axis = 0; axis < 3; ++axis) {
        const Address x = coefficient(kOutput[axis]);
        top.push_back(make(accumulator(axis), x, above(x), kTau));
        loop.push_back(make(accumulator(axis), x, accumulator(axis), kTau));
        last.push_back(to(kSample, axis, kZero, accumulator(axis), kTau, kUnit));
    }
    program.frame(top, kSkip, 3);
    program.frame(loop, kLoop, 3);
    displacements(program, last);
}

inline void polynomial(Program& program) {
    const Address y = coefficient(kAngle + kSineCosine.node("y"));
    const Address z = coefficient(kAngle + kSineCosine.node("z"));
    program.frame({make(kSquare, kZero, kTau, kTau)}, kNext, 3);
    program.frame(
        {make(kSine, y, above(y, 2), kSquare), make(kVersine, below(z), above(z), kSquare)}, kSkip,
        3);
    program.frame({make(kSine, y, kSine, kSquare), make(kVersine, below(z), kVersine, kSquare)},
                  kLoop, 3);
    Words rate;
    Words pull;
    Words last;
    for (int axis = 0; axis < 3; ++axis) {
        rate.push_back(make(accumulator(axis), advance(axis), state(kSpeed[axis]), kSine, kCoef));
        pull.push_back(make(inward(axis), kZero, state(kOutput[axis]), kVersine, kCoef));
        last.push_back(to(kSample, axis, inward(axis), accumulator(axis), kTau, kUnit));
    }
    program.frame(rate, kNext, 3);
    program.frame(pull, kNext, 3);
    displacements(program, last);
}

inline void arc_parts(Program& program) {
    program.part("Weights");
    weights(program);
    program.part("Angle");
    angle(program);
    program.part("Expand");
    expand(program);
    program.part("Step");
    step(program);
    program.part("Series");
    series(program);
    program.part("Polynomial");
    polynomial(program);
}

}  // namespace curvecore::serial
