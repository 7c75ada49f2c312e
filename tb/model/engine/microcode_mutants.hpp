// SPDX-License-Identifier: Apache-2.0
// Broken microcode: every instruction deleted, or one bit of it changed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hls/instruction.hpp"
#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::tb {

/// Bits of an instruction whose change is another instruction. A fourth limb is read by nothing,
/// and by hls/instruction.hpp bit 6 of a page's word is not looked at, and words 0 to 7 are not
/// written; 0 times anything is 0; of
/// branches that are always taken the place alone, and what gives back.
inline std::uint32_t meaning(const engine::Instruction& i) {
    constexpr std::uint32_t kF0 = 0xff0000;
    constexpr std::uint32_t kF1 = 0xff00;
    constexpr std::uint32_t kF2 = 0xff;
    constexpr std::uint32_t kFlag = 0x01000000;
    constexpr std::uint32_t kFewerLimbs = 0x08000000;
    constexpr std::uint32_t kPageBit = 0x40;
    const bool always = (i.f0 & (engine::kNot | 15)) == (engine::kNot | engine::kNever);
    if ((i.f0 & engine::kReturn) != 0 && engine::is_branch(i.op)) return 0x500000;
    if (engine::is_branch(i.op)) return (always ? 0x500000 : 0x5f0000) | 0x1ff;
    if (i.op == engine::Op::kOut) return kF0 | 0x100;
    if (i.op == engine::Op::kIn) return 0x1f0000 | (kF2 & ~(i.f2 >= engine::kX ? kPageBit : 0));
    std::uint32_t bits = kF2 & ~(i.f2 >= engine::kX              ? kPageBit
                                 : i.f2 < engine::kConstantWords ? 7
                                                                 : 0);
    if (!(engine::is_product(i.op) && i.f0 == engine::kZero / engine::kWordLimbs)) {
        bits |= (kF0 & ~(i.f0 >= engine::kX ? kPageBit << 16 : 0)) | kF1;
        bits |= engine::is_high(i.op) ? kFlag : 0;
    }
    return bits | (i.op == engine::Op::kMac ? kFlag : i.limbs >= 3 ? kFewerLimbs : 0);
}

/// Changes of one instruction: it is deleted, or one such bit is another.
inline std::vector<std::uint32_t> mutants(const engine::Instruction& i) {
    std::vector<std::uint32_t> words{encode(engine::Instruction())};
    for (int bit = 0; bit < 32; ++bit) {
        if ((meaning(i) >> bit & 1) == 0) continue;
        words.push_back(encode(engine::decode(encode(i) ^ std::uint32_t{1} << bit)));
    }
    return words;
}

struct MutantShare {
    int mutants = 0;
    int seen = 0;
    std::string deleted;  // and not seen
};

/// Runs every deletion in microcode from a place on, and every `each`th of the other mutants;
/// differs(program) says whether one is seen. What does not end is. `meant` tells the sources whose
/// instructions are changed.
template <class Differs>
MutantShare seen_mutants(
    const assembler::Assembly& assembly, std::size_t each, Differs&& differs,
    const std::function<bool(const std::string& file)>& meant = [](const std::string&) {
        return true;
    }) {
    const std::vector<assembler::Placed>& placed = assembly.placed();
    // A page that is opened again means something where words of it are read
    const bool beyond = std::any_of(placed.begin(), placed.end(),
                                    [](const assembler::Placed& one) { return one.beyond; });
    MutantShare share;
    std::size_t count = 0;
    for (std::size_t n = assembly.labels().at("dispatched"); n < placed.size(); ++n) {
        if (!meant(placed[n].source.file)) continue;
        if (!beyond && placed[n].f1 == assembler::kBeyondInX) continue;
        const std::vector<std::uint32_t> words = mutants(placed[n].instruction);
        for (std::size_t mutant = 0; mutant < words.size(); ++mutant) {
            if (mutant > 0 && count++ % each != 0) continue;
            std::vector<std::uint32_t> program = assembly.program();
            program[n] = words[mutant];
            bool seen = true;
            try {
                seen = differs(program);
            } catch (const std::runtime_error&) {
            }
            ++share.mutants;
            share.seen += seen ? 1 : 0;
            if (!seen && mutant == 0) share.deleted += placed[n].source.text + "\n";
        }
    }
    return share;
}

}  // namespace curvecore::tb
