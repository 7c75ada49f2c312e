// SPDX-License-Identifier: Apache-2.0
// Prints the figures of integrating a spline's sixteen variables, as Markdown tables beside the
// paper's claims, and writes them as JSON. It takes half a minute.
#include "ref/series/spline_tables.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "tb/bench/claim_table.hpp"

namespace {

using namespace curvecore::ref;
using curvecore::tb::Cells;
using curvecore::tb::Table;

struct Way {
    const char* name;
    SplineMethod method;
    int order;
};

void progress(const std::string& what) {
    fmt::print(stderr, "\r{:<60}", what);
    std::fflush(stderr);
}

Cells header_of(Cells first, const std::vector<Way>& ways) {
    for (const Way& way : ways) {
        first.emplace_back(way.name);
    }
    return first;
}

std::string deviation(const Deviation& found) {
    if (found.blow_up) {
        return "blows up";
    }
    const std::string position = fmt::format("{:.2g}", found.position);
    return found.feed < 0.005 ? position
                              : fmt::format("{} (feed {:+.0f} %)", position, 100 * found.feed);
}

Table tick_table() {
    const std::vector<Way> ways{{"Runge-Kutta, 16 variables", SplineMethod::kRungeKutta, 4},
                                {"Taylor 8, propagated", SplineMethod::kPropagated, 8},
                                {"Taylor 8, 1/V each step", SplineMethod::kRenormalised, 8},
                                {"Taylor 8, a Newton step", SplineMethod::kNewton, 8},
                                {"Runge-Kutta, u alone", SplineMethod::kScalar, 4}};
    Table table{"spline_tick",
                "Paper: unstable already at 1.5 to 2 m/min where the curvature changes sharply. "
                "Measured: largest position error in mm, one step per tick of 10 ms",
                header_of({"spline", "m/min"}, ways),
                {}};
    for (const TestSpline& spline : test_splines()) {
        for (const double feed : kSplineFeedsMetresPerMinute) {
            Cells row{spline.name, fmt::format("{}", feed)};
            for (const Way& way : ways) {
                progress(fmt::format("tick: {} at {} m/min", spline.name, feed));
                row.push_back(deviation(
                    follow(spline.cubic, way.method, way.order, tick_path(feed, kSplineTickMs))));
            }
            table.rows.push_back(row);
        }
    }
    return table;
}

Table period_table() {
    const std::vector<Way> ways{{"Runge-Kutta, 16 variables", SplineMethod::kRungeKutta, 4},
                                {"Taylor 8, propagated", SplineMethod::kPropagated, 8},
                                {"Taylor 12, propagated", SplineMethod::kPropagated, 12},
                                {"Taylor 8, 1/V each step", SplineMethod::kRenormalised, 8},
                                {"Taylor 12, 1/V each step", SplineMethod::kRenormalised, 12},
                                {"Runge-Kutta, u alone", SplineMethod::kScalar, 4}};
    Table table{"spline_period",
                "Paper: the period needed is below 0.05 ms. Measured: largest period in ms for 1 um"
                " at 1.5 / 2 m/min over a hairpin",
                header_of({"radius mm", "deep mm"}, ways),
                {}};
    struct Hairpin {
        double radius, depth;
    };
    for (const Hairpin& tip : {Hairpin{3, 20}, Hairpin{1, 20}, Hairpin{0.3, 20}, Hairpin{0.1, 20},
                               Hairpin{0.03, 20}, Hairpin{0.01, 20}, Hairpin{0.01, 5}}) {
        Cells row{fmt::format("{}", tip.radius), fmt::format("{}", tip.depth)};
        for (const Way& way : ways) {
            progress(fmt::format("period: radius {} mm, {}", tip.radius, way.name));
            const double step = largest_step(hairpin(tip.radius, tip.depth), way.method, way.order);
            row.push_back(
                fmt::format("{:.2g} / {:.2g}", step / tick_path(1.5, 1), step / tick_path(2, 1)));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table order_table() {
    const std::vector<Way> ways{{"Runge-Kutta", SplineMethod::kRungeKutta, 4},
                                {"Taylor 4", SplineMethod::kPropagated, 4},
                                {"Taylor 6", SplineMethod::kPropagated, 6},
                                {"Taylor 8", SplineMethod::kPropagated, 8},
                                {"Taylor 12", SplineMethod::kPropagated, 12}};
    Table table{"spline_order",
                "Paper: methods of an order above 4 are needed. Measured: position error in mm, all"
                " sixteen variables propagated, 1 ms at 1.5 m/min",
                header_of({"hairpin radius mm"}, ways),
                {}};
    for (const double radius : {0.3, 0.1, 0.03}) {
        Cells row{fmt::format("{}", radius)};
        for (const Way& way : ways) {
            progress(fmt::format("order: radius {} mm, {}", radius, way.name));
            row.push_back(
                deviation(follow(hairpin(radius), way.method, way.order, tick_path(1.5, 1))));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table vertex_table() {
    constexpr std::array<int, 4> kOrders{4, 8, 12, 32};
    Table table{"spline_vertex",
                "Why: the series converge up to pi/4 of the radius only. Error in mm of one step "
                "from the vertex of a hairpin of 0.3 mm",
                {"step / radius of convergence"},
                {}};
    for (const int order : kOrders) {
        table.header.push_back(fmt::format("order {}", order));
    }
    for (const double share : {0.1, 0.2, 0.5, 0.9}) {
        Cells row{fmt::format("{}", share)};
        for (const int order : kOrders) {
            progress(fmt::format("vertex: {} of the radius, order {}", share, order));
            row.push_back(fmt::format("{:.2g}", vertex_error(0.3, share, order)));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table drift_table() {
    Table table{
        "spline_drift",
        "Long runs, order 8: position error in mm and phi V - 1 at the end; double at steps "
        "of 5e-5 mm, float at 5e-3 mm",
        {"spline", "steps", "double, propagated", "double, a Newton step", "float, propagated",
         "float, a Newton step"},
        {}};
    std::vector<TestSpline> splines = test_splines();
    splines.push_back({"hairpin 0.01", hairpin(0.01)});
    for (const TestSpline& spline : splines) {
        if (spline.name != "gentle 2D" && spline.name != "corner" && spline.name != "hairpin 1" &&
            spline.name != "hairpin 0.1" && spline.name != "hairpin 0.01") {
            continue;
        }
        Cells row{spline.name, ""};
        for (const bool single : {false, true}) {
            for (const SplineMethod method : {SplineMethod::kPropagated, SplineMethod::kNewton}) {
                progress(fmt::format("drift: {}", spline.name));
                const Drift found = drift(spline.cubic, method, single ? 5e-3 : 5e-5, single);
                row[1] = single ? row[1] : fmt::format("{}", found.steps);
                row.push_back(fmt::format("{:.2g} / {:+.1e}", found.position, found.phi));
            }
        }
        table.rows.push_back(row);
    }
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Splines by integration: errors, periods, orders, drift");
    std::string json_path;
    app.add_option("-o,--json", json_path, "write {tables: {NAME: {claim, header, rows}}}");
    CLI11_PARSE(app, argc, argv);

    std::vector<Table> tables;
    for (const auto make : {tick_table, period_table, order_table, vertex_table, drift_table}) {
        tables.push_back(make());
        progress("");
        fmt::print(stderr, "\r");
        print(tables.back());
    }
    return curvecore::tb::write_tables(tables, json_path);
}
