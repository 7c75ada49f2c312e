// SPDX-License-Identifier: Apache-2.0
#include "sysc/curvecore/table_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hls/registers/board_facts.h"
#include "ref/curves/order_demand.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLeastFraction = -16;

void take_engine(TableCheck& check, const ref::CurveTable& table, const CoreParameters& core) {
    try {
        const assembler::Assembly assembly = assembler::curve_program(table, core);
        const auto clocks = [&](const char* part) {
            return assembler::worst_case(assembly, table.name + "_" + part, {"idle"});
        };
        check.engine = {assembly.placed().size() - 1, clocks("load"), clocks("step"),
                        clocks("sample"),
                        static_cast<int>(curvecore_table_number(table.text.c_str()))};
    } catch (const assembler::AssemblyError& error) {
        check.refused = error.what();
    }
}

void take_rows(TableCheck& check, const ref::CurveTable& table, const CoreParameters& core,
               const ref::TableError& bound) {
    const auto orders = ref::order_demand(table, core.order, core.polynomial());
    for (const auto& [name, row] : table.rows) {
        if (row.line == 0 || row.same_as) continue;  // no line makes tau, nor what has another name
        const auto order = orders.find(name);
        const auto largest = bound.largest.find(name);
        check.rows.push_back({name, row.of_axis, core.coef_bits + row.fraction, row.range(),
                              order == orders.end() ? 0 : order->second,
                              largest == bound.largest.end() ? 0 : largest->second});
    }
}

void take_beyond(TableCheck& check, const ref::CurveTable& table, const ref::TableError& bound) {
    for (const std::string& name : bound.beyond) {
        const int fraction = table.rows.at(name).fraction;
        const double needed = -2 - std::floor(std::log2(bound.largest.at(name)));
        check.beyond.push_back(
            {name, table.rows.at(name).line,
             needed < kLeastFraction
                 ? "no fraction holds it"
                 : fmt::format("it needs a fraction of {:+}, not {:+}, or a shorter step",
                               static_cast<int>(needed), fraction)});
    }
}

Json known(double value) { return value > 0 ? Json(value) : Json(nullptr); }

}  // namespace

TableCheck check_table(const ref::CurveTable& table, const CoreParameters& core,
                       const ref::TableSegment* segment) {
    TableCheck check;
    check.table = table.name;
    check.title = table.title;
    check.of_segment = segment != nullptr;
    check.steps = segment != nullptr ? segment->steps : 0;
    check.step_exponent = segment != nullptr ? segment->k : 0;
    const ref::TableError bound =
        segment != nullptr ? ref::table_error(table, core, *segment) : ref::TableError{};
    take_rows(check, table, core, bound);
    take_engine(check, table, core);
    take_beyond(check, table, bound);
    if (check.of_segment && check.beyond.empty()) check.error = bound.worst();
    return check;
}

bool TableCheck::held() const { return beyond.empty() && std::isfinite(error); }

std::string TableCheck::text() const {
    std::string text =
        fmt::format("{}: {}\n{:<16} {:>8} {:>10} {:>7}{}\n", table, title, "row", "bits", "range",
                    "orders", of_segment ? "    largest  spare bits" : "");
    for (const CheckedRow& row : rows) {
        text += fmt::format("{:<16} {:>8} {:>10} {:>7}", row.name + (row.of_axis ? "[k]" : ""),
                            row.bits, fmt::format("+-{:g}", row.range), row.orders);
        if (of_segment) {
            text += row.largest > 0 ? fmt::format(" {:>10.4g} {:>11.1f}", row.largest,
                                                  std::log2(row.range / row.largest))
                                    : fmt::format(" {:>10} {:>11}", "-", "-");
        }
        text += "\n";
    }
    if (!engine) return text + fmt::format("engine: does not draw it: {}\n", refused);
    return text + fmt::format(
                      "engine: {} instructions; {} clocks a segment, {} a step, {} a sample; "
                      "parameter Table={}\n",
                      engine->instructions, engine->segment_clocks, engine->step_clocks,
                      engine->sample_clocks, engine->table_number);
}

Json TableCheck::json() const {
    Json json{{"table", table}, {"title", title}, {"rows", Json::array()}};
    for (const CheckedRow& row : rows) {
        json["rows"].push_back(
            {{"name", row.name},
             {"of_axis", row.of_axis},
             {"bits", row.bits},
             {"range", row.range},
             {"orders", row.orders},
             {"largest", known(row.largest)},
             {"spare_bits",
              row.largest > 0 ? Json(std::log2(row.range / row.largest)) : Json(nullptr)}});
    }
    json["engine"] = nullptr;
    if (engine) {
        json["engine"] = {{"instructions", engine->instructions},
                          {"segment_clocks", engine->segment_clocks},
                          {"step_clocks", engine->step_clocks},
                          {"sample_clocks", engine->sample_clocks},
                          {"table_number", engine->table_number}};
    }
    json["engine_refuses"] = engine ? Json(nullptr) : Json(refused);
    json["segment"] = nullptr;
    if (!of_segment) return json;
    json["segment"] = {{"steps", steps},
                       {"step_exponent", step_exponent},
                       {"error_units", held() ? Json(error) : Json(nullptr)},
                       {"beyond", Json::array()}};
    for (const BeyondRow& row : beyond) {
        json["segment"]["beyond"].push_back(
            {{"row", row.row}, {"line", row.line}, {"reason", row.reason}});
    }
    return json;
}

}  // namespace curvecore::sysc
