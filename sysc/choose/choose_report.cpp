// SPDX-License-Identifier: Apache-2.0
#include "sysc/choose/choose_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

#include "sysc/cli/quantity.hpp"
#include "sysc/curves/parameter_sets.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

/// Text such as "CoefBits: data rate, Order: latency"; parameters that are at their least, or that
/// nothing binds, are left out.
std::string binds_text(const Choice& choice) {
    std::string text;
    for (const auto& [name, reason] : choice.binds) {
        if (reason == Reason::kNone || reason == Reason::kLeast) continue;
        text += fmt::format("{}{} by {}", text.empty() ? "" : ", ", name, reason_name(reason));
    }
    const bool least = std::all_of(choice.binds.begin(), choice.binds.end(),
                                   [](const auto& bind) { return bind.second == Reason::kLeast; });
    if (text.empty() && least) return "- (the least words there are)";
    return text.empty() ? "- (for fewer words or a slower clock)" : text;
}

Json binds_json(const Choice& choice) {
    Json json = Json::object();
    for (const auto& [name, reason] : choice.binds) json[name] = reason_name(reason);
    return json;
}

/// Worst error of a position as the core returns it, mm.
double proven_error(const Choice& choice) {
    const Candidate& candidate = choice.candidate;
    return (choice.demand.bound() + candidate.parameters.rounding()) * candidate.unit_mm;
}

Json optional_json(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json choice_json(const Choice& choice) {
    const Candidate& candidate = choice.candidate;
    const CostEstimate& cost = candidate.cost;
    return {{"core", core_name(candidate.core)},
            {"build", build_name(candidate.parameters.build)},
            {"parameters", parameters_json(candidate.parameters)},
            {"unit_mm", candidate.unit_mm},
            {"limit_lsb", candidate.limit},
            {"bound_lsb", choice.demand.bound()},
            {"error_mm", proven_error(choice)},
            {"segments_per_s", choice.demand.segments()},
            {"host_words_per_s", choice.demand.segments() * kSegmentWords},
            {"steps_per_s", std::max(choice.demand.arcs.steps, choice.demand.splines.steps)},
            {"clock_needed_hz", choice.need.least()},
            {"clock_available_hz", choice.clock_hz},
            {"binds", binds_json(choice)},
            {"estimate",
             {{"lut4", std::round(cost.lut4)},
              {"ff", std::round(cost.ff)},
              {"dsp", cost.dsp},
              {"bram", cost.ram},
              {"fmax_mhz", optional_json(cost.mhz)},
              {"relative_error",
               {{"lut4", cost.lut4_error},
                {"ff", cost.ff_error},
                {"fmax_mhz", cost.mhz ? Json(cost.mhz_error) : Json(nullptr)}}},
              {"size", candidate.size}}}};
}

Json confirmation_json(const Confirmation& measured) {
    return {{"lut4", measured.lut4}, {"ff", measured.ff},    {"fmax_mhz", measured.mhz},
            {"dsp", measured.dsp},   {"bram", measured.ram}, {"seeds", measured.seeds}};
}

std::string requirement_text(const Requirement& requirement) {
    std::string curves;
    if (requirement.arcs()) {
        curves = fmt::format("arcs of {} to {}, lines", length_text(requirement.least_radius_mm),
                             length_text(requirement.radius_mm));
    }
    if (requirement.splines()) {
        curves += fmt::format("{}splines of up to {}", curves.empty() ? "" : ", ",
                              length_text(requirement.length_mm));
    }
    return fmt::format(
        "error {} on any axis, {}, {}, {} samples, {}{}", length_text(requirement.error_mm), curves,
        feed_text(requirement.feed), frequency_text(1 / requirement.sample_period_s),
        (requirement.whole_board ? "a board with " : "") + std::string(requirement.device->name),
        requirement.clock_hz ? " at " + frequency_text(*requirement.clock_hz) : "");
}

using Columns = std::vector<const ref::Parameter*>;

Columns columns_of(const std::vector<Choice>& choices) {
    std::vector<CoreParameters> all;
    all.reserve(choices.size());
    for (const Choice& choice : choices) all.push_back(choice.candidate.parameters);
    return sysc::columns_of(all);
}

void add_row(std::string& text, const Choice& choice, const Columns& columns) {
    const CoreParameters& p = choice.candidate.parameters;
    const CostEstimate& cost = choice.candidate.cost;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{:10} {:8}", core_name(choice.candidate.core), build_name(p.build));
    for (const ref::Parameter* one : columns) {
        fmt::format_to(out, " {:>{}}", p.*one->value, std::strlen(one->name));
    }
    fmt::format_to(
        out, " {:>8} {:>9} {:>8.0f} {:>9.3g} | {:>6.0f} {:>6.0f} {:>4} {:>4} {:>5}  {}\n",
        exact_length(choice.candidate.unit_mm), length_text(proven_error(choice)),
        choice.demand.segments() * kSegmentWords, choice.need.least() / 1e6, cost.lut4, cost.ff,
        cost.dsp, cost.ram, cost.mhz ? fmt::format("{:.0f}", *cost.mhz) : "-", binds_text(choice));
}

}  // namespace

std::string ChooseReport::text() const {
    std::string text = requirement_text(requirement) + "\n\n";
    const auto out = std::back_inserter(text);
    if (choices.empty()) {
        fmt::format_to(out, "no core keeps this in {}. Give up one of\n", requirement.device->name);
        for (const Relaxation& one : relaxations) fmt::format_to(out, "    {}\n", one.text);
        if (relaxations.empty()) text += "    no requirement alone helps: two must be given up\n";
        return text;
    }
    const Columns columns = columns_of(choices);
    std::string head = fmt::format("{:10} {:8}", "core", "build");
    for (const ref::Parameter* one : columns) head += std::string(" ") + one->name;
    head += fmt::format(" {:>8} {:>9} {:>8} {:>9}", "unit", "error <=", "words/s", "needs MHz");
    fmt::format_to(out, "{:{}} | estimate\n", "", head.size());
    fmt::format_to(out, "{} | {:>6} {:>6} {:>4} {:>4} {:>5}  {}\n", head,
                   requirement.device->lut_name(), "FF", "DSP", "RAM", "MHz",
                   "a bit less is ruled out by");
    for (const Choice& choice : choices) add_row(text, choice, columns);
    const Choice& winner = choices.front();
    const CostEstimate& cost = winner.candidate.cost;
    fmt::format_to(
        out,
        "\nThe first is the smallest. Its error is a derived bound, for every such "
        "curve, of segments planned\nwith --core core.json, which choose -o DIR writes.\n");
    if (winner.candidate.parameters.build == Build::kEngine) {
        text +=
            "The engine is the same with all of these widths: it took that on a placed board.\n";
    } else {
        fmt::format_to(
            out, "Estimates are off by {:.0f} % ({}), {:.0f} % (FF){}, root mean square; {}.\n",
            100 * cost.lut4_error, requirement.device->lut_name(), 100 * cost.ff_error,
            cost.mhz ? fmt::format(", {:.0f} % (MHz)", 100 * cost.mhz_error) : "",
            cost_model_source(*requirement.device));
        if (!cost.mhz) text += "Whether the device reaches the clock is not known.\n";
        fmt::format_to(out, "{}\n",
                       requirement.whole_board
                           ? "That is of the core; the rest of the board is as another one was "
                             "placed, with queues of 1,024\nwords."
                           : "DSP and RAM blocks are exact.");
    }
    if (confirmation) {
        const auto off = [](double measured, double planned) {
            return 100 * (measured / planned - 1);
        };
        fmt::format_to(
            out,
            "\nplaced and routed: {:.0f} LUT4 ({:+.1f} %), {:.0f} FF ({:+.1f} %), {} DSP "
            "({:+}), {} RAM ({:+}), {:.1f} MHz ({:+.1f} %), best of {}; needed {:.3g} "
            "MHz\n",
            confirmation->lut4, off(confirmation->lut4, cost.lut4), confirmation->ff,
            off(confirmation->ff, cost.ff), confirmation->dsp, confirmation->dsp - cost.dsp,
            confirmation->ram, confirmation->ram - cost.ram, confirmation->mhz,
            off(confirmation->mhz, *cost.mhz), confirmation->seeds,
            std::max(requirement.clock_hz.value_or(0), winner.need.least()) / 1e6);
    }
    return text;
}

CoreFile ChooseReport::core() const {
    const Choice& winner = choices.front();
    const Candidate& candidate = winner.candidate;
    return {core_name(candidate.core),
            candidate.parameters,
            std::string(requirement.device->name),
            candidate.unit_mm,
            requirement.error_mm,
            requirement.sample_period_s,
            winner.clock_hz};
}

Json ChooseReport::json() const {
    Json json{{"version", CURVECORE_PROGRAM_VERSION},
              {"requirement",
               {{"error_mm", requirement.error_mm},
                {"unit_mm", optional_json(requirement.unit_mm)},
                {"radius_mm", requirement.radius_mm},
                {"least_radius_mm", requirement.least_radius_mm},
                {"length_mm", requirement.length_mm},
                {"feed_mm_s", requirement.feed},
                {"travel_mm", requirement.travel_mm},
                {"sample_period_s", requirement.sample_period_s},
                {"clock_hz", optional_json(requirement.clock_hz)},
                {"host_words_per_s", requirement.host_words},
                {"device", requirement.device->name},
                {"whole_board", requirement.whole_board}}},
              {"possible", !choices.empty()},
              {"cost_model", cost_model_source(*requirement.device)},
              {"seconds", seconds}};
    if (choices.empty()) {
        json["give_up"] = Json::array();
        for (const Relaxation& one : relaxations) {
            json["give_up"].push_back({{"requirement", one.name},
                                       {"asked", one.asked},
                                       {"possible", one.possible},
                                       {"text", one.text}});
        }
        return json;
    }
    json["choice"] = choice_json(choices.front());
    json["runners_up"] = Json::array();
    for (std::size_t i = 1; i < choices.size(); ++i) {
        json["runners_up"].push_back(choice_json(choices[i]));
    }
    if (confirmation) json["confirmed"] = confirmation_json(*confirmation);
    return json;
}

}  // namespace curvecore::sysc
