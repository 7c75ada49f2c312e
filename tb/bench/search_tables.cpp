// SPDX-License-Identifier: Apache-2.0
// Prints the figures of [Obukhov]'s search along the arc, as published and corrected, and writes
// them as JSON.
#include "ref/series/search_tables.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "ref/curve/arc_length.hpp"
#include "ref/series/spline_tables.hpp"
#include "tb/bench/claim_table.hpp"

namespace {

using namespace curvecore::ref;
using curvecore::tb::Table;

constexpr double kTickMs = 10;
constexpr double kTolerance = 1e-6;   // mm
constexpr double kMillion = 1e6;      // ticks
constexpr double kSampleMm = 2.5e-3;  // 1.5 m/min at 10 kHz

double tick_mm(double feed_m_min) { return feed_m_min * kTickMs / 60; }

Table stops_table() {
    Table table{"search_stops",
                "Simpson's rule with Runge's estimate, n doubled until it says that the tolerance "
                "is kept, on 20,000 random cubics in a cube of 10 mm: how often it is not, and the "
                "worst error of these",
                {"tolerance", "from n = 2", "from n = 8", "from n = 32"},
                {}};
    for (const double tolerance : {1e-3, 1e-6}) {
        std::vector<std::string> row{fmt::format("{:g} um", tolerance * 1e3)};
        for (const int first : {2, 8, 32}) {
            const FalseStops found = false_stops(tolerance, first, 20000);
            row.push_back(fmt::format("{:.2g} %, {:.2g} mm", found.share * 100, found.worst));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table ticks_table() {
    Table table{"search_ticks",
                "Search per tick of 10 ms, tolerance 1 nm: iterations of the mended search, mean "
                "(most), at three feeds; worst error at 6 m/min of the search as written and with "
                "the state of the tick before; over 10^6 ticks with lengths from the start and "
                "from the tick before",
                {"spline", "1.5 m/min", "6 m/min", "60 m/min", "as written, mm",
                 "stop test alone as written, mm", "10^6 ticks, from the start, mm",
                 "from the tick before, mm"},
                {}};
    for (const TestSpline& spline : test_splines()) {
        std::vector<std::string> row{spline.name};
        for (const double feed : {1.5, 6., 60.}) {
            const SearchRun run =
                search_run(spline.cubic, SearchForm::kMended, kTolerance, tick_mm(feed));
            row.push_back(fmt::format("{:.2f} ({})", run.mean, run.most));
        }
        const auto error = [&](SearchForm form, double ds) {
            row.push_back(
                fmt::format("{:.2g}", search_run(spline.cubic, form, kTolerance, ds).error));
        };
        error(SearchForm::kLiteral, tick_mm(6));
        error(SearchForm::kSigned, tick_mm(6));
        const double tiny = ArcLength(spline.cubic).length() / kMillion;
        error(SearchForm::kMended, tiny);
        error(SearchForm::kSummed, tiny);
        table.rows.push_back(row);
    }
    return table;
}

Table words_table() {
    Table table{
        "search_words",
        "The mended search in words, one sample each 2.5 um, tolerance 1 nm: products per "
        "sample, and the worst error along the path. The sixteen integrators take Order + 9 "
        "products a sample, 15, and 6 Order (Order + 1) a step, 252",
        {"spline", "24 fraction bits", "28", "32", "36"},
        {}};
    for (const TestSpline& spline : test_splines()) {
        std::vector<std::string> row{spline.name};
        for (const int fraction : {24, 28, 32, 36}) {
            const WordRun run = word_run(spline.cubic, fraction, kTolerance, kSampleMm);
            row.push_back(fmt::format("{:.0f}, {:.2g} mm", run.products, run.error));
        }
        table.rows.push_back(row);
    }
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Search along the arc: false stops, iterations, drift, cost in words");
    std::string json_path;
    app.add_option("-o,--json", json_path, "write {tables: {NAME: {claim, header, rows}}}");
    CLI11_PARSE(app, argc, argv);
    std::vector<Table> tables;
    for (const auto make : {stops_table, ticks_table, words_table}) {
        tables.push_back(make());
        print(tables.back());
    }
    return curvecore::tb::write_tables(tables, json_path);
}
