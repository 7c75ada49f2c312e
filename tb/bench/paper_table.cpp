// SPDX-License-Identifier: Apache-2.0
// Prints the error of Taylor steps on the paper's circle by order and feed, and the least orders
// for a tolerance, and writes both as JSON.
#include "ref/series/paper_table.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

int main(int argc, char** argv) {
    using namespace curvecore::ref;
    CLI::App app("Error per tick and per circle, D = 50 mm, T = 10 ms, orders 1 to 14");
    std::string json_path;
    app.add_option("-o,--json", json_path,
                   "write {rows: [{order, feed_m_min, step_mm, circle_mm}], minimal_orders: "
                   "[{tolerance_mm, tick_ms, step, circle, circles}]}");
    CLI11_PARSE(app, argc, argv);

    const std::vector<PaperRow> rows = paper_table();
    fmt::print("error in mm, one tick | full circle\n P");
    for (const double feed : kPaperFeedsMetresPerMinute) {
        fmt::print("   {:>13} m/min", feed);
    }
    nlohmann::json json_rows = nlohmann::json::array();
    for (const PaperRow& row : rows) {
        if (row.feed_m_min == kPaperFeedsMetresPerMinute.front()) {
            fmt::print("\n{:2}", row.order);
        }
        fmt::print("   {:8.2e} | {:8.2e}", row.step_mm, row.circle_mm);
        json_rows.push_back({{"order", row.order},
                             {"feed_m_min", row.feed_m_min},
                             {"step_mm", row.step_mm},
                             {"circle_mm", row.circle_mm}});
    }
    fmt::print("\n\nleast order at {} m/min, one tick | full circle | {} circles\n", kOrdersFeed,
               kManyCircles);
    nlohmann::json json_orders = nlohmann::json::array();
    for (const OrderRow& row : minimal_orders()) {
        fmt::print("{:6g} mm {:4g} ms   {:2} | {:2} | {:2}\n", row.tolerance_mm, row.tick_ms,
                   row.step, row.circle, row.circles);
        json_orders.push_back({{"tolerance_mm", row.tolerance_mm},
                               {"tick_ms", row.tick_ms},
                               {"step", row.step},
                               {"circle", row.circle},
                               {"circles", row.circles}});
    }
    if (json_path.empty()) {
        return 0;
    }
    std::ofstream file(json_path);
    file << nlohmann::json{{"rows", json_rows}, {"minimal_orders", json_orders}}.dump(2) << "\n";
    file.close();
    if (!file) {
        fmt::print(stderr, "{}: error: cannot be written\n", json_path);
        return 1;
    }
    return 0;
}
