// SPDX-License-Identifier: Apache-2.0
// Text forms of a comparison: compare.csv, and the table on the terminal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

#include "sysc/compare/compare_report.hpp"
#include "sysc/curves/parameter_sets.hpp"

namespace curvecore::sysc {
namespace {

std::string number(const std::optional<double>& value) {
    return value ? fmt::format("{:.6g}", *value) : "";
}

/// A field of a .csv file without quotes, which not every reader knows.
std::string field(std::string text) {
    std::replace(text.begin(), text.end(), ',', ';');
    text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
    return text;
}

std::string note(const Row& row, const SweepOptions& options) {
    if (!row.drawn) return "not drawable";
    std::string text;
    if (row.ticks) {
        return row.blow_ups == 0
                   ? text
                   : fmt::format("{} of {} curves blow up", row.blow_ups, row.by_move.size());
    }
    const Device& device = *options.device;
    if (row.estimate && !row.estimate->fits(device)) {
        text = fmt::format("too large for {}; ", device.name);
    }
    if (row.missing_bits > 0) text += fmt::format("{} bits missing; ", row.missing_bits);
    if (row.landing != 0) text += fmt::format("lands {} off; ", row.landing);
    if (row.of_bound.value_or(0) > 1) text += "BEYOND ITS BOUND; ";
    if (row.limit != options.limit) text += fmt::format("planned for {:g}", row.limit);
    return text;
}

/// Name such as "paper, double".
std::string name_of(const Row& row) {
    if (!row.ticks)
        return scheme_name(row.setting.anchor != 0 ? Scheme::kAnchored : Scheme::kPropagated);
    const bool both = row.ticks->scheme == Scheme::kPaper && !row.ticks->words;
    return scheme_name(row.ticks->scheme) + (both ? ", double" : "");
}

std::string tick_text(const TickScheme& ticks) { return fmt::format("{:g} ms", ticks.tick * 1e3); }
std::string feed_text(const TickScheme& ticks) {
    return fmt::format("{:.4g} m/min", ticks.feed * 60e-3);
}

std::string mhz_text(const CostEstimate& cost, const char* unknown) {
    return cost.mhz ? fmt::format("{:.0f}", *cost.mhz) : unknown;
}

/// Value of a parameter of a row; empty where the scheme has no such parameter.
std::string value_of(const Row& row, const ref::Parameter& one) {
    const bool used = !row.ticks || row.ticks->uses(one);
    return used ? fmt::format("{}", row.setting.*one.value) : "";
}

}  // namespace

std::size_t CompareReport::asked() const {
    return options.drawn.size() + options.sweep.ticked.size();
}

bool CompareReport::held() const {
    return std::all_of(result.rows.begin(), result.rows.end(),
                       [](const Row& row) { return row.held(); });
}

ErrorFigures worst_axis(const PositionFigures& figures) {
    ErrorFigures worst;
    for (const ErrorFigures& axis : figures.axis) {
        worst.worst = std::max(worst.worst, axis.worst);
        worst.rms = std::max(worst.rms, axis.rms);
        worst.most = std::max(worst.most, axis.most);
    }
    return worst;
}

std::vector<std::size_t> pareto_front(const std::vector<Row>& rows) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].drawn && !rows[i].ticks && rows[i].missing_bits == 0) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rows[a].cost.bits != rows[b].cost.bits
                   ? rows[a].cost.bits < rows[b].cost.bits
                   : rows[a].output.worst() < rows[b].output.worst();
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || rows[i].output.worst() < rows[front.back()].output.worst()) {
            front.push_back(i);
        }
    }
    return front;
}

std::string CompareReport::csv() const {
    std::string text;
    for (const ref::Parameter& one : ref::kParameters) text += one.field + std::string(",");
    text += "limit,segments,steps";
    const auto columns = [&](const std::string& name) {
        text += fmt::format(",{0}_worst,{0}_rms,{0}_p999", name);
    };
    for (const std::string kind : {"output", "unrounded"}) {
        for (int axis = 0; axis < axes(); ++axis) columns(kind + "_" + ref::kAxisNames[axis]);
        columns(kind + "_along");
        columns(kind + "_across");
    }
    text +=
        ",landing,speed_error,speed_relative,bound,max_of_bound,missing_bits,multiplier_bits,"
        "estimated_lut4,dsp,ram,estimated_mhz,refused,scheme,tick_s,feed_mm_s,blow_ups,unit_mm\n";
    for (const Row& row : result.rows) {
        const auto out = std::back_inserter(text);
        for (const ref::Parameter& one : ref::kParameters) {
            fmt::format_to(out, "{},", value_of(row, one));
        }
        fmt::format_to(out, "{},{},{}",
                       row.drawn && !row.ticks ? fmt::format("{:g}", row.limit) : "", row.segments,
                       row.steps);
        const auto figures = [&](const ErrorFigures& f) {
            if (!row.has_figures()) {
                text += ",,,";
                return;
            }
            fmt::format_to(out, ",{:.6g},{:.6g},{:.6g}", f.worst, f.rms, f.most);
        };
        for (const PositionFigures* position : {&row.output, &row.fine}) {
            for (int axis = 0; axis < axes(); ++axis) {
                figures(position->axis[static_cast<std::size_t>(axis)]);
            }
            figures(position->along);
            figures(position->across);
        }
        const auto of_core = [&](auto value) { return row.ticks ? "" : fmt::format("{}", value); };
        fmt::format_to(out, ",{},{},{},{},{},{},{},", of_core(row.landing),
                       row.has_figures() ? fmt::format("{:.6g}", row.speed_error) : "",
                       row.has_figures() ? number(row.speed_relative) : "", number(row.bound),
                       number(row.of_bound), of_core(row.missing_bits), of_core(row.cost.bits));
        if (row.estimate) {
            fmt::format_to(out, "{:.0f},{},{},{},", row.estimate->lut4, row.estimate->dsp,
                           row.estimate->ram, mhz_text(*row.estimate, ""));
        } else {
            text += ",,,,";
        }
        text += field(row.refused) + "," + field(name_of(row)) + ",";
        if (row.ticks) {
            fmt::format_to(std::back_inserter(text), "{:.9g},{:.9g},{}", row.ticks->tick,
                           row.ticks->feed, row.blow_ups);
        } else {
            text += ",,";
        }
        fmt::format_to(std::back_inserter(text), ",{:g}\n", options.common.unit_mm);
    }
    return text;
}

std::string CompareReport::table() const {
    const std::vector<const ref::Parameter*> columns = columns_of(options.settings);
    std::string text;
    if (!options.schemes.empty())
        text += fmt::format("{:<13} {:>8} {:>11} ", "scheme", "tick", "feed");
    for (const ref::Parameter* one : columns) text += std::string(one->name) + ' ';
    text += fmt::format(
        "{:>8} {:>8} {:>8} {:>9} {:>8} {:>8} {:>8} {:>6} {:>8} {:>8} {:>7} {:>8} {:>6} {:>4} "
        "{:>4}\n",
        "worst", "rms", "99.9 %", "unrounded", "along", "across", "bound", "/ seen", "speed",
        "segments", "steps", "mul bits", fmt::format("~{}", options.sweep.device->lut_name()),
        "DSP", "~MHz");
    for (const Row& row : result.rows) {
        const auto out = std::back_inserter(text);
        if (!options.schemes.empty()) {
            fmt::format_to(out, "{:<13} {:>8} {:>11} ", name_of(row),
                           row.ticks ? tick_text(*row.ticks) : "",
                           row.ticks ? feed_text(*row.ticks) : "");
        }
        for (const ref::Parameter* one : columns) {
            fmt::format_to(out, "{:>{}} ", value_of(row, *one), std::strlen(one->name));
        }
        if (row.blow_ups > 0) {
            fmt::format_to(out, "{:>8}{:71}", "blow-up", "");
        } else if (row.drawn) {
            const ErrorFigures worst = worst_axis(row.output);
            const auto three = [](double value) { return fmt::format("{:.3g}", value); };
            fmt::format_to(out, "{:>8} {:>8} {:>8} {:>9} {:>8} {:>8} {:>8} {:>6} {:>8}",
                           three(worst.worst), three(worst.rms), three(worst.most),
                           three(row.fine.worst()), three(row.fine.along.worst),
                           three(row.fine.across.worst), row.bound ? three(*row.bound) : "none",
                           row.bound ? fmt::format("{:.1f}", *row.bound / row.fine.worst()) : "",
                           three(row.speed_error));
        } else {
            fmt::format_to(out, "{:79}", "");
        }
        fmt::format_to(out, " {:>8} {:>7} {:>8}", row.segments, row.steps,
                       row.ticks ? "" : fmt::format("{}", row.cost.bits));
        if (row.estimate) {
            fmt::format_to(out, " {:>6.0f} {:>4} {:>4}", row.estimate->lut4, row.estimate->dsp,
                           mhz_text(*row.estimate, "-"));
        } else {
            fmt::format_to(out, "{:17}", "");
        }
        text += "  " + note(row, options.sweep);
        while (text.back() == ' ') text.pop_back();
        text += '\n';
    }
    if (options.drawn.empty()) return text;
    const Build build = options.settings.front().build;
    const Device& device = *options.sweep.device;
    if (!cost_is_known(build, device)) {
        return text + fmt::format("no estimates: no measured runs of the {} build for {} yet\n",
                                  build_name(build), device.name);
    }
    return text + fmt::format("~ estimated, {} build on {}: {}\n", build_name(build), device.name,
                              cost_model_source(device));
}

std::string CompareReport::answer_text() const {
    if (!options.schemes.empty()) return "";
    std::string text;
    for (const Answer& answer : answers) text += answer.text(options, asked());
    return text;
}

std::string CompareReport::curves_table() const {
    constexpr std::size_t kMostCurves = 30;
    constexpr std::size_t kMostRows = 12;
    if (options.schemes.empty()) return "";
    std::string text = "\nworst distance from the exact place by curve, mm:\n";
    const auto out = std::back_inserter(text);
    const std::size_t rows = std::min(result.rows.size(), kMostRows);
    const std::size_t curves = std::min(program.moves.size(), kMostCurves);
    fmt::format_to(out, "{:<14}", "");
    for (std::size_t i = 0; i < rows; ++i) fmt::format_to(out, " {:>13}", name_of(result.rows[i]));
    fmt::format_to(out, "\n{:<14}", "");
    for (std::size_t i = 0; i < rows; ++i) {
        const auto& ticks = result.rows[i].ticks;
        fmt::format_to(out, " {:>13}", ticks ? feed_text(*ticks) : "");
    }
    for (std::size_t move = 0; move < curves; ++move) {
        fmt::format_to(out, "\n{:<14}", curve_name(move));
        for (std::size_t i = 0; i < rows; ++i) {
            const Row& row = result.rows[i];
            const bool some = move < row.by_move.size();
            fmt::format_to(out, " {:>13}",
                           !some ? ""
                           : std::isinf(row.by_move[move])
                               ? "blow-up"
                               : fmt::format("{:.2g}", row.by_move[move]));
        }
    }
    text += '\n';
    if (rows < result.rows.size() || curves < program.moves.size()) {
        text += "the rest is in compare.json\n";
    }
    return text;
}

std::string CompareReport::curve_name(std::size_t move) const {
    if (options.curves == CurveSet::kPapers) return paper_curve_name(move);
    return fmt::format("line {}", program.moves[move].line);
}

}  // namespace curvecore::sysc
