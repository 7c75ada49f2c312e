// SPDX-License-Identifier: Apache-2.0
// Broken microcode: every instruction deleted, or one bit of it changed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hls/instruction.hpp"
#include "rtl/engine/assembler/assembly.hpp"
#include "tb/support/microcode/microcode_machine.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {

/// Ports of OUT whose value the board does not look at (rtl/engine/programs/ports.asm): take,
/// take_request, report_underrun, report_short, report_settings, sample_whole.
inline bool says_that_alone(int port) {
    return port == 5 || (port >= 8 && port <= 11) || port == 25;
}

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
    if (i.op == engine::Op::kOut) return (says_that_alone(i.f1) ? 0 : kF0) | 0x100;
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

/// A change of an instruction in words.
inline std::string described(const assembler::Placed& placed, std::uint32_t changed) {
    const engine::Instruction i = placed.instruction;
    const engine::Instruction to = engine::decode(changed);
    std::string text = placed.source.file + ":" + std::to_string(placed.source.line) + ": " +
                       placed.source.text + ":";
    const auto differs = [&text](const char* what, int before, int after) {
        if (before == after) return;
        text +=
            std::string(" ") + what + " " + std::to_string(before) + " -> " + std::to_string(after);
    };
    differs("op", static_cast<int>(i.op), static_cast<int>(to.op));
    differs("limbs", i.limbs, to.limbs);
    differs("flag", i.flag ? 1 : 0, to.flag ? 1 : 0);
    differs("f0", i.f0, to.f0);
    differs("f1", i.f1, to.f1);
    differs("f2", i.f2, to.f2);
    return text + "\n";
}

/// Sign of what a sum of 0 and a power sets flags of alone; 2 of others.
inline int sign_alone(const engine::Instruction& i) {
    const bool alone = engine::is_sum(i.op) && i.f2 < engine::kConstantWords &&
                       i.f0 == engine::kZero / engine::kWordLimbs && engine::is_power(i.f1);
    if (!alone) return 2;
    if ((i.f1 >> 4 & 3) >= i.limbs) return 0;
    return ((i.f1 & 15) == engine::kMinusOne) == (i.op == engine::Op::kSub) ? 1 : -1;
}

/// Changes of one instruction: it is deleted, or one such bit is another.
inline std::vector<std::uint32_t> mutants(const engine::Instruction& i) {
    std::vector<std::uint32_t> words{encode(engine::Instruction())};
    for (int bit = 0; bit < 32; ++bit) {
        if ((meaning(i) >> bit & 1) == 0) continue;
        const engine::Instruction to = engine::decode(encode(i) ^ std::uint32_t{1} << bit);
        if (sign_alone(i) == 2 || sign_alone(to) != sign_alone(i)) words.push_back(encode(to));
    }
    return words;
}

/// Changes that are seen, and that are not. One changes nothing where it changes no value that is
/// read or put out, and no clock, in all that a test runs: what is tested for zero is written where
/// nothing reads it, what has no lower bits is rounded.
struct MutantShare {
    int mutants = 0;
    int seen = 0;
    int change_nothing = 0;
    std::string deleted;  // and not seen, but it changes something
    std::string unseen;   // those besides, a line each

    /// Checks the share that is seen of those that change something: `least`, where all ran, a
    /// little less of a part of them.
    void expect(double least) const {
        std::printf("%d changes, %d seen, %d change nothing\n%s", mutants, seen, change_nothing,
                    cases(0, 1) != 0 ? unseen.c_str() : "");
        EXPECT_LE(change_nothing, 0.04 * mutants);
        const double part = least - 0.01 * cases(2, 0);
        EXPECT_GE(seen, part * (mutants - change_nothing)) << unseen;
    }
};

/// Runs every deletion in microcode from a place on, and every `each`th of the other mutants;
/// differs(program, trace) says whether one is seen. What does not end is. `meant` tells the
/// sources whose instructions are changed.
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
    MicrocodeTrace whole;
    if (differs(assembly.program(), whole)) throw std::logic_error("it differs without a change");
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
            MicrocodeTrace trace;
            try {
                seen = differs(program, trace);
            } catch (const std::runtime_error&) {
            }
            ++share.mutants;
            share.seen += seen ? 1 : 0;
            if (seen) continue;
            share.change_nothing += trace == whole ? 1 : 0;
            if (trace == whole) continue;
            if (mutant == 0) share.deleted += placed[n].source.text + "\n";
            share.unseen += described(placed[n], words[mutant]);
        }
    }
    return share;
}

}  // namespace curvecore::tb
