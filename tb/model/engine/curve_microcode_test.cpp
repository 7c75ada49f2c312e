// SPDX-License-Identifier: Apache-2.0
// Microcode that the assembler makes of ref/curves/ draws the kernels' words, in every
// configuration of tb/configurations.csv; an instruction deleted or a field changed is seen.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "tb/model/engine/microcode_machine.hpp"
#include "tb/model/engine/microcode_mutants.hpp"
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

TEST(CurveMicrocode, AChangedInstructionIsSeen) {
    for (const bool spline : {false, true}) {
        for (const int mode : {0, 1}) {
            CurveCase of;
            of.spline = spline;
            of.core.mode = mode;
            const CurveMicrocode code = curve_microcode(of);
            const MutantShare share =
                seen_mutants(code.assembly, static_cast<std::size_t>(cases(29, 1)),
                             [&](const std::vector<std::uint32_t>& program) {
                                 MicrocodeMachine machine(code.assembly, program);
                                 CurveComparison comparison(of, code, machine);
                                 std::mt19937_64 random(1);
                                 int differ = 0;
                                 for (int n = 0; n < 8 && differ == 0; ++n) {
                                     differ = comparison.segment(random, 3, 3);
                                 }
                                 return differ > 0;
                             });
            EXPECT_EQ(share.deleted, "") << text(of);
            EXPECT_GE(share.seen, 0.99 * share.mutants) << text(of) << ": of " << share.mutants;
        }
    }
}

}  // namespace
}  // namespace curvecore::tb
