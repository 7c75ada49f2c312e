// SPDX-License-Identifier: Apache-2.0
// Microcode that the assembler makes of ref/curves/ draws the kernels' words, in every
// configuration of tb/configurations.csv; an instruction deleted or a field changed is seen.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "tb/model/engine/microcode_machine.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

/// The configurations of the table, as far as this build has them: anchored, without guard bits.
std::vector<CurveCase> configurations() {
    std::ifstream table(std::string(DATA_DIR) + "/../configurations.csv");
    std::vector<CurveCase> cases;
    std::set<std::string> seen;
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        CurveCase one;
        one.core.order = std::stoi(cells[3]);
        one.core.coef_bits = std::stoi(cells[4]);
        one.core.position_bits = std::stoi(cells[5]);
        one.core.guard_bits = std::stoi(cells[6]);
        one.core.aux_axes = std::stoi(cells[7]);
        one.core.mode = std::stoi(cells[9]);
        for (const bool spline : {false, true}) {
            one.spline = spline;
            if (spline && cells[0].find("spherical") == 0) continue;
            if (!spline && cells[0].find("spline") == 0) continue;
            std::string key = spline ? "s" : "a";
            for (std::size_t n = 3; n <= 9; ++n) key += n == 8 ? "" : "," + cells[n];
            if (seen.insert(key).second) cases.push_back(one);
        }
    }
    return cases;
}

std::string text(const CurveCase& of) {
    std::ostringstream out;
    out << (of.spline ? "spline" : "arc") << " Order " << of.core.order << " CoefBits "
        << of.core.coef_bits << " PositionBits " << of.core.position_bits << " GuardBits "
        << of.core.guard_bits << " AuxAxes " << of.core.aux_axes << " Mode " << of.core.mode;
    return out.str();
}

/// The store of all configurations; that of Order 6 is 256 words of data, a page for an axis.
constexpr assembler::StoreSize kLargeStore{4096, 512, 2};

TEST(CurveMicrocode, EqualsTheKernelsInEveryConfiguration) {
    std::int64_t words = 0;
    for (const CurveCase& of : configurations()) {
        const CurveMicrocode code = curve_microcode(of, kLargeStore);
        MicrocodeMachine machine(code.assembly);
        CurveComparison comparison(of, code, machine);
        std::mt19937_64 random(7);
        int differ = 0;
        for (int n = 0; n < 12; ++n) differ += comparison.segment(random, 3, 3);
        EXPECT_EQ(differ, 0) << text(of);
        EXPECT_EQ(comparison.ranges().missing(), 0) << text(of);
        EXPECT_FALSE(machine.hazard()) << text(of);
        words += comparison.words();
    }
    EXPECT_GT(words, 100000);
}

/// Bits of an instruction whose change is another instruction. A fourth limb is read by nothing,
/// and by hls/instruction.hpp bit 6 of a page's word is not looked at; 0 times anything is 0; of
/// branches that are always taken the place alone, and what gives back.
std::uint32_t meaning(const engine::Instruction& i) {
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
    std::uint32_t bits = kF2 & ~(i.f2 >= engine::kX ? kPageBit : 0);
    if (!(engine::is_product(i.op) && i.f0 == engine::kZero / engine::kWordLimbs)) {
        bits |= (kF0 & ~(i.f0 >= engine::kX ? kPageBit << 16 : 0)) | kF1;
        bits |= engine::is_high(i.op) ? kFlag : 0;
    }
    return bits | (i.op == engine::Op::kMac ? kFlag : i.limbs == 3 ? kFewerLimbs : 0);
}

/// Changes of one instruction: it is deleted, or one such bit is another.
std::vector<std::uint32_t> mutants(const engine::Instruction& i) {
    std::vector<std::uint32_t> words{encode(engine::Instruction())};
    for (int bit = 0; bit < 32; ++bit) {
        if ((meaning(i) >> bit & 1) != 0) words.push_back(encode(i) ^ std::uint32_t{1} << bit);
    }
    return words;
}

struct Share {
    int mutants = 0;
    int seen = 0;
    std::string deleted;  // and not seen
};

bool is_seen(const CurveCase& of, const CurveMicrocode& code, std::vector<std::uint32_t> program) {
    MicrocodeMachine machine(code.assembly, std::move(program));
    CurveComparison comparison(of, code, machine);
    std::mt19937_64 random(1);
    try {
        for (int segment = 0; segment < 8; ++segment) {
            if (comparison.segment(random, 3, 3) > 0) return true;
        }
    } catch (const std::runtime_error&) {
        return true;  // it does not end
    }
    return false;
}

/// Runs every deletion in a curve's microcode, and every `each`th of the other mutants.
Share seen_mutants(const CurveCase& of, std::size_t each) {
    const CurveMicrocode code = curve_microcode(of);
    const std::vector<assembler::Placed>& placed = code.assembly.placed();
    Share share;
    std::size_t count = 0;
    for (std::size_t n = code.assembly.labels().at("dispatched"); n < placed.size(); ++n) {
        const std::vector<std::uint32_t> words = mutants(placed[n].instruction);
        for (std::size_t mutant = 0; mutant < words.size(); ++mutant) {
            if (mutant > 0 && count++ % each != 0) continue;
            std::vector<std::uint32_t> program = code.assembly.program();
            program[n] = words[mutant];
            const bool seen = is_seen(of, code, program);
            ++share.mutants;
            share.seen += seen ? 1 : 0;
            if (!seen && mutant == 0) share.deleted += placed[n].source.text + "\n";
        }
    }
    return share;
}

TEST(CurveMicrocode, AChangedInstructionIsSeen) {
    for (const bool spline : {false, true}) {
        for (const int mode : {0, 1}) {
            CurveCase of;
            of.spline = spline;
            of.core.mode = mode;
            const Share share = seen_mutants(of, static_cast<std::size_t>(cases(29, 1)));
            EXPECT_EQ(share.deleted, "") << text(of);
            EXPECT_GE(share.seen, 0.99 * share.mutants) << text(of) << ": of " << share.mutants;
        }
    }
}

}  // namespace
}  // namespace curvecore::tb
