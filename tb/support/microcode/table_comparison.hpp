// SPDX-License-Identifier: Apache-2.0
// Microcode of any table on the twin (hls/engine.hpp), beside the table run in words.
#pragma once

#include <random>

#include "sysc/kernel/table_kernel.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"

namespace curvecore::tb {

/// The engine beside the kernel, over the steps of segments.
class MicrocodeOfTable {
  public:
    explicit MicrocodeOfTable(const sysc::CoreParameters& core)
        : core_(core),
          format_(core, core.axes()),
          code_(assembled(core)),
          engine_(code_),
          kernel_(*core.table, format_) {}

    /// Draws steps of a segment with both; returns the number of words that differ.
    int draw(const sysc::RunSegment& words, int steps, std::mt19937_64& random) {
        load(words);
        kernel_.load(words);
        engine_.run(0);
        int differ = 0;
        for (int step = 0; step < steps; ++step) {
            if (step > 0) {
                engine_.run(1);
                kernel_.step();
            }
            for (int sample = 0; sample < 3; ++sample) {
                const int bits = words.step_exponent + hls::kPathFrac;
                const auto sigma = static_cast<std::int64_t>(
                    sample == 0 ? 0 : random() % (std::uint64_t{1} << bits));
                set("sigma", sigma);
                engine_.run(2);
                std::int64_t fine[3];
                kernel_.sample(sigma, fine);
                for (int axis = 0; axis < 3; ++axis) {
                    differ += engine_.get("fine[k]", axis) == fine[axis] ? 0 : 1;
                    ++samples_;
                }
            }
        }
        return differ;
    }
    int samples() const { return samples_; }
    bool hazard() const { return engine_.hazard(); }

  private:
    static assembler::Assembly assembled(const sysc::CoreParameters& core) {
        const ref::CurveTable& table = *core.table;
        assembler::Assembly assembly(kLargeStore);
        MicrocodeMachine::dispatch(
            assembly, {table.name + "_load", table.name + "_step", table.name + "_sample"});
        assemble_curves({table}, core, assembly, "idle", "idle");
        assembly.finish();
        return assembly;
    }

    void load(const sysc::RunSegment& words) {
        const int fine = assembler::fine_scale(core_).fine;
        const auto power = [](int exponent) { return std::int64_t{1} << exponent; };
        set("tau_scale", power(hls::kMaxStepExponent - words.step_exponent));
        set("fine_scale", power(fine + words.step_exponent));
        set("place_scale", power(fine + words.lambda));
        set("step_scale", power(44 - words.lambda + words.step_exponent));
        for (int axis = 0; axis < 3; ++axis) set("start[k]", words.start[axis], axis);
        for (const auto& [place, row] : core_.table->bus) {
            const std::int64_t* const field = sysc::words_at(ref::bus_place(place), words);
            if (!core_.table->rows.at(row).of_axis) {
                set(place, field[0]);
                continue;
            }
            for (int axis = 0; axis < 3; ++axis) {
                set(place + "[k]", field[axis], axis);
            }
        }
    }

    /// Sets a word, if the programs read it.
    void set(const std::string& word, std::int64_t value, int axis = 0) {
        try {
            code_.place(word);
        } catch (const assembler::AssemblyError&) {
            return;
        }
        engine_.set(word, value, axis);
    }

    sysc::CoreParameters core_;
    sysc::RunTimeFormat format_;
    assembler::Assembly code_;
    MicrocodeMachine engine_;
    sysc::TableKernel kernel_;
    int samples_ = 0;
};

}  // namespace curvecore::tb
