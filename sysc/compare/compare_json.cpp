// SPDX-License-Identifier: Apache-2.0
// compare.json: figures in length units, value ranges in the variables' own.
#include <cmath>
#include <filesystem>

#include "sysc/cli/html_page.hpp"
#include "sysc/compare/compare_report.hpp"
#include "sysc/compare/compare_template.hpp"
#include "sysc/curves/parameter_sets.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

Json figures_json(const ErrorFigures& figures) {
    return {{"worst", figures.worst}, {"rms", figures.rms}, {"p999", figures.most}};
}

Json position_json(const PositionFigures& figures, int axes) {
    Json json;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
        json[std::string(1, ref::kAxisNames[axis])] = figures_json(figures.axis[axis]);
    }
    json["along"] = figures_json(figures.along);
    json["across"] = figures_json(figures.across);
    return json;
}

Json optional_json(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// Value ranges by curve and row: the word's limits, and for each order the range met and the bits
/// to spare in its word; a negative number counts missing bits.
Json ranges_json(const ValueRanges& ranges) {
    Json json = Json::object();
    for (const RowRanges& row : ranges.rows()) {
        Json low = Json::array();
        Json high = Json::array();
        Json spare = Json::array();
        bool met = false;
        for (const ValueRange& range : row.orders) {
            const bool some = !range.empty();
            met = met || some;
            const auto real = [&](std::int64_t word) {
                const int bits = ranges.coef_bits() + row.fraction;
                return some ? Json(std::ldexp(static_cast<double>(word), -bits)) : Json(nullptr);
            };
            low.push_back(real(range.low));
            high.push_back(real(range.high));
            spare.push_back(some ? Json(ranges.coef_bits() - range.bits()) : Json(nullptr));
        }
        if (!met) continue;
        while (low.back().is_null()) {
            for (Json* list : {&low, &high, &spare}) list->get_ref<Json::array_t&>().pop_back();
        }
        json[row.curve][row.row] = {{"word", std::ldexp(1.0, -row.fraction - 1)},
                                    {"low", low},
                                    {"high", high},
                                    {"spare_bits", spare}};
    }
    return json;
}

Json estimate_json(const std::optional<CostEstimate>& cost, const Device& device) {
    if (!cost) return nullptr;
    return {{"lut4", std::round(cost->lut4)},
            {"ff", std::round(cost->ff)},
            {"dsp", cost->dsp},
            {"ram", cost->ram},
            {"mhz", cost->mhz ? Json(std::round(*cost->mhz)) : Json(nullptr)},
            {"of_device", cost->fullest(device)}};
}

Json row_json(const Row& row, int axes, const Device& device) {
    Json json = Json::object();
    const bool words = !row.ticks || row.ticks->words;
    const Scheme kernel = row.setting.anchor != 0 ? Scheme::kAnchored : Scheme::kPropagated;
    json["scheme"] = scheme_name(row.ticks ? row.ticks->scheme : kernel);
    json["arithmetic"] = words ? "words" : "double";
    json["tick_s"] = row.ticks ? Json(row.ticks->tick) : Json(nullptr);
    json["feed_mm_s"] = row.ticks ? Json(row.ticks->feed) : Json(nullptr);
    json["blow_ups"] = row.blow_ups;
    for (const double worst : row.by_move) {
        json["by_curve_mm"].push_back(std::isinf(worst) ? Json(nullptr) : Json(worst));
    }
    for (const ref::Parameter& one : ref::kParameters) {
        const bool used = !row.ticks || row.ticks->uses(one);
        json[one.field] = used ? Json(row.setting.*one.value) : Json(nullptr);
    }
    json.update({{"refused", row.refused.empty() ? Json(nullptr) : Json(row.refused)},
                 {"limit", row.drawn && !row.ticks ? Json(row.limit) : Json(nullptr)},
                 {"segments", row.segments},
                 {"steps", row.steps},
                 {"multiplier_bits", row.cost.bits},
                 {"sampler_products", row.cost.sampler_products},
                 {"integrators", row.cost.integrators},
                 {"estimate", estimate_json(row.estimate, device)}});
    if (!row.has_figures()) return json;
    json["output"] = position_json(row.output, axes);
    json["unrounded"] = position_json(row.fine, axes);
    json["speed_error"] = row.speed_error;
    json["speed_relative"] = optional_json(row.speed_relative);
    if (row.ticks) return json;
    json["landing"] = row.landing;
    json["bound"] = optional_json(row.bound);
    json["bound_of_seen"] = row.bound ? Json(*row.bound / row.fine.worst()) : Json(nullptr);
    json["max_of_bound"] = optional_json(row.of_bound);
    json["missing_bits"] = row.missing_bits;
    json["ranges"] = ranges_json(row.ranges);
    return json;
}

}  // namespace

std::string CompareReport::title() const {
    if (options.common.file.empty()) {
        return "built-in curves: " +
               std::string(kCurveSets[static_cast<std::size_t>(options.curves)]);
    }
    return std::filesystem::path(options.common.file).filename().string();
}

Json CompareReport::json() const {
    Json rows = Json::array();
    const Device& device = *options.sweep.device;
    for (const Row& row : result.rows) rows.push_back(row_json(row, axes(), device));
    Json columns = Json::array();
    for (const ref::Parameter* column : columns_of(options.settings)) {
        columns.push_back({{"field", column->field}, {"name", column->name}});
    }
    Json front = Json::array();
    for (const std::size_t index : pareto_front(result.rows)) front.push_back(index);
    Json curves = Json::array();
    for (std::size_t move = 0; !options.schemes.empty() && move < program.moves.size(); ++move) {
        curves.push_back(curve_name(move));
    }
    Json answered = Json::array();
    for (const Answer& answer : answers) {
        answered.push_back(
            {{"device", answer.device->name},
             {"keep", answer.keep},
             {"core", answer.take ? answer.core(options).json() : Json(nullptr)},
             {"estimate",
              answer.take ? estimate_json(answer.take->cost, *answer.device) : Json(nullptr)},
             {"text", answer.text(options, asked())}});
    }
    return {{"title", title()},
            {"curves", curves},
            {"version", CURVECORE_PROGRAM_VERSION},
            {"unit_mm", options.common.unit_mm},
            {"moves", program.moves.size()},
            {"samples", result.samples},
            {"limit", options.sweep.limit},
            {"reference_segments", result.reference_segments},
            {"most_segments", result.most_segments},
            {"asked", asked()},
            {"finished", result.rows.size()},
            {"interrupted", result.interrupted},
            {"held", held()},
            {"seconds", result.seconds},
            {"pareto", front},
            {"estimate",
             {{"device", device.name},
              {"lut", device.lut_name()},
              {"build", build_name(options.settings.front().build)},
              {"source", cost_model_source(device)}}},
            {"answers", answered},
            {"parameters", columns},
            {"rows", rows}};
}

std::string CompareReport::html() const { return html_page(kCompareTemplate, page_json(json())); }

}  // namespace curvecore::sysc
