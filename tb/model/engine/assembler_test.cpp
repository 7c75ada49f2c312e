// SPDX-License-Identifier: Apache-2.0
// Refusals of the microcode's assembler: the line and the reason.
#include <gtest/gtest.h>

#include <functional>

#include "rtl/engine/assembler/assembly.hpp"
#include "rtl/engine/assembler/listing.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/support/microcode/curve_comparison.hpp"

namespace curvecore::assembler::assembler_test {

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

TEST(Assembler, ASourceIsRefusedWithItsLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"a = b + d", "no word d"},
        {"e = a + b", "no word e"},
        {"a = b c", "expected '*', not 'c'"},
        {"a = b / c", "expected '*', not '/'"},
        {"a = b * c >> 44", "expected the end of the line, not '>>'"},
        {"a = b + (c * 2^1 >> 45)", "in d = c + (d * b >> 45) both d are one word"},
        {"a = b * 2^60", "2^60 is no power of an instruction: 0 .. 59"},
        {"a = b * a", "hazard: a is read while it is written"},
        {"a += wide b * c", "a is no wide word"},
        {"a = b + c, 5 limbs", "an instruction has 1 .. 4 limbs"},
        {"a = b + 99999999999999", "the constant 99999999999999 needs more than three limbs"},
        {"go to nowhere", "no label nowhere"},
        {"if port 2 go to x", "conditions of ports are 3 .. 15"},
        {"if a go to x", "expected 'port', not 'a'"},
        {"repeat 5 times", "the end of a loop that was not opened"},
        {"word 5", "'5' is no name"}};
    for (const auto& [line, reason] : cases) {
        Assembly assembly;
        std::string message;
        try {
            assemble_text("p.asm", std::string("word a b c\nx:\n") + line + "\n", assembly);
            assembly.finish();
        } catch (const AssemblyError& error) {
            message = error.what();
        }
        EXPECT_EQ(message, std::string("p.asm:3: error: ") + reason) << line;
    }
}

TEST(Assembler, AListingIsASourceAgain) {
    const char* const text =
        "word a b c\nwide w\nx:\na = b + c\na = b - c, 4 limbs\na = b * 2^10\na = b * c >> 45\n"
        "a = floor(b * -1 >> 45)\na = b + (a * c >> 45)\nw = wide a * b\nw += wide b * c\n"
        "a = wide w * 2^20 >> 45\na = floor(wide w * 2^3 >> 45)\na = b + 2^7\na = port 5\nport 6 = "
        "a, 2 limbs\nif not negative go to x\n"
        "if port 4 go to x\nif zero call x\nif not zero return\ncall x\nreturn\n"
        "wait for the tick, go to x\nend, then x\n";
    Assembly assembly;
    assemble_text("p.asm", text, assembly);
    assembly.finish();
    const std::string shown = listing(assembly, {});
    for (const Placed& placed : assembly.placed()) {
        const std::string line = placed.source.text.substr(0, placed.source.text.find(','));
        const std::size_t found = shown.find(line);
        ASSERT_NE(found, std::string::npos) << line;
        EXPECT_LT(found, shown.find("| p.asm:" + std::to_string(placed.source.line) + ":")) << line;
    }
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
    EXPECT_EQ(refused(words(153, false)),
              ": error: the programs need 33 words beyond those without a page, there are 32");
    EXPECT_EQ(refused(words(152, false)), "");
    EXPECT_EQ(refused(words(33, true)),
              ": error: the programs need 33 words of each axis, there are 32");
    EXPECT_EQ(refused(words(33, true), {2048, 256, 2}),
              ": error: the data need 320 words, the store has 256");
    EXPECT_EQ(refused(words(33, true), {2048, 512, 2}), "");
}

TEST(Assembler, WordsBeyondThoseWithoutAPageStandInPageY) {
    Assembly assembly;
    for (int n = 0; n < 121; ++n) assembly.word("w" + std::to_string(n));
    EXPECT_EQ(assembly.field("w119").code, 127);
    EXPECT_EQ(assembly.field("w120").code, int{engine::kY});
    EXPECT_EQ(assembly.place("w120"), 7 * engine::kPageWords);
    const Field wide = assembly.wide("w");
    EXPECT_EQ(wide.code, engine::kY + 2);
    const Field constant = assembly.constant(-7);
    EXPECT_EQ(assembly.data().at(7 * engine::kPageWords + 4).value, -7);
    EXPECT_EQ(constant.code, engine::kY + 4);
    assembly.auxiliary_word("x");
    EXPECT_THROW(assembly.finish(), AssemblyError);  // they would stand in the same page
}

TEST(Assembler, AStoreOfMoreWordsHasThemInPageXToo) {
    Assembly assembly({2048, 512, 1});
    for (int n = 0; n < 153; ++n) assembly.word("w" + std::to_string(n));
    EXPECT_EQ(assembly.field("w151").code, engine::kY + 31);
    EXPECT_EQ(assembly.field("w152").code, int{engine::kX});
    EXPECT_EQ(assembly.place("w151"), 15 * engine::kPageWords - 1);
    EXPECT_EQ(assembly.place("w152"), 15 * engine::kPageWords);
    EXPECT_NO_THROW(assembly.finish());
    assembly.open_further();
    const std::size_t pages = assembly.placed().size();
    EXPECT_EQ(pages, 3u);  // -2, and both
    assembly.axis_word("x");
    assembly.from({"p.asm", 1, ""});
    assembly.call_for_axes("of_axis");
    EXPECT_EQ(assembly.placed().back().instruction.op, engine::Op::kOut);  // and there it is again
    assembly.give_back();
    assembly.label("of_axis");
    assembly.copy(assembly.field("x"), assembly.field("w151"));
    assembly.give_back();
    EXPECT_NO_THROW(assembly.finish());
    EXPECT_EQ(
        refused(
            [](Assembly& a) {
                for (int n = 0; n < 153; ++n) a.word("w" + std::to_string(n));
                a.call_for_axes("of_axis");
                a.give_back();
                a.label("of_axis");
                a.copy(a.axis_word("x"), a.word("w152"));
                a.give_back();
            },
            {2048, 512, 1}),
        "p.net:3: error: of_axis is called for axes: their pages have none of the words beyond");
}

TEST(Assembler, LocalsOfAllSourcesShareTheirWords) {
    Assembly assembly;
    assemble_text("p.asm", "word kept\nlocal a b\na = kept\nb = a\n", assembly);
    assemble_text("q.asm", "word kept\nlocal c\nc = kept\n", assembly);
    assembly.finish();
    const auto& placed = assembly.placed();
    EXPECT_EQ(placed[0].instruction.f2, placed[2].instruction.f2);
    EXPECT_NE(placed[0].instruction.f2, placed[1].instruction.f2);
    EXPECT_EQ(placed[0].instruction.f0, placed[2].instruction.f0);
    EXPECT_THROW(assemble_text("q.asm", "word kept\nkept = a\n", assembly), AssemblyError);
}

TEST(Assembler, AWordHasItsValueAtReset) {
    Assembly assembly;
    assembly.from({"begin", 0, ""});
    assembly.branch("begin");
    assembly.branch("begin");
    assemble_text("p.asm", "word idle = 24529\nword path = - 3, 4 limbs\nwide sum = 0\nbegin:\n",
                  assembly);
    assembly.put_starts();
    assembly.label("end");
    assembly.branch("end");
    assembly.finish();
    std::vector<std::int16_t> memory = assembly.memory();
    const auto limb = [&](const char* word, int n) {
        return std::size_t{engine::kWordLimbs} * static_cast<std::size_t>(assembly.place(word)) +
               static_cast<std::size_t>(n);
    };
    for (const char* word : {"idle", "path"}) {
        for (int n = 0; n < engine::kWordLimbs; ++n) memory[limb(word, n)] = 77;
    }
    for (int n = 0; n < 6; ++n) memory[limb("sum", n)] = 77;
    engine::Engine engine(assembly.program(), memory);
    engine::QuietBoard board;
    for (int n = 0; n < 16; ++n) engine.step(board);
    const auto& after = engine.memory();
    EXPECT_EQ(after[limb("idle", 0)], 24529);
    EXPECT_EQ(after[limb("idle", 2)], 0);
    EXPECT_EQ(after[limb("idle", 3)], 77);  // of three limbs
    EXPECT_EQ(after[limb("path", 0)], 0x7ffd);
    EXPECT_EQ(after[limb("path", 3)], -1);
    for (int n = 0; n < 6; ++n) EXPECT_EQ(after[limb("sum", n)], 0) << n;
    EXPECT_EQ(assembly.data().size(), 6U);  // no constants but the pages of axes
}

TEST(Assembler, APowerOfTwoNeedsNoWord) {
    Assembly assembly;
    assemble_text("p.asm",
                  "word a\ndata page = 16\na = a + 1\na = a - page\na = a + 2^44\na = a + 3\n"
                  "axis x[k]\nx[k] = a\n",
                  assembly);
    const auto& placed = assembly.placed();
    EXPECT_EQ(placed[0].instruction.f1, engine::power(0));
    EXPECT_EQ(placed[1].instruction.f1, engine::power(4));
    EXPECT_EQ(placed[2].instruction.f1, engine::power(44));
    EXPECT_EQ(assembly.data().at(placed[3].instruction.f1).value, 3);
    EXPECT_EQ(placed[4].instruction.f2, int{engine::kX});
    EXPECT_EQ(assembly.data().size(), 6U);  // with the pages of the axes
    assemble_text("q.asm", "word b\nb = page\nb = 2 * 2^30, 4 limbs\nb = 3\n", assembly);
    EXPECT_EQ(placed[5].instruction.op, engine::Op::kAdd);
    EXPECT_EQ(placed[5].instruction.f1, engine::power(4));
    EXPECT_EQ(placed[6].instruction.f1, engine::power(31));
    EXPECT_EQ(placed[6].instruction.limbs, 4);
    EXPECT_EQ(placed[7].instruction.op, engine::Op::kMull);
    EXPECT_EQ(assembly.data().size(), 7U);
}

TEST(Assembler, ANumberHasOneName) {
    Assembly assembly;
    assemble_text("p.asm", "word a\ndata memory = 3\ndata less = - 5\nport memory = a\na = less\n",
                  assembly);
    EXPECT_EQ(assembly.placed()[0].instruction.f1, 3);
    EXPECT_EQ(assembly.data().at(assembly.placed()[1].instruction.f0).value, -5);
    EXPECT_NO_THROW(assemble_text("q.asm", "data memory = 3\n", assembly));
    try {
        assemble_text("q.asm", "data memory = 4\n", assembly);
        ADD_FAILURE() << "two numbers";
    } catch (const AssemblyError& error) {
        EXPECT_STREQ(error.what(), "q.asm:1: error: memory is there twice, with another number");
    }
}

TEST(Assembler, ANameIsAWordOrANumber) {
    const auto refusal = [](const std::string& text) -> std::string {
        Assembly assembly;
        try {
            assemble_text("p.asm", text, assembly);
        } catch (const AssemblyError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal("word a b\ndata b = 3\n"), "p.asm:2: error: b is a word already");
    EXPECT_EQ(refusal("data b = 3\nlocal a b\n"), "p.asm:2: error: b is a number already");
    EXPECT_EQ(refusal("word a\ndata b = 3\n"), "");
}

TEST(Assembler, ALinkGoesToThePlaceOfALabel) {
    Assembly assembly;
    assembly.from({"begin", 0, ""});
    assembly.branch("begin");
    assembly.branch("begin");
    assemble_text("p.asm",
                  "word next = place of far, 1 limb\nword a\nnear:\na = place of near, 1 limb\n"
                  "far:\nport 2 = next, 1 limb\nreturn\nbegin:\n",
                  assembly);
    assembly.put_starts();
    assembly.branch("near");
    assembly.finish();
    engine::Engine engine(assembly.program(), assembly.memory());
    engine::QuietBoard board;
    std::vector<int> places;
    for (int n = 0; n < 9; ++n) {
        engine.step(board);
        places.push_back(engine.place(false));
    }
    EXPECT_EQ(places, (std::vector<int>{5, 6, 7, 2, 3, 4, 3, 4, 3}));  // far is 3, near 2
    EXPECT_EQ(engine.memory()[std::size_t{engine::kWordLimbs} *
                              static_cast<std::size_t>(assembly.place("a"))],
              2);

    Assembly other;
    assemble_text("p.asm", "word a\na = place of nowhere\nword next = place of nowhere\n", other);
    const std::pair<void (Assembly::*)(), const char*> ends[] = {
        {&Assembly::put_starts, "p.asm:3: error: no label nowhere"},
        {&Assembly::finish, ": error: no label nowhere"}};
    for (const auto& [end, reason] : ends) {
        try {
            (other.*end)();
            ADD_FAILURE() << reason;
        } catch (const AssemblyError& error) {
            EXPECT_STREQ(error.what(), reason);
        }
    }
}

TEST(Assembler, AWayEndsWhereAnEndIsCalled) {
    Assembly assembly;
    assemble_text("p.asm", "word a\np:\na = a + a\ncall q\ngo to p\nq:\nreturn\n", assembly);
    assembly.finish();
    EXPECT_EQ(worst_case(assembly, "p", {"q"}), 10 + 3);
    EXPECT_THROW(worst_case(assembly, "p"), AssemblyError);
}

TEST(Assembler, TheWorstCaseIsWhatTheTwinTakes) {
    for (const bool spline : {false, true}) {
        tb::CurveCase of;
        of.spline = spline;
        const tb::CurveMicrocode code = tb::curve_microcode(of);
        tb::MicrocodeMachine machine(code.assembly);
        tb::CurveComparison comparison(of, code, machine);
        std::mt19937_64 random(3);
        for (int n = 0; n < 20; ++n) comparison.segment(random, 2, 1);
        const std::string name = spline ? "spline" : "arc";
        const auto clocks = [&](const char* program) {
            return worst_case(code.assembly, name + program, {"idle"});
        };
        EXPECT_EQ(comparison.most_clocks(1), clocks("_step"));
        EXPECT_EQ(comparison.most_clocks(2), clocks("_sample"));
        EXPECT_EQ(machine.run(0), clocks("_load"));
        const int step = clocks("_step");
        EXPECT_NO_THROW(keep_period(code.assembly, name + "_step", {"idle"}, step));
        try {
            keep_period(code.assembly, name + "_step", {"idle"}, step - 1);
            ADD_FAILURE() << "a period too short is kept";
        } catch (const AssemblyError& error) {
            EXPECT_EQ(error.what(), name + "_step: error: takes " + std::to_string(step) +
                                        " clocks, the period has " + std::to_string(step - 1));
        }
    }
}

TEST(Assembler, AWayRoundWithoutABoundIsRefused) {
    Assembly assembly;
    assembly.from({"p.net", 3, "line"});
    assembly.label("here");
    assembly.copy(assembly.word("a"), assembly.word("b"));
    assembly.branch("here", engine::kNegative);
    assembly.give_back();
    assembly.finish();
    try {
        worst_case(assembly, "here");
        ADD_FAILURE() << "it has no end";
    } catch (const AssemblyError& error) {
        EXPECT_STREQ(error.what(), "p.net:3: error: a loop without a bound");
    }
}

TEST(Assembler, TheListingHasEveryInstructionBesideItsLine) {
    const tb::CurveMicrocode code = tb::curve_microcode({});
    const std::string text = listing(
        code.assembly, {{"arc_load", "idle"}, {"arc_step", "idle"}, {"arc_sample", "idle"}});
    for (const char* row :
         {"arc_step: at most 1283 clocks\n",
          "N[k].4 = w.4<<10 * T[k].3 >> 45              | arc.net:20: N[k] : -2 = w@T[k]'",
          "w.3 = theta * 1/3 >> 45 ",
          " 16  fine[k] = origin[k] + (fine[k] * 2^(fine+k) >> 45) | "}) {
        EXPECT_NE(text.find(row), std::string::npos) << row;
    }
    EXPECT_EQ(program_hex(code.assembly).size(), std::size_t{9 * 2048});
    EXPECT_EQ(data_hex(code.assembly).size(), std::size_t{5 * 4 * 256});
    EXPECT_EQ(data_hex(code.assembly).substr(0, 25), "0001\n0002\n0004\n0008\n0010\n");
    if (std::getenv("LISTING") != nullptr) std::printf("%s", text.c_str());
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

}  // namespace curvecore::assembler::assembler_test
