// SPDX-License-Identifier: Apache-2.0
// Tables that are not what they were, by bytes and by lines: each is refused with its line, or is
// a table that everything takes which is made of one.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "ref/bound/table_bound.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/text/input_error.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"
#include "tb/support/programs/mutator.hpp"

namespace curvecore::tb {
namespace {

std::string table(const char* name) {
    std::ifstream file(std::string(CURVES_DIR) + "/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Leaves a line out, or puts one of another table before it or in its place.
void change_line(std::string& text, const std::string& other, Mutator& mutator) {
    const auto line_of = [&](const std::string& of) {
        const std::size_t begin = of.rfind('\n', mutator.below(of.size())) + 1;
        return std::pair(begin, of.find('\n', begin) - begin);
    };
    if (text.empty()) return;
    const auto [begin, length] = line_of(text);
    const auto [from, count] = line_of(other);
    const std::size_t kind = mutator.below(3);
    text.replace(begin, kind == 0 ? 0 : length, kind == 1 ? "" : other.substr(from, count) + "\n");
}

/// Takes a table as all that is made of one does; returns whether the engine draws it.
bool take(const ref::CurveTable& table, const ref::CoreParameters& core) {
    ref::TableSegment segment;
    for (const auto& [field, row] : table.bus) segment.values[row] = {0.01, 0.02, 0.03};
    segment.steps = 2;
    table_error(table, core, segment);
    try {
        assembler::curve_program(table, core);
        return true;
    } catch (const assembler::AssemblyError& error) {
        EXPECT_NE(std::string(error.what()), "");
        return false;
    }
}

TEST(TableMutants, AreRefusedWithTheirLineOrTaken) {
    const std::vector<std::string> tables{table("arc.net"), table("spline.net"),
                                          table("clothoid.net")};
    Mutator mutator(tables, {"[k]", "'", ".1", " + ", "/i", "*", "@", "-", "sum(", "order\n",
                             "polished phi\n", "alias Dq phi'\n"});
    int taken = 0;
    int assembled = 0;
    int refused = 0;
    for (int n = mutations(600); n > 0; --n) {
        std::string text = tables[mutator.below(3)];
        for (std::size_t changes = 1 + mutator.below(3); changes > 0; --changes) {
            if (mutator.below(4) > 0) {
                change_line(text, tables[mutator.below(3)], mutator);
            } else {
                mutator.mutate(text);
            }
        }
        ref::CoreParameters core;
        core.order = 2 + static_cast<int>(mutator.below(3));
        core.mode = static_cast<int>(mutator.below(2));
        try {
            assembled += take(ref::read_curve_text("c.net", text), core) ? 1 : 0;
            ++taken;
        } catch (const ref::InputError& error) {
            EXPECT_TRUE(std::regex_search(error.what(), std::regex("^c\\.net:[0-9]+: error: ")))
                << error.what();
            ++refused;
        } catch (const std::exception& error) {
            FAIL() << error.what() << " of\n" << text;
        }
    }
    std::cout << taken << " taken, " << refused << " refused\n";
    EXPECT_GT(taken, 20);
    EXPECT_GT(assembled, 20);
    EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace curvecore::tb
