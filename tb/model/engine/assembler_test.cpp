// SPDX-License-Identifier: Apache-2.0
// Refusals of the microcode's assembler: the line and the reason.
#include <gtest/gtest.h>

#include <functional>

#include "rtl/engine/assembler/assembly.hpp"
#include "tb/model/engine/microcode_machine.hpp"

namespace curvecore::assembler {
namespace {

std::string refused(const std::function<void(Assembly&)>& write, const StoreSize& size = {}) {
    Assembly assembly(size);
    try {
        assembly.from({"p.net", 3, "line"});
        write(assembly);
        assembly.finish();
    } catch (const AssemblyError& error) {
        return error.what();
    }
    return "";
}

TEST(Assembler, RefusalNamesLineAndReason) {
    EXPECT_EQ(refused([](Assembly& a) { a.branch("nowhere"); }),
              "p.net:3: error: no label nowhere");
    EXPECT_EQ(refused([](Assembly& a) {
                  a.label("here");
                  a.label("here");
              }),
              "p.net:3: error: the label here is there twice");
    EXPECT_EQ(refused([](Assembly& a) { a.constant(std::int64_t{1} << 45); }),
              "p.net:3: error: the constant 35184372088832 needs more than three limbs");
    EXPECT_EQ(refused([](Assembly& a) { a.add(a.word("a"), a.word("a"), a.power(60)); }),
              "p.net:3: error: 2^60 is no power of an instruction: 0 .. 59");
    EXPECT_EQ(refused([](Assembly& a) {
                  a.put(engine::Op::kMull, a.word("a"), a.word("b"), a.word("a"));
              }),
              "p.net:3: error: hazard: a is read while it is written");
    EXPECT_EQ(refused([](Assembly& a) {
                  a.loop();
                  a.repeat(0, engine::kNegative);
              }),
              "p.net:3: error: a loop without a bound: 0");
    EXPECT_EQ(refused([](Assembly& a) { a.loop(); }), ": error: a loop has no end");
}

TEST(Assembler, AFullStoreNamesTheWordsNeeded) {
    const auto copies = [](Assembly& a) {
        for (int n = 0; n < 5; ++n) a.copy(a.word("b"), a.word("a"));
    };
    EXPECT_EQ(refused(copies, {4, 256, 1}),
              ": error: the programs need 5 instructions, the store has 4");
    EXPECT_EQ(refused(copies, {8, 256, 1}), "");
    const auto words = [](int count, bool of_axis) {
        return [=](Assembly& a) {
            for (int n = 0; n < count; ++n) {
                const std::string name = "w" + std::to_string(n);
                of_axis ? a.axis_word(name) : a.word(name);
            }
        };
    };
    EXPECT_EQ(refused(words(121, false)),
              ": error: the programs need 121 words that all axes share, there are 120");
    EXPECT_EQ(refused(words(120, false)), "");
    EXPECT_EQ(refused(words(33, true)),
              ": error: the programs need 33 words of each axis, there are 32");
    EXPECT_EQ(refused(words(33, true), {2048, 256, 2}),
              ": error: the data need 320 words, the store has 256");
    EXPECT_EQ(refused(words(33, true), {2048, 512, 2}), "");
}

TEST(Assembler, ASplineOfOrder12NeedsTheLargeStore) {
    tb::CurveCase of;
    of.spline = true;
    of.core.order = 12;
    of.core.mode = 1;
    EXPECT_THROW(tb::curve_microcode(of), AssemblyError);
    EXPECT_NO_THROW(tb::curve_microcode(of, {2048, 512, 2}));
    of.core.order = 6;
    EXPECT_NO_THROW(tb::curve_microcode(of));
}

}  // namespace
}  // namespace curvecore::assembler
