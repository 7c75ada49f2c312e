// SPDX-License-Identifier: Apache-2.0
// Microcode of curves on the twin (hls/engine.hpp), beside the kernel that it is held to.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hls/curve_kernel.hpp"
#include "hls/engine.hpp"
#include "hls/words.hpp"
#include "ref/curves/table_reader.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"
#include "rtl/engine/compiler/table_lowering.hpp"
#include "sysc/core/run_time_format.hpp"

namespace curvecore::tb {

/// Writes the table of rtl/engine/programs/powers.asm.
inline void write_powers(std::vector<std::int16_t>& memory) {
    constexpr int kPowers = 60;
    memory.resize(std::max(memory.size(), std::size_t{engine::kWordLimbs} * kPowers));
    for (int n = 0; n < kPowers; ++n) {
        for (int limb = 0; limb < engine::kWordLimbs; ++limb) {
            const int bit = n - engine::kLimbBits * limb;
            memory[static_cast<std::size_t>(engine::kWordLimbs * n + limb)] =
                static_cast<std::int16_t>(bit >= 0 && bit < engine::kLimbBits ? 1 << bit : 0);
        }
    }
}

/// Returns whether a profile's word may go to its queue's begin: a piece's others follow the first.
inline bool may_wrap(std::uint64_t word) {
    const auto tag = static_cast<hls::Tag>(hls::get(hls::kTagField, word));
    return tag == hls::Tag::kPiece || tag == hls::Tag::kStop || tag == hls::Tag::kStep;
}

/// The board around the engine, as far as a test makes it: the memory behind it, and what else is
/// at its ports (rtl/engine/programs/ports.asm).
struct MicrocodePorts {
    std::vector<std::int16_t> memory;
    std::uint32_t address = 0;
    std::function<std::int16_t(int port, int limb)> give;
    std::function<void(int port, int limb, std::int16_t value)> take;
    std::function<bool(int code)> condition;

    std::int16_t in(int port, int limb) {
        if (port == kMemory) return limb_there();
        return give ? give(port, limb) : std::int16_t{0};
    }
    void out(int port, int limb, std::int16_t value) {
        const auto bits = static_cast<std::uint32_t>(value & 0x7fff);
        if (port == kMemory) {
            limb_there() = value;
        } else if (port == kAddress) {
            address = limb == 0 ? bits : address | bits << engine::kLimbBits;
        } else if (take) {
            take(port, limb, value);
        }
    }

  private:
    static constexpr int kMemory = 3;
    static constexpr int kAddress = 4;

    std::int16_t& limb_there() {
        if (address >= memory.size()) throw std::runtime_error("no such place in the memory");
        return memory[address++];
    }
};

/// Programs of an assembly, begun by the background when a board's condition asks for them.
class MicrocodeMachine {
  public:
    static constexpr int kFirstRequest = engine::kBoard;

    /// Writes what begins the programs of these labels; they end at `idle`, or give back.
    static void dispatch(assembler::Assembly& assembly, const std::vector<std::string>& labels) {
        assembly.from({"dispatch", 0, ""});
        assembly.branch("idle");
        assembly.branch("idle");  // the foreground
        assembly.label("idle");
        assembly.open_auxiliary();  // a page that no program finds open
        assembly.open_further();
        for (std::size_t n = 0; n < labels.size(); ++n) {
            assembly.branch(labels[n], engine::kCall | (kFirstRequest + static_cast<int>(n)));
        }
        assembly.branch("idle");
        assembly.label("dispatched");
    }

    MicrocodeMachine(const assembler::Assembly& assembly, std::vector<std::uint32_t> program)
        : assembly_(assembly),
          dispatched_(static_cast<int>(assembly.labels().at("dispatched"))),
          idle_(static_cast<int>(assembly.labels().at("idle"))),
          at_first_(memory_of(assembly)),
          engine_(std::move(program), at_first_) {}
    explicit MicrocodeMachine(const assembler::Assembly& assembly)
        : MicrocodeMachine(assembly, assembly.program()) {}

    /// Executes a program; returns its clocks. @throws std::runtime_error if it does not end, ends
    /// elsewhere, or leaves another page X open where that has words beyond
    int run(int request) {
        board_.request = kFirstRequest + request;
        int back = 0;
        while (engine_.place(false) < dispatched_) {
            back = engine_.place(false) + 1;
            engine_.step(board_);
        }
        board_.request = -1;
        const std::uint64_t begin = engine_.clock();
        const int x = engine_.page(false, false);
        while (engine_.place(false) >= dispatched_) {
            engine_.step(board_);
            if (engine_.clock() - begin > kMostClocks) throw std::runtime_error("no end");
        }
        if (engine_.place(false) != back && engine_.place(false) != idle_) {
            throw std::runtime_error("it ends elsewhere");
        }
        if (assembly_.size().data > 256 && engine_.page(false, false) != x) {
            throw std::runtime_error("another page X");
        }
        return static_cast<int>(engine_.clock() - begin);
    }

    void set(const std::string& word, std::int64_t value, int axis = 0) {
        std::int16_t* limbs = at(word, axis);
        limbs[0] = static_cast<std::int16_t>(value & 0x7fff);
        limbs[1] = static_cast<std::int16_t>(value >> 15 & 0x7fff);
        limbs[2] = static_cast<std::int16_t>(value >> 30);
    }
    std::int64_t get(const std::string& word, int axis = 0) {
        const std::int16_t* limbs = at(word, axis);
        return limbs[0] + limbs[1] * (std::int64_t{1} << 15) + limbs[2] * (std::int64_t{1} << 30);
    }
    bool hazard() const { return engine_.hazard(); }
    /// Writes anything into the words that the sources' locals share, as other programs do.
    void spoil_locals(std::mt19937_64& random) {
        for (const auto& [place, datum] : assembly_.data()) {
            if (datum.name.rfind("scratch ", 0) != 0) continue;
            const std::uint64_t bits = random() % 2 == 0 ? 0 : 0x7fff;
            for (int limb = 0; limb < engine::kWordLimbs; ++limb) {
                engine_.memory()[static_cast<std::size_t>(engine::kWordLimbs * place + limb)] =
                    static_cast<std::int16_t>(random() & bits);
            }
        }
    }
    /// Returns whether a program wrote where no word has a name.
    bool strays() {
        const std::vector<std::int16_t>& memory = engine_.memory();
        for (std::size_t limb = 0; limb < memory.size(); ++limb) {
            if (at_first_[limb] == kAnything && memory[limb] != kAnything) return true;
        }
        return false;
    }

    /// The board that the programs find.
    MicrocodePorts& ports() { return board_.ports; }

  private:
    static constexpr std::uint64_t kMostClocks = 200000;
    static constexpr std::int16_t kAnything = 0x2aaa;

    struct Board : engine::QuietBoard {
        int request = -1;
        MicrocodePorts ports;
        bool condition(int code, std::uint64_t) const {
            return request >= 0 ? code == request : ports.condition && ports.condition(code);
        }
        std::int16_t in(int port, int limb, std::uint64_t) { return ports.in(port, limb); }
        void out(int port, int limb, std::int16_t value, std::uint64_t) {
            ports.out(port, limb, value);
        }
    };

    /// The data at first; what stands in words that have no name is not 0.
    static std::vector<std::int16_t> memory_of(const assembler::Assembly& assembly) {
        std::vector<std::int16_t> memory = assembly.memory();
        std::vector<bool> named(memory.size());
        const auto name = [&](int place, int words) {
            std::fill_n(named.begin() + std::ptrdiff_t{engine::kWordLimbs} * place,
                        std::ptrdiff_t{engine::kWordLimbs} * words, true);
        };
        name(0, engine::kConstantWords);
        for (const auto& [place, datum] : assembly.data()) {
            for (int axis = 0; axis < assembler::kAxes; ++axis) {
                name(assembly.place(datum.name, axis), datum.words);
            }
        }
        for (std::size_t limb = 0; limb < memory.size(); ++limb) {
            if (!named[limb]) memory[limb] = kAnything;
        }
        return memory;
    }

    std::int16_t* at(const std::string& word, int axis) {
        const auto known = places_.try_emplace({word, axis}, 0);
        if (known.second) known.first->second = assembly_.place(word, axis);
        return &engine_
                    .memory()[static_cast<std::size_t>(engine::kWordLimbs * known.first->second)];
    }

    const assembler::Assembly& assembly_;
    int dispatched_;
    int idle_;
    std::vector<std::int16_t> at_first_;
    engine::Engine engine_;
    Board board_;
    std::map<std::pair<std::string, int>, int> places_;
};

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
class OpenSplineKernel : public hls::SplineKernel<sysc::RunTimeFormat> {
  public:
    using hls::SplineKernel<sysc::RunTimeFormat>::SplineKernel;

    /// Calls visit(name, axis, value).
    template <class Visit>
    void step_words(const sysc::CoreParameters& core, Visit&& visit) const {
        visit("v.0", 0, v_);
        if (core.polynomial()) {
            for (int i = 1; i <= core.order; ++i) visit("q." + std::to_string(i), 0, net_.q[i]);
        }
        visit("phi.0", 0, Network::sum(net_.phi, 0, core.order - 1));  // of the next step
        for (int axis = 0; axis < 3; ++axis) {
            visit("origin[k]", axis, position_[axis]);
            if (core.polynomial()) visit("V[k].0", axis, net_.V[axis][0]);
            if (core.polynomial()) visit("half_W[k]", axis, step_b_[axis]);
        }
    }
};
class OpenArcKernel : public hls::SphericalKernel<sysc::RunTimeFormat> {
  public:
    using hls::SphericalKernel<sysc::RunTimeFormat>::SphericalKernel;
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
        return of_.spline ? drawn<OpenSplineKernel>(random, steps, samples)
                          : drawn<OpenArcKernel>(random, steps, samples);
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
