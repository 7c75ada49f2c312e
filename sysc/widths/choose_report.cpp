// SPDX-License-Identifier: Apache-2.0
#include "tb/choose/choose_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace curvecore::tb {
namespace {

using Json = nlohmann::ordered_json;

/// "CoefBits: data rate, Order: latency"; what is at its least, or binds nothing, is left out.
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

/// Worst error of a position as the core gives it, mm.
double proven_error(const Choice& choice) {
    return (choice.demand.bound() + 0.5) * choice.candidate.unit_mm;
}

Json choice_json(const Choice& choice, const Device& device) {
    const Candidate& candidate = choice.candidate;
    const CostEstimate& cost = candidate.cost;
    Json parameters = candidate.parameters.json();
    parameters["MultiplierForm"] = device.form;
    return {{"core", core_name(candidate.core)},
            {"build", build_name(candidate.parameters.build)},
            {"parameters", parameters},
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
              {"fmax_mhz", cost.mhz},
              {"relative_error",
               {{"lut4", cost.lut4_error}, {"ff", cost.ff_error}, {"fmax_mhz", cost.mhz_error}}},
              {"size", candidate.size}}}};
}

Json confirmation_json(const Confirmation& measured) {
    return {{"lut4", measured.lut4}, {"ff", measured.ff},    {"fmax_mhz", measured.mhz},
            {"dsp", measured.dsp},   {"bram", measured.ram}, {"seeds", measured.seeds}};
}

std::string set_text(const CoreParameters& p) {
    std::string text = fmt::format(
        "--build {} --set Order={} --set CoefBits={} --set PositionBits={} --set GuardBits={} "
        "--set Mode={}",
        build_name(p.build), p.order, p.coef_bits, p.position_bits, p.guard_bits, p.mode);
    if (p.build == Build::kParallel) {
        text += fmt::format(" --set SampleInterval={}", p.sample_interval);
        if (p.turn_bits > 0) text += fmt::format(" --set TurnBits={}", p.turn_bits);
        if (p.parameter_guard > 0) {
            text += fmt::format(" --set ParameterGuard={}", p.parameter_guard);
        }
    }
    return text;
}

std::string wish_text(const Wish& wish) {
    std::string curves;
    if (wish.arcs()) {
        curves = fmt::format("arcs of {} to {}, lines", length_text(wish.least_radius_mm),
                             length_text(wish.radius_mm));
    }
    if (wish.splines()) {
        curves += fmt::format("{}splines of up to {}", curves.empty() ? "" : ", ",
                              length_text(wish.length_mm));
    }
    return fmt::format("error {} on any axis, {}, {}, {} samples, {}{}", length_text(wish.error_mm),
                       curves, feed_text(wish.feed), frequency_text(1 / wish.sample_period_s),
                       wish.device->name,
                       wish.clock_hz ? " at " + frequency_text(*wish.clock_hz) : "");
}

void add_row(std::string& text, const Choice& choice) {
    const CoreParameters& p = choice.candidate.parameters;
    const CostEstimate& cost = choice.candidate.cost;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{:10} {:8} {:>5} {:>4} {:>5} {:>3} {:>4} {:>6} {:>4} {:>4} {:>8}",
                   core_name(choice.candidate.core), build_name(p.build), p.order, p.coef_bits,
                   p.guard_bits, p.position_bits, p.mode,
                   p.build == Build::kParallel ? std::to_string(p.sample_interval) : "",
                   p.build == Build::kParallel ? std::to_string(p.turn_bits) : "",
                   p.build == Build::kParallel ? std::to_string(p.parameter_guard) : "",
                   unit_text(choice.candidate.unit_mm));
    fmt::format_to(out, " {:>9} {:>8.0f} {:>9.3g} | {:>6.0f} {:>6.0f} {:>4} {:>4} {:>5.0f}  {}\n",
                   length_text(proven_error(choice)), choice.demand.segments() * kSegmentWords,
                   choice.need.least() / 1e6, cost.lut4, cost.ff, cost.dsp, cost.ram, cost.mhz,
                   binds_text(choice));
}

}  // namespace

std::string ChooseReport::text() const {
    std::string text = wish_text(wish) + "\n\n";
    const auto out = std::back_inserter(text);
    if (choices.empty()) {
        fmt::format_to(out, "no core keeps this in {}. Give up one of\n", wish.device->name);
        for (const Concession& one : concessions) fmt::format_to(out, "    {}\n", one.text);
        if (concessions.empty()) text += "    no wish alone helps: two must be given up\n";
        return text;
    }
    fmt::format_to(out, "{:89} | {}\n", "", "estimate");
    fmt::format_to(out,
                   "{:10} {:8} {:>5} {:>4} {:>5} {:>3} {:>4} {:>6} {:>4} {:>4} {:>8} {:>9} {:>8} "
                   "{:>9} | {:>6} {:>6} {:>4} {:>4} {:>5}  {}\n",
                   "core", "build", "order", "coef", "guard", "pos", "mode", "clk/sa", "turn",
                   "par", "unit", "error <=", "words/s", "needs MHz", "LUT4", "FF", "DSP", "RAM",
                   "MHz", "a bit less is ruled out by");
    for (const Choice& choice : choices) add_row(text, choice);
    const Choice& winner = choices.front();
    const CostEstimate& cost = winner.candidate.cost;
    fmt::format_to(out,
                   "\nThe first is the smallest. Its error is a derived bound, for every such "
                   "curve, of segments\nplanned with --limit {:.4g} --unit {} {}\n",
                   winner.candidate.limit, unit_text(winner.candidate.unit_mm),
                   set_text(winner.candidate.parameters));
    fmt::format_to(out,
                   "Estimates are off by {:.0f} % (LUT4), {:.0f} % (FF), {:.0f} % (MHz), root mean "
                   "square; {}.\nDSP and RAM blocks are exact.\n",
                   100 * cost.lut4_error, 100 * cost.ff_error, 100 * cost.mhz_error,
                   cost_model_source());
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
            off(confirmation->mhz, cost.mhz), confirmation->seeds,
            std::max(wish.clock_hz.value_or(0), winner.need.least()) / 1e6);
    }
    return text;
}

Json ChooseReport::json() const {
    Json json{{"version", CURVECORE_VERSION},
              {"wish",
               {{"error_mm", wish.error_mm},
                {"unit_mm", wish.unit_mm ? Json(*wish.unit_mm) : Json(nullptr)},
                {"radius_mm", wish.radius_mm},
                {"least_radius_mm", wish.least_radius_mm},
                {"length_mm", wish.length_mm},
                {"feed_mm_s", wish.feed},
                {"travel_mm", wish.travel_mm},
                {"sample_period_s", wish.sample_period_s},
                {"clock_hz", wish.clock_hz ? Json(*wish.clock_hz) : Json(nullptr)},
                {"host_words_per_s", wish.host_words},
                {"device", wish.device->name}}},
              {"possible", !choices.empty()},
              {"cost_model", cost_model_source()},
              {"seconds", seconds}};
    if (choices.empty()) {
        json["give_up"] = Json::array();
        for (const Concession& one : concessions) {
            json["give_up"].push_back({{"wish", one.name},
                                       {"asked", one.asked},
                                       {"possible", one.possible},
                                       {"text", one.text}});
        }
        return json;
    }
    json["choice"] = choice_json(choices.front(), *wish.device);
    json["runners_up"] = Json::array();
    for (std::size_t i = 1; i < choices.size(); ++i) {
        json["runners_up"].push_back(choice_json(choices[i], *wish.device));
    }
    if (confirmation) json["confirmed"] = confirmation_json(*confirmation);
    return json;
}

}  // namespace curvecore::tb
