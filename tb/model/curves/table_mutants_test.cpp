// SPDX-License-Identifier: Apache-2.0
// Tables that are not what they were, by bytes and by lines: each is refused with its line, or is
// a table that everything takes which is made of one.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <random>
#include <regex>

#include "ref/bound/table_bound.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/microcode/table_comparison.hpp"
#include "tb/support/programs/mutator.hpp"

namespace curvecore::tb::table_mutants_test {

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

constexpr int kSteps = 2;
constexpr int kStep = 20;  // 2^20 units

/// Words of a segment with these values, which differ from row to row.
sysc::RunSegment words_of(const ref::CurveTable& table, int coef_bits,
                          std::map<std::string, std::array<double, 3>>& values) {
    sysc::RunSegment words;
    words.step_exponent = words.lambda = kStep;
    double value = 0.003;
    for (const auto& [field, row] : table.bus) {
        const ref::CurveRow& of = table.rows.at(row);
        for (int axis = 0; axis < (of.of_axis ? 3 : 1); ++axis) {
            const double scale = std::ldexp(1, coef_bits + of.fraction);
            const auto word = std::llround(value * scale);
            const_cast<std::int64_t*>(words_at(ref::bus_place(field), words))[axis] = word;
            values[row][axis] = static_cast<double>(word) / scale;
            value += 0.007;
        }
    }
    return words;
}

/// Takes a table as all that is made of one does; returns whether the engine draws it: then, where
/// no row leaves its range, each sample as the table in words.
bool take(const ref::CurveTable& table, ref::CoreParameters core, std::mt19937_64& random,
          int& drawn) {
    ref::TableSegment segment;
    const sysc::RunSegment words = words_of(table, core.coef_bits, segment.values);
    segment.k = segment.lambda = kStep;
    segment.steps = kSteps;
    const bool in_range = table_error(table, core, segment).beyond.empty();
    ref::add_table(std::make_shared<ref::CurveTable>(table), core);
    std::optional<MicrocodeOfTable> microcode;
    try {
        microcode.emplace(core);
    } catch (const assembler::AssemblyError& error) {
        EXPECT_NE(std::string(error.what()), "");
        return false;
    }
    if (!in_range) return true;
    EXPECT_EQ(microcode->draw(words, kSteps, random), 0) << table.text;
    EXPECT_FALSE(microcode->hazard()) << table.text;
    drawn += microcode->samples();
    return true;
}

TEST(TableMutants, AreRefusedWithTheirLineOrTaken) {
    const std::vector<std::string> tables{
        table("arc.net"),     table("spline.net"),   table("clothoid.net"),    table("quintic.net"),
        table("ellipse.net"), table("catenary.net"), table("archimedean.net"), table("series.net")};
    std::mt19937_64 random(11);
    Mutator mutator(tables, {"[k]", "'", ".1", " + ", "/i", "*", "@", "-", "sum(", "order\n",
                             "polished phi\n", "alias Dq phi'\n"});
    int taken = 0;
    int assembled = 0;
    int refused = 0;
    int drawn = 0;  // samples, of those that are assembled
    for (int n = mutations(600); n > 0; --n) {
        std::string text = tables[mutator.below(tables.size())];
        for (std::size_t changes = 1 + mutator.below(3); changes > 0; --changes) {
            if (mutator.below(4) > 0) {
                change_line(text, tables[mutator.below(tables.size())], mutator);
            } else {
                mutator.mutate(text);
            }
        }
        ref::CoreParameters core;
        core.order = 2 + static_cast<int>(mutator.below(3));
        core.mode = static_cast<int>(mutator.below(2));
        try {
            assembled += take(ref::read_curve_text("c.net", text), core, random, drawn) ? 1 : 0;
            ++taken;
        } catch (const ref::InputError& error) {
            EXPECT_TRUE(std::regex_search(error.what(), std::regex("^c\\.net:[0-9]+: error: ")))
                << error.what();
            ++refused;
        } catch (const std::exception& error) {
            FAIL() << error.what() << " of\n" << text;
        }
    }
    std::cout << taken << " taken, " << refused << " refused, " << drawn << " places of axes\n";
    EXPECT_GT(taken, 20);
    EXPECT_GT(assembled, 20);
    EXPECT_GT(refused, 100);
    EXPECT_GT(drawn, 500);
}

}  // namespace curvecore::tb::table_mutants_test
