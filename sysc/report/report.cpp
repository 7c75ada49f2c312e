// SPDX-License-Identifier: Apache-2.0
#include "sysc/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sysc/board/faults.hpp"
#include "sysc/cli/quantity.hpp"
#include "sysc/report/limit_text.hpp"
#include "sysc/report/step_text.hpp"

namespace curvecore::sysc {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
nlohmann::ordered_json per_axis(const Job& job, Value value) {
    nlohmann::ordered_json json;
    std::size_t axis = 0;
    for (const std::string& name : axis_names(job)) json[name] = value(axis++);
    return json;
}

nlohmann::ordered_json errors_json(const Job& job,
                                   const std::array<AxisError, ref::kMachineAxes>& errors,
                                   std::uint64_t samples) {
    nlohmann::ordered_json json;
    json["max_lsb"] = per_axis(job, [&](std::size_t axis) { return errors[axis].max; });
    json["rms_lsb"] = per_axis(job, [&](std::size_t axis) { return errors[axis].rms(samples); });
    return json;
}

nlohmann::ordered_json hold_json(const DrawnPlan& plan) {
    const double longest = static_cast<double>(plan.longest_stop) * plan.tick_s;
    return {{"branches", plan.branches},
            {"longest_stop_s", plan.branches == 0 ? Json() : Json(longest)},
            {"stop_ticks", plan.stop_ticks}};
}

/// Greatest number of events in a report, which is read as a whole.
constexpr std::size_t kMostEvents = 10000;

nlohmann::ordered_json events_json(const ref::Events& events) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const ref::Events::Event& event : events.list()) {
        if (list.size() == kMostEvents) break;
        list.push_back({{"line", event.line},
                        {"code", events.code_of(event)},
                        {"value", event.value},
                        {"path_mm", event.length}});
    }
    return list;
}

nlohmann::ordered_json machine_json(const Job& job) {
    nlohmann::ordered_json json;
    const ref::Machine& machine = job.machine;
    json["name"] = machine.name;
    json["velocity"] = machine.velocity;
    json["acceleration"] = machine.acceleration;
    json["jerk"] = machine.jerk;
    json["joint_time_s"] = machine.joint_time;
    std::size_t axis = 0;
    for (const std::string& name : axis_names(job)) {
        const ref::AxisLimits& limits = machine.axis[axis++];
        json["axes"][name] = {{"velocity", limits.velocity},
                              {"acceleration", limits.acceleration},
                              {"jerk", limits.jerk},
                              {"min", limits.min},
                              {"max", limits.max}};
    }
    json["notes"] = machine.notes;
    return json;
}

Json cost_json(const FormCost& cost) {
    return {{"moves", cost.moves},
            {"segments", cost.segments},
            {"words", cost.words},
            {"duration_s", cost.duration_s}};
}

std::string cost_text(const FormCost& cost) {
    return fmt::format("{} moves, {} segments, {} words, {}", cost.moves, cost.segments, cost.words,
                       time_text(cost.duration_s));
}

Json deviation_json(const Job& job) {
    const ref::Smoothed smoothed = job.smoothed.value_or(ref::Smoothed());
    return {{"max_mm", job.off.deviation}, {"share_of_P", job.off.share},
            {"line", job.off.line},        {"P_mm", smoothed.tolerance},
            {"corners", smoothed.corners}, {"curves", smoothed.curves},
            {"cubics", smoothed.cubics},   {"exact", job.exact ? cost_json(*job.exact) : Json()}};
}

std::string deviation_text(const ref::Smoothed& smoothed) {
    if (smoothed.tolerance == 0) return "as programmed";
    if (smoothed.deviation == 0) return "as programmed: nothing to smooth";
    return fmt::format(
        "{} moves within {:g} um: {} corners, {} curves of {} cubics; off by {:.3g} um at most "
        "({:.3f} of the tolerance, line {})",
        smoothed.moves, smoothed.tolerance * 1e3, smoothed.corners, smoothed.curves,
        smoothed.cubics, smoothed.deviation * 1e3, smoothed.share, smoothed.line);
}

nlohmann::ordered_json as_arcs_json(const Job& job) {
    const AsArcs& found = *job.as_arcs;
    nlohmann::ordered_json json = {{"tolerance_mm", nullptr},
                                   {"deviation_mm", found.replaced.deviation},
                                   {"splines", found.replaced.splines},
                                   {"pieces", found.replaced.moves}};
    if (job.options.arc_tolerance) json["tolerance_mm"] = *job.options.arc_tolerance;
    for (const FormCost& cost : found.costs) {
        json["forms"][cost.form] = cost_json(cost);
    }
    return json;
}

const char* title_of(BoardKind board) {
    constexpr std::array<const char*, 4> kTitles{"kernel board", "RTL", "SystemC system",
                                                 "SystemC system with RTL"};
    return kTitles[static_cast<std::size_t>(board)];
}

const char* unbounded_text(const Job& job) {
    return job.bounded() ? "" : "; none is derived for splines with Anchor=0";
}

template <std::size_t N>
double worst(const std::array<AxisError, N>& errors) {
    double max = 0;
    for (const AxisError& error : errors) max = std::max(max, error.max);
    return max;
}

}  // namespace

std::vector<std::string> axis_names(const Job& job) {
    std::vector<std::string> names;
    for (const char name : ref::kAxisNames.substr(0, 3 + std::size_t(job.plan.aux_axes))) {
        names.emplace_back(1, name);
    }
    return names;
}

std::string unit_text(const Job& job) {
    const double nm = job.plan.unit_mm * 1e6;
    return nm < 100 ? fmt::format("{:.4g} nm", nm) : fmt::format("{:.6g} um", nm / 1000);
}

std::string time_text(double seconds) {
    if (seconds < 60) return fmt::format("{:.3f} s", seconds);
    const auto whole = static_cast<long>(seconds);
    const std::string rest = fmt::format("{} min {} s", whole / 60 % 60, whole % 60);
    return whole < 3600 ? rest : fmt::format("{} h {}", whole / 3600, rest);
}

double Report::duration_s() const {
    return static_cast<double>(samples) * job.options.sample_period_s;
}

double Report::clocks_per_sample() const {
    return static_cast<double>(drawn->status.clocks) / static_cast<double>(samples);
}

double Report::clocks_available() const {
    return job.options.clock_hz * job.options.sample_period_s;
}

double Report::clocks_per_second() const {
    return static_cast<double>(drawn->status.clocks) / drawn->seconds;
}

std::vector<Check> Report::checks() const {
    std::vector<Check> checks;
    if (drawn != nullptr) {
        const CheckResult& check = drawn->check;
        const bool full_speed = job.options.override_percent >= 100;
        const std::uint64_t stops = job.plan.stops;
        const double of_bound = check.worst(&KindResult::of_bound);
        checks = {
            {fmt::format("{} equals kernel", title_of(job.options.board)),
             check.differing_words == 0,
             check.differing_words == 0
                 ? fmt::format("{} samples", check.samples)
                 : fmt::format("{} words differ; first: {}", check.differing_words,
                               check.first_difference)},
            {"error within the derived bound", of_bound <= 1,
             fmt::format("{:.3f} of the bound at worst{}", of_bound, unbounded_text(job))},
            {"exact stops landed", check.landing == 0 && (!full_speed || check.stops == stops),
             fmt::format("off by {} units, {} of {} stops sampled", check.landing, check.stops,
                         stops)},
            {"path increments even", check.increment <= 1,
             fmt::format("within {:.3f} quanta of the tick's share", check.increment)},
            {"speed true", check.speed_of_allowed <= 1,
             fmt::format("chords within {:.4f} units of the exact curve's",
                         check.worst(&KindResult::speed_error))},
            {"no underrun", !drawn->status.underrun,
             drawn->status.underrun ? "a queue ran low, time stopped" : "fed"},
            {"no fault", drawn->status.fault == 0, fault_text(drawn->status.fault)},
            {"no late sample", drawn->status.late_samples == 0,
             fmt::format("{} periods without their sample", drawn->status.late_samples)},
        };
        if (job.joints()) {
            checks.push_back(
                {"tool on its path", check.tool_of_bound <= 1, joints_text(job, check)});
        }
        if (const std::optional<StepStatus>& steps = drawn->status.steps) {
            checks.push_back({"every step given", every_step_given(*steps),
                              steps_text(*steps, axis_names(job))});
        }
    }
    checks.push_back({"path within its tolerance", job.off.share <= 1 + 1e-9,
                      fmt::format("off by {:.3g} um at most, {:.3f} of what is allowed{}",
                                  job.off.deviation * 1e3, job.off.share,
                                  job.off.line > 0 ? fmt::format(", line {}", job.off.line) : "")});
    checks.push_back({"time kept", !period_clocks || *period_clocks <= clocks_available(),
                      period_clocks ? fmt::format("{:.1f} of {:.1f} clocks of a sample period",
                                                  *period_clocks, clocks_available())
                                    : "not measured"});
    checks.push_back({"machine limits kept", limits.most() <= 1 + 1e-9, limits_text(job, limits)});
    if (drawn != nullptr) {
        const LimitLoads& rounded = drawn->check.rounded_limits;
        checks.push_back({"machine limits kept by the samples", rounded.most() <= 1 + 1e-9,
                          fmt::format("{}; rounding has up to {:.3f} of the allowance",
                                      limits_text(job, rounded), rounded.rounding())});
    }
    return checks;
}

bool Report::held() const {
    const std::vector<Check> all = checks();
    return std::all_of(all.begin(), all.end(), [](const Check& check) { return check.held; });
}

nlohmann::ordered_json Report::json() const {
    nlohmann::ordered_json json;
    json["input"] = job.options.file;
    json["unit_mm"] = job.plan.unit_mm;
    json["sample_period_s"] = job.options.sample_period_s;
    json["samples_per_tick"] = job.options.samples_per_tick;
    json["clock_hz"] = job.options.clock_hz;
    json["core"] = job.core_name();
    json["build"] = build_name(job.options.core.build);
    json["parameters"] = parameters_json(job.options.core);
    json["effort"] = ref::kEffortNames[static_cast<std::size_t>(job.options.effort)];
    json["moves"] = job.plan.moves.size();
    json["segments"] = job.plan.segments.size();
    json["profile_pieces"] = job.plan.pieces.size();
    json["words"] = job.words();
    json["hold"] = hold_json(job.plan);
    json["deviation"] = deviation_json(job);
    if (job.as_arcs) json["as_arcs"] = as_arcs_json(job);
    json["path_mm"] = job.path_mm();
    json["samples"] = samples;
    json["board"] = nullptr;
    if (drawn != nullptr) {
        const CheckResult& check = drawn->check;
        json["board"] = kBoardNames[static_cast<std::size_t>(job.options.board)];
        json["override_percent"] = job.options.override_percent;
        json["stall_seed"] = nullptr;
        if (job.options.stall_seed) json["stall_seed"] = *job.options.stall_seed;
        if (has_clock()) {
            json["clocks"] = drawn->status.clocks;
            json["clocks_per_sample"] = clocks_per_sample();
        }
        json["error"] = errors_json(job, check.rounded, check.samples);
        json["unrounded"] = errors_json(job, check.unrounded, check.samples);
        json["unrounded"]["bound_lsb"] = job.bound();
        json["unrounded"]["bounded"] = job.bounded();
        json["unrounded"]["max_of_bound"] = check.worst(&KindResult::of_bound);
        for (const auto& [name, kind] : check.kinds) {
            json["kinds"][name] = {{"samples", kind.samples},
                                   {"unrounded_max_lsb", kind.error},
                                   {"bound_lsb", kind.bound > 0 ? Json(kind.bound) : Json()},
                                   {"max_of_bound", kind.bound > 0 ? Json(kind.of_bound) : Json()},
                                   {"speed_max_error_lsb", kind.speed_error}};
        }
        json["landing_lsb"] = check.landing;
        json["stops"] = {{"planned", job.plan.stops}, {"sampled", check.stops}};
        json["path_increment"] = {{"max_error_quanta", check.increment}};
        json["speed"] = {{"max_relative_error", check.speed_relative},
                         {"max_error_lsb", check.worst(&KindResult::speed_error)}};
    } else {
        json["unrounded"] = {{"bound_lsb", job.bound()}, {"bounded", job.bounded()}};
    }
    json["time_kept"] = {{"clocks_available", clocks_available()}, {"clocks_used", nullptr}};
    if (period_clocks) json["time_kept"]["clocks_used"] = *period_clocks;
    json["limits"] = limits_json(job, limits);
    json["limits"]["planned"] = ratios_json(job.limits.inside);
    json["limits"]["planned"]["joints"] = {{"acceleration", job.limits.joints.acceleration},
                                           {"jerk", job.limits.joints.jerk},
                                           {"passed", job.limits.passed}};
    if (drawn != nullptr) {
        json["limits"]["samples"] = limits_json(job, drawn->check.rounded_limits);
        json["limits"]["samples"]["rounding_share"] = drawn->check.rounded_limits.rounding();
        if (drawn->check.tool) json["tool"] = tool_json(job, *drawn->check.tool);
        if (job.joints()) json["joints"] = joints_json(job, drawn->check);
        json["rtl_equals_kernel"] = drawn->check.differing_words;
        json["underruns"] = drawn->status.underrun ? 1 : 0;
        json["fault"] = drawn->status.fault;
        json["empty_segments"] = drawn->status.empty_segments;
        json["late_samples"] = drawn->status.late_samples;
        json["starved"] = drawn->status.starved;
        const std::optional<StepStatus>& steps = drawn->status.steps;
        json["pulses"] = steps ? steps_json(*steps, axis_names(job)) : Json();
    }
    json["duration_s"] = duration_s();
    if (drawn != nullptr) {
        if (has_clock()) json["simulation_clocks_per_second"] = clocks_per_second();
        json["simulation_samples_per_second"] = static_cast<double>(samples) / drawn->seconds;
    }
    for (const Check& check : checks()) {
        json["checks"].push_back(
            {{"name", check.name}, {"held", check.held}, {"detail", check.detail}});
    }
    json["machine"] = machine_json(job);
    if (job.dialect) json["dialect"] = ref::name_of(*job.dialect);
    json["warnings"] = job.program.warnings;
    json["events"] = events_json(job.events);
    json["event_count"] = job.events.list().size();
    return json;
}

std::vector<std::pair<std::string, std::string>> Report::table() const {
    std::vector<std::pair<std::string, std::string>> rows;
    const auto row = [&rows](std::string name, std::string value) {
        rows.emplace_back(std::move(name), std::move(value));
    };
    row("core", fmt::format("{} {}, {}", job.core_name(), build_name(job.options.core.build),
                            ref::parameters_text(job.options.core)));
    row("program", fmt::format("{} moves, {} segments, {} words, {:.3f} mm", job.plan.moves.size(),
                               job.plan.segments.size(), job.words(), job.path_mm()));
    if (job.dialect) {
        row("dialect", fmt::format("{}{}", ref::name_of(*job.dialect),
                                   job.options.gcode.dialect ? "" : ", recognised"));
    }
    row("path", job.smoothed ? deviation_text(*job.smoothed) : "as programmed (--path exact)");
    if (job.exact) row(job.exact->form, cost_text(*job.exact));
    if (!job.exact && job.is_smooth() && job.smoothed->moves > kMostBeside) {
        row("exact path", "not planned for a program of so many moves; --path exact plans it");
    }
    if (job.as_arcs) {
        const ref::Replaced& replaced = job.as_arcs->replaced;
        const std::optional<double> asked = job.options.arc_tolerance;
        row("splines",
            fmt::format("{} as {} arcs and lines, off by {:.3g} um at most ({})", replaced.splines,
                        replaced.moves, replaced.deviation * 1e3,
                        asked ? "asked: " + exact_length(*asked) : "the core draws no splines"));
        for (const FormCost& cost : job.as_arcs->costs) {
            row("as " + cost.form, cost_text(cost));
        }
    }
    row("duration", fmt::format("{}, {} samples of {:g} us", time_text(duration_s()), samples,
                                job.options.sample_period_s * 1e6));
    if (job.plan.branches > 0) {
        row("hold", fmt::format("at rest within {:.3f} s, {} branches",
                                static_cast<double>(job.plan.longest_stop) * job.plan.tick_s,
                                job.plan.branches));
    }
    if (drawn != nullptr) {
        const CheckResult& check = drawn->check;
        row(fmt::format("{} = kernel", title_of(job.options.board)),
            check.differing_words == 0 ? fmt::format("{} samples, 0 words differ", check.samples)
                                       : fmt::format("{} words differ", check.differing_words));
        row("worst error", fmt::format("{:.4f} units of {} (rounded output)", worst(check.rounded),
                                       unit_text(job)));
        row("before rounding",
            fmt::format("{:.4f} units; derived bound {:.4f}{}", worst(check.unrounded), job.bound(),
                        unbounded_text(job)));
        if (check.tool) row("tool", tool_text(job, *check.tool));
        if (job.joints()) row("tool's path", joints_text(job, check));
        row("landing", fmt::format("{} units at {} exact stops", check.landing, check.stops));
        if (has_clock()) row("clocks/sample", fmt::format("{:.3f}", clocks_per_sample()));
        if (const std::optional<StepStatus>& steps = drawn->status.steps) {
            row("steps", steps_text(*steps, axis_names(job)));
            row("following error", following_error_text(*steps, axis_names(job)));
            row("host", fmt::format("the queues starved {} times", drawn->status.starved));
        }
    } else {
        row("derived bound", fmt::format("{:.4f} units of {} before rounding{}", job.bound(),
                                         unit_text(job), unbounded_text(job)));
    }
    const auto worst = [&](Limited of) { return limits.worst[of].ratio; };
    row("of the limits",
        limits.resolved()
            ? fmt::format("velocity {:.3f}, acceleration {:.3f}, jerk {:.3f}; {} joints passed",
                          worst(kVelocity), worst(kAcceleration), worst(kJerk), job.limits.passed)
            : limits_text(job, limits));
    row("machine", job.machine.name);
    return rows;
}

}  // namespace curvecore::sysc
