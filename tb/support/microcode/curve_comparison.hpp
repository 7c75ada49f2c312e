// SPDX-License-Identifier: Apache-2.0
// Microcode of curves on the twin (hls/engine.hpp), beside the kernel that it is held to.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "hls/curve_kernel.hpp"
#include "ref/curves/table_reader.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"
#include "rtl/engine/compiler/table_lowering.hpp"
#include "sysc/kernel/run_time_format.hpp"
#include "tb/support/judge/open_spline.hpp"
#include "tb/support/microcode/microcode_machine.hpp"

namespace curvecore::tb {

/// A core of a configuration.
struct CurveCase {
    bool spline = false;
    sysc::CoreParameters core;
};

/// A curve's programs, and the words of its values.
struct CurveMicrocode {
    assembler::Assembly assembly;
    std::map<std::string, std::string> words;
};

inline CurveMicrocode curve_microcode(const CurveCase& of, const assembler::StoreSize& size = {}) {
    const ref::CurveTable table =
        ref::read_curve_table(std::string(CURVES_DIR) + (of.spline ? "/spline.net" : "/arc.net"));
    CurveMicrocode made{assembler::Assembly(size), {}};
    MicrocodeMachine::dispatch(
        made.assembly, {table.name + "_load", table.name + "_step", table.name + "_sample"});
    made.words = assemble_curves({table}, of.core, made.assembly, "idle", "idle").front();
    made.assembly.finish();
    return made;
}

/// Words of a random segment whose first steps keep every range.
inline sysc::RunSegment random_segment(const CurveCase& of, std::mt19937_64& random) {
    const auto real = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    const auto word = [](double value, int fraction) {
        return static_cast<std::int64_t>(std::ldexp(value, fraction));
    };
    const int bits = of.core.coef_bits;
    const int most = std::min(hls::kMaxStepExponent, of.core.position_bits - 4);
    const double room = std::ldexp(1.0, of.core.position_bits - 2);
    sysc::RunSegment segment;
    segment.kind = of.spline ? hls::SegmentKind::kSpline : hls::SegmentKind::kArc;
    const int down = of.spline ? 4 + static_cast<int>(random() % 5) : 0;
    segment.step_exponent = most - down;  // the finest words are seen in long steps
    if (random() % 2 == 0) {
        segment.step_exponent = static_cast<int>(random() % static_cast<unsigned>(most - down + 1));
    }
    segment.lambda = segment.step_exponent + down;
    double c[3];
    double norm = 0;
    for (double& x : c) {
        x = real(-0.5, 0.5);
        norm += x * x;
    }
    const double speed = of.spline ? real(0.6, 0.8) : 0.5;
    for (int axis = 0; axis < of.core.axes(); ++axis) {
        segment.start[axis] = word(real(-room, room), of.core.guard_bits);
        segment.advance[axis] = word(real(-0.9, 0.9), bits - 2);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double bend = of.spline ? 0.12 : 0.6;
        segment.tangent[axis] = word(real(-bend, bend), bits - 2);
        segment.normal[axis] = word(real(-bend, bend), bits - 2);
        if (of.spline) segment.advance[axis] = word(c[axis] / std::sqrt(norm) * speed, bits - 2);
    }
    segment.theta = of.spline ? word(1 / speed, bits - 2) : word(real(0, 0.5), bits - 1);
    return segment;
}

/// The spline's kernel with the words of a step that its microcode keeps, too.
class SplineStep : public OpenSpline<sysc::RunTimeFormat> {
  public:
    using OpenSpline<sysc::RunTimeFormat>::OpenSpline;

    /// Calls visit(name, axis, value).
    template <class Visit>
    void step_words(const sysc::CoreParameters& core, Visit&& visit) const {
        visit("v.0", 0, v_);
        if (core.polynomial()) {
            for (int i = 1; i <= core.order; ++i) visit("q." + std::to_string(i), 0, q_[i]);
        }
        visit("phi.0", 0, sum(phi_, 0, core.order - 1));  // of the next step
        for (int axis = 0; axis < 3; ++axis) {
            visit(assembler::place_word::kOrigin, axis, origin_[axis]);
            if (core.polynomial()) visit("V[k].0", axis, V_[axis][0]);
            if (core.polynomial()) visit("half_W[k]", axis, half_W_[axis]);
        }
    }
};
class ArcStep : public hls::ArcCurve<sysc::RunTimeFormat> {
  public:
    using hls::ArcCurve<sysc::RunTimeFormat>::ArcCurve;
    template <class Visit>
    void step_words(const sysc::CoreParameters&, Visit&&) const {}
};

/// The kernel and the twin, segment by segment; counts words.
class CurveComparison {
  public:
    CurveComparison(const CurveCase& of, const CurveMicrocode& code, MicrocodeMachine& machine)
        : of_(of), code_(code), machine_(machine), ranges_(of.core.coef_bits) {}

    /// Draws a random segment with both; returns the number of words that differ.
    int segment(std::mt19937_64& random, int steps, int samples) {
        return of_.spline ? drawn<SplineStep>(random, steps, samples)
                          : drawn<ArcStep>(random, steps, samples);
    }

    std::int64_t words() const { return words_; }
    int most_clocks(int program) const { return most_clocks_[program]; }
    const sysc::ValueRanges& ranges() const { return ranges_; }

  private:
    template <class Kernel>
    int drawn(std::mt19937_64& random, int steps, int samples) {
        const sysc::RunTimeFormat format(of_.core, of_.core.axes(), &ranges_);
        Kernel kernel(format);
        const sysc::RunSegment words = random_segment(of_, random);
        load(words);
        kernel.load(words);
        run(0);
        int differ = 0;
        for (int step = 0; step < steps; ++step) {
            if (step > 0) {
                kernel.step();
                run(1);
            }
            kernel.step_words(of_.core, [&](const std::string& name, int axis, std::int64_t value) {
                differ += is(code_.words.at(name), axis, value) ? 0 : 1;
            });
            for (int sample = 0; sample < samples; ++sample) {
                const std::uint64_t length = std::uint64_t{1}
                                             << (words.step_exponent + hls::kPathFrac);
                const auto sigma = static_cast<std::int64_t>(sample == 0 ? 0 : random() % length);
                std::int64_t fine[sysc::kMostAxes];
                kernel.sample(sigma, fine);
                machine_.set("sigma", sigma);
                run(2);
                for (int axis = 0; axis < of_.core.axes(); ++axis) {
                    differ += is("fine" + row(axis), axis < 3 ? axis : 0, fine[axis]) ? 0 : 1;
                }
            }
        }
        return differ;
    }

    static std::string row(int axis) { return axis < 3 ? "[k]" : "[" + std::to_string(axis) + "]"; }

    void run(int program) {
        most_clocks_[program] = std::max(most_clocks_[program], machine_.run(program));
    }

    bool is(const std::string& word, int axis, std::int64_t value) {
        ++words_;
        return machine_.get(word, axis) == value;
    }

    void load(const sysc::RunSegment& words) {
        machine_.set("theta", words.theta);
        const int fine = assembler::fine_scale(of_.core).fine;
        machine_.set("tau_scale", std::int64_t{1} << (hls::kMaxStepExponent - words.step_exponent));
        machine_.set("fine_scale", std::int64_t{1} << (fine + words.step_exponent));
        if (of_.spline) {
            machine_.set("place_scale", std::int64_t{1} << (fine + words.lambda));
            machine_.set("step_scale",
                         std::int64_t{1} << (44 - words.lambda + words.step_exponent));
        }
        for (int axis = 0; axis < of_.core.axes(); ++axis) {
            const int page = axis < 3 ? axis : 0;
            machine_.set("start" + row(axis), words.start[axis], page);
            machine_.set("advance" + row(axis), words.advance[axis], page);
            if (axis < 3) {
                machine_.set("tangent[k]", words.tangent[axis], page);
                machine_.set("normal[k]", words.normal[axis], page);
            }
        }
    }

    CurveCase of_;
    const CurveMicrocode& code_;
    MicrocodeMachine& machine_;
    sysc::ValueRanges ranges_;
    std::int64_t words_ = 0;
    int most_clocks_[3] = {0, 0, 0};  // load, step, sample
};

}  // namespace curvecore::tb
