// SPDX-License-Identifier: Apache-2.0
// The serial build's spline program, executed word by word: equivalent to rtl/serial/ without its
// pipeline, but with the distances that the pipeline needs between words.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "ref/plan/segment.hpp"  // its kSpline before that of the figures: -Wshadow
#include "rtl/serial/spline_program.hpp"
#include "sysc/kernel/run_time_format.hpp"

namespace curvecore::tb {

class SerialMachine {
  public:
    using Fine = std::int64_t;

    explicit SerialMachine(const sysc::RunTimeFormat& format)
        : c_(format), bits_(format.kCoefBits) {
        spline_parts(program_);
        arc_parts(arcs_);
        at(serial::kOne) = int64_t{1} << (bits_ - 2);
        at(serial::kMinusOne) = -at(serial::kOne);
        at(serial::kMinusTwo) = -2 * at(serial::kOne);
        at(serial::kMinusThreeHalves) = -3 * (at(serial::kOne) / 2);
        at(serial::kQuarter) = at(serial::kOne) / 4;
        at(serial::above({0xa0})) = at(serial::kOne);
        for (int i = 2; i <= 12; ++i) at(serial::above({0xa0}, i)) = hls::reciprocal(i, bits_ - 1);
    }

    void load(const sysc::RunSegment& segment) {
        k_ = segment.step_exponent;
        lambda_ = segment.lambda;
        at(serial::kTheta) = segment.theta;
        for (int axis = 0; axis < c_.kAxes; ++axis) {
            origin_[axis < 3 ? 12 + axis : axis] = segment.start[axis];
            at(serial::advance(axis)) = segment.advance[axis];
            if (axis < 3) at(serial::a_of(axis)) = segment.tangent[axis];
            if (axis < 3) at(serial::b_of(axis)) = segment.normal[axis];
        }
        const int s = lambda_ - k_;
        for (int n = 0; n < 8; ++n) {
            const int e = ((n & 4) != 0 ? 2 * s : s) - ((n & 2) != 0 ? 4 : 1);
            const int power =
                (n & 1) != 0 ? (e <= 0 ? bits_ - 6 - e : -1) : (e >= 1 ? bits_ - 1 - e : -1);
            at({0xb8 + n}) = power < 0 ? 0 : int64_t{1} << power;
        }
        run("SplineLoad", 1);
        expand();
    }

    void step() {
        run("SplineStep", c_.kOrder);
        expand();
    }

    void sample(const hls::Word<hls::kLengthBits + 1>& sigma, Fine* out) {
        at(serial::kTau) = hls::to_tau(c_, sigma, k_);
        const bool series = c_.kSeries;
        const serial::Program& program = series ? arcs_ : program_;
        std::size_t place = entry(program, series ? "Series" : "SplinePolynomial");
        for (int i = c_.kOrder - 1;;) {
            const serial::Control control = program.words()[place].control;
            for (int n = 0; n < 3; ++n) execute(program.words()[place + n], i, 0, false);
            clock_ += 6;  // two other contexts
            const bool over = i == 1;
            if (control == serial::kHalt || (control == serial::kHaltNoAux && c_.kAxes == 3) ||
                (control == serial::kHaltThreeAux && c_.kAxes <= 6)) {
                break;
            }
            if (control == serial::kSkip && over) place += 3;
            if (control != serial::kLoop || over) place += 3;
            if (control == serial::kSkip || control == serial::kLoop) --i;
        }
        for (int axis = 0; axis < c_.kAxes; ++axis) out[axis] = sample_[axis];
    }

  private:
    void expand() {
        run("SplineExpand", 1);
        if (c_.kSeries) run("SplineSeries", 1);
        clock_ += 9;  // the tracker's
    }

    static std::size_t entry(const serial::Program& program, const std::string& name) {
        for (const auto& part : program.parts()) {
            if (part.name == name) return part.place;
        }
        throw std::logic_error("no part " + name);
    }

    void run(const std::string& part, int i) {
        std::size_t frame = entry(program_, part);
        std::size_t place = frame;
        serial::Control control = serial::kGo;
        for (int left = -1;; ++place, --left) {  // words that the branch does not stop
            const serial::Word& word = program_.words()[place];
            if (word.wait) clock_ = std::max(clock_, marked_ + 9);
            for (int j = 0; j < (word.repeat ? i : 1); ++j) {
                execute(word, i, j, word.more || (word.repeat && j < i - 1));
            }
            if (word.mark) marked_ = clock_ - 1;
            if (word.control != serial::kGo) {
                control = word.control;
                left = 2;
            }
            if (left != 0) continue;
            const bool over = i == (control == serial::kLoop ? c_.kOrder - 1 : c_.kOrder);
            if (control == serial::kHalt || (control == serial::kLoopHalt && over)) return;
            if (control == serial::kNext || over) {
                frame = place + 1;
            } else {
                place = frame - 1;
                ++i;
            }
        }
    }

    void execute(const serial::Word& word, int i, int j, bool more) {
        const int64_t a = read(word.a, i, j, 0);
        const int64_t b = read(word.b, i, j, 0);
        const int64_t c = read(word.c, i, j, 5);
        const hls::Word<128> sum = sum_ + hls::Word<128>(a) * b;
        sum_ = more ? sum : hls::Word<128>(0);
        ++clock_;
        if (more) return;
        int code = word.scale;
        if (word.first && (index(word.b, i, j) & 15) == 1) code &= ~1;
        const int shift = bits_ - 6 + (code == serial::kMoreFour ? 10 : code);
        const auto d = static_cast<int64_t>(c + hls::round_shift(sum, shift));
        const int place = index(word.d, i, j);
        if (word.target == serial::kMemory) {
            memory_[place] = d;
            there_[place] = clock_ + 8;
        } else if (word.target == serial::kOrigin && place >= 12) {
            origin_[place - 12] = Fine(origin_[place] + hls::to_fine(c_, d, lambda_));
        } else if (word.target == serial::kOrigin) {
            origin_[place] = Fine(origin_[place] + hls::to_fine(c_, d, k_));
        } else if (word.target == serial::kSample) {
            sample_[place] = Fine(origin_[place] + hls::to_fine(c_, d, k_));
        }
    }

    static int index(const serial::Address& address, int i, int j) {
        const int add[] = {0, i, j, i - j, 0};
        return (address.base & ~15) | ((address.base + add[address.select]) & 15);
    }

    int64_t& at(const serial::Address& address) { return memory_[index(address, 0, 0)]; }

    int64_t read(const serial::Address& address, int i, int j, int later) const {
        const int place = index(address, i, j);
        if (there_[place] > clock_ + later) {
            throw std::logic_error("word " + std::to_string(place) + " is read too early");
        }
        return memory_[place];
    }

    sysc::RunTimeFormat c_;
    int bits_;
    serial::Program program_;
    serial::Program arcs_;
    std::array<int64_t, 512> memory_{};
    std::array<int64_t, 512> there_{};  // clock of the first read
    std::array<Fine, 16> origin_{};
    std::array<Fine, 16> sample_{};
    hls::Word<128> sum_ = 0;
    int64_t clock_ = 0;
    int64_t marked_ = -9;
    int k_ = 0;
    int lambda_ = 0;
};

}  // namespace curvecore::tb
