// SPDX-License-Identifier: Apache-2.0
#include "sysc/curvecore/curve_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hls/registers/board_facts.h"
#include "ref/curves/order_demand.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"

namespace curvecore::sysc {
namespace {

std::vector<CurveCheck::Row> rows_of(const ref::CurveTable& table, const CoreParameters& core,
                                     const std::optional<ref::TableError>& bound) {
    const auto orders = ref::order_demand(table, core.order, core.polynomial());
    std::vector<CurveCheck::Row> rows;
    for (const auto& [name, row] : table.rows) {
        if (row.line == 0 || row.same_as) continue;  // no line makes tau, nor what has another name
        const auto order = orders.find(name);
        CurveCheck::Row made{name + (row.of_axis ? "[k]" : ""),
                             core.coef_bits + row.fraction,
                             row.range(),
                             order == orders.end() ? 0 : order->second,
                             {}};
        if (bound) {
            const auto found = bound->largest.find(name);
            made.largest = found == bound->largest.end() ? 0 : found->second;
        }
        rows.push_back(std::move(made));
    }
    return rows;
}

void take_engine(const ref::CurveTable& table, const CoreParameters& core, CurveCheck& check) {
    try {
        const assembler::Assembly assembly = assembler::curve_program(table, core);
        const auto clocks = [&](const char* part) {
            return assembler::worst_case(assembly, table.name + "_" + part, {"idle"});
        };
        check.engine = CurveCheck::Engine{assembly.placed().size() - 1, clocks("load"),
                                          clocks("step"), clocks("sample")};
    } catch (const assembler::AssemblyError& error) {
        check.refusal = error.what();
        const std::string nowhere = ": error: ";  // of the programs together, not of a line
        if (check.refusal.rfind(nowhere, 0) == 0) check.refusal.erase(0, nowhere.size());
    }
}

}  // namespace

CurveCheck check_curve(const ref::CurveTable& table, const CoreParameters& core,
                       const std::optional<ref::TableSegment>& segment) {
    CurveCheck check;
    check.name = table.name;
    check.title = table.title;
    check.number = curvecore_table_number(table.text.c_str());
    if (segment) check.bound = ref::table_error(table, core, *segment);
    check.rows = rows_of(table, core, check.bound);
    take_engine(table, core, check);
    return check;
}

std::string CurveCheck::text() const {
    std::string text =
        fmt::format("{}: {}\n{:<16} {:>8} {:>10} {:>7}{}\n", name, title, "row", "bits", "range",
                    "orders", bound ? "    largest  spare bits" : "");
    for (const Row& row : rows) {
        text += fmt::format("{:<16} {:>8} {:>10} {:>7}", row.name, row.fraction_bits,
                            fmt::format("+-{:g}", row.range), row.orders);
        if (row.largest) {
            text += *row.largest > 0 ? fmt::format(" {:>10.4g} {:>11.1f}", *row.largest,
                                                   std::log2(row.range / *row.largest))
                                     : fmt::format(" {:>10} {:>11}", "-", "-");
        }
        text += "\n";
    }
    if (!engine) return text + fmt::format("engine: does not draw it: {}\n", refusal);
    return text + fmt::format(
                      "engine: {} instructions; {} clocks a segment, {} a step, {} a sample; "
                      "parameter Table={}\n",
                      engine->instructions, engine->load, engine->step, engine->sample, number);
}

nlohmann::ordered_json CurveCheck::json() const {
    nlohmann::ordered_json json{{"name", name}, {"title", title}, {"table", number}};
    json["rows"] = nlohmann::ordered_json::array();
    for (const Row& row : rows) {
        nlohmann::ordered_json one{{"name", row.name},
                                   {"fraction_bits", row.fraction_bits},
                                   {"range", row.range},
                                   {"orders", row.orders}};
        if (row.largest) one["largest"] = *row.largest;
        json["rows"].push_back(one);
    }
    if (engine) {
        json["engine"] = {{"instructions", engine->instructions},
                          {"segment_clocks", engine->load},
                          {"step_clocks", engine->step},
                          {"sample_clocks", engine->sample}};
    } else {
        json["engine"] = nullptr;
        json["engine_refusal"] = refusal;
    }
    if (bound) {
        json["beyond"] = bound->beyond;
        const bool bounded = bound->beyond.empty() && std::isfinite(bound->worst());
        json["bound_units"] = bounded ? nlohmann::ordered_json(bound->worst()) : nullptr;
    }
    return json;
}

}  // namespace curvecore::sysc
