// SPDX-License-Identifier: Apache-2.0
// The engine's memories in a Verilated model, which has tb/unit/motion/microcode.vlt among its
// sources.
#pragma once

#include <verilated.h>
#include <verilated_sym_props.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::tb {

class EngineMemories {
  public:
    /// `engine` is where it stands in the model, such as "motion_interpolator.u_engine".
    explicit EngineMemories(const std::string& engine)
        : program_(words<std::uint32_t>(engine, "u_program", "memory")),
          limbs_{words<std::uint16_t>(engine, "u_memory", "memory_a"),
                 words<std::uint16_t>(engine, "u_memory", "memory_b")} {}

    std::uint32_t& instruction(std::size_t place) { return program_[place]; }
    std::uint16_t& limb(int copy, std::size_t place) { return limbs_[copy][place]; }

    /// Loads programs into a store of a size, as much of them as fits.
    void load(const assembler::Assembly& from, const assembler::StoreSize& size) {
        const std::vector<std::uint32_t> program = from.program();
        const std::vector<std::int16_t> data = from.memory();
        for (std::size_t n = 0; n < static_cast<std::size_t>(size.program); ++n) {
            instruction(n) = n < program.size() ? program[n] : 0;
        }
        for (std::size_t n = 0; n < std::size_t{engine::kWordLimbs} * size.data; ++n) {
            const std::int16_t value = n < data.size() ? data[n] : std::int16_t{0};
            limb(0, n) = limb(1, n) = static_cast<std::uint16_t>(value);
        }
    }

  private:
    template <class Word>
    static Word* words(const std::string& engine, const char* module, const char* name) {
        const std::string place = "dut." + engine + "." + module;
        const VerilatedScope* scope = Verilated::scopeFind(place.c_str());
        if (scope == nullptr) throw std::logic_error("the model has no " + place);
        return static_cast<Word*>(scope->varFind(name)->datap());
    }

    std::uint32_t* program_;
    std::uint16_t* limbs_[2];
};

}  // namespace curvecore::tb
