// SPDX-License-Identifier: Apache-2.0
#include "sysc/choose/chooser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sysc/cli/interrupt.hpp"
#include "sysc/core/core_clocks.hpp"

namespace curvecore::sysc {
namespace {

constexpr int kMostLookedAt = 40;  // valid configurations searched for runners-up

constexpr std::array<int CoreParameters::*, 4> kShrinkable{
    &CoreParameters::coef_bits, &CoreParameters::guard_bits, &CoreParameters::order,
    &CoreParameters::parameter_guard};

/// Returns true for a coarse subset of the widths, small enough to try all of it many times.
bool coarse(const CoreParameters& parameters) {
    const int order = parameters.order;
    return (order <= 4 || order % 2 == 0) &&
           (parameters.coef_bits % 4 == 0 || parameters.coef_bits <= 22) &&
           parameters.guard_bits % 3 == 0;
}

/// Returns true if a choice is worth its larger size: it needs a fifth less of the host or of the
/// clock.
bool better_somehow(const Choice& choice, const Choice& smaller) {
    constexpr double kWorthwhile = 0.8;
    return choice.demand.segments() < kWorthwhile * smaller.demand.segments() ||
           choice.need.least() < kWorthwhile * smaller.need.least();
}

}  // namespace

const char* reason_name(Reason reason) {
    switch (reason) {
        case Reason::kAccuracy:
            return "accuracy";
        case Reason::kDataRate:
            return "data rate";
        case Reason::kLatency:
            return "latency";
        case Reason::kClock:
            return "clock";
        case Reason::kArea:
            return "area";
        case Reason::kLeast:
            return "least there is";
        default:
            return "nothing";
    }
}

Chooser::Group Chooser::group(const Candidate& candidate) {
    CoreParameters p = candidate.parameters;
    p.coef_bits = p.guard_bits = 0;
    std::vector<int> values;
    for (const ref::Parameter& row : ref::kParameters) {
        if (row.samples) values.push_back(p.*row.value);
    }
    return {candidate.unit_mm, values};
}

double Chooser::fastest(const Candidate& candidate) const {
    return candidate.cost.mhz ? *candidate.cost.mhz * 1e6 : *requirement_.clock_hz;
}

/// Returns the largest load that a build can serve at this clock and the host can send.
Load Chooser::most_load(const Candidate& candidate, double clock_hz) const {
    int step = std::numeric_limits<int>::max();
    if (requirement_.arcs()) step = change_clocks(candidate.parameters, ref::CurveKind::kArc).step;
    if (requirement_.splines()) {
        step = std::min(step, change_clocks(candidate.parameters, ref::CurveKind::kSpline).step);
    }
    Load most;
    most.segments = requirement_.host_words / kSegmentWords;
    most.steps = clock_hz / step;
    return most;
}

/// Returns true if wider words already need more segments than the host can send. Narrower words
/// never need fewer.
bool Chooser::hopeless(const Candidate& candidate, const Load& most) {
    Candidate wider = candidate;
    wider.parameters.guard_bits = ref::parameter_of(&CoreParameters::guard_bits).high;
    const int most_coef_bits = ref::parameter_of(&CoreParameters::coef_bits).high;
    for (const int coef_bits : {most_coef_bits, candidate.parameters.coef_bits}) {
        wider.parameters.coef_bits = coef_bits;
        const Demand& least = demand(wider, most);
        if (!least.drawable() || least.segments() > most.segments) return true;
    }
    const CoreParameters& p = candidate.parameters;
    const std::vector<Known>& known = known_[group(candidate)];
    return std::any_of(known.begin(), known.end(), [&](const Known& one) {
        return one.coef_bits >= p.coef_bits && one.guard_bits >= p.guard_bits &&
               (!one.demand.drawable() || one.demand.segments() > most.segments);
    });
}

const Demand& Chooser::demand(const Candidate& candidate, const Load& most) {
    InterruptGuard::check();
    const CoreParameters& p = candidate.parameters;
    std::vector<Known>& known = known_[group(candidate)];
    for (Known& one : known) {
        if (one.coef_bits != p.coef_bits || one.guard_bits != p.guard_bits) continue;
        const bool complete =
            one.demand.arcs.within(one.most) && one.demand.splines.within(one.most);
        const bool enough = most.segments <= one.most.segments && most.steps <= one.most.steps;
        if (!complete && !enough) {
            one.most = most;
            one.demand = model_.demand(p, candidate.unit_mm, candidate.limit, most);
        }
        return one.demand;
    }
    known.push_back({p.coef_bits, p.guard_bits, most,
                     model_.demand(p, candidate.unit_mm, candidate.limit, most)});
    return known.back().demand;
}

Reason Chooser::judge(const Candidate& candidate, Choice& choice) {
    const std::optional<double> reached = candidate.cost.reached();
    choice.candidate = candidate;
    choice.clock_hz = requirement_.clock_hz ? *requirement_.clock_hz : *reached;
    if (!candidate.cost.fits(*requirement_.device)) return Reason::kArea;
    if (reached && choice.clock_hz > *reached) return Reason::kClock;
    Demand least;
    least.arcs.segments = least.arcs.steps = requirement_.arcs() ? 1 : 0;
    least.splines.segments = least.splines.steps = requirement_.splines() ? 1 : 0;
    choice.need = clock_need(candidate.parameters, least, requirement_.sample_period_s);
    if (choice.need.samples > choice.clock_hz) return Reason::kClock;
    if (choice.need.steps > choice.clock_hz) return Reason::kLatency;

    const Load most = most_load(candidate, choice.clock_hz);
    choice.demand = demand(candidate, most);
    if (!choice.demand.drawable()) return Reason::kAccuracy;
    if (choice.demand.segments() > most.segments) return Reason::kDataRate;
    choice.need = clock_need(candidate.parameters, choice.demand, requirement_.sample_period_s);
    if (choice.need.samples > choice.clock_hz) return Reason::kClock;
    return choice.need.steps > choice.clock_hz ? Reason::kLatency : Reason::kNone;
}

void Chooser::find_binds(Choice& choice) {
    for (const auto value : kShrinkable) {
        const ref::Parameter& row = ref::parameter_of(value);
        CoreParameters smaller = choice.candidate.parameters;
        if (--(smaller.*value) < row.low) {
            choice.binds.emplace_back(row.name, Reason::kLeast);
            continue;
        }
        std::optional<Candidate> other =
            make_candidate(requirement_, smaller, choice.candidate.unit_mm);
        other->cost = *cost_of(requirement_, *other);
        Choice unused;
        choice.binds.emplace_back(row.name, judge(*other, unused));
    }
}

std::vector<Choice> Chooser::smallest(std::size_t count) {
    std::vector<Choice> choices;
    std::optional<Choice> other;  // smallest choice of the other build
    int looked_at = 0;
    for (const Candidate& candidate : all_candidates(requirement_)) {
        const bool same_build = choices.empty() || candidate.parameters.build ==
                                                       choices.front().candidate.parameters.build;
        const bool enough = choices.size() >= count || looked_at > kMostLookedAt;
        if (same_build ? enough : other.has_value()) continue;
        Choice choice;
        if (hopeless(candidate, most_load(candidate, fastest(candidate))) ||
            judge(candidate, choice) != Reason::kNone) {
            continue;
        }
        if (!same_build) {
            other = choice;
            continue;
        }
        // A finer parameter lists the same core again.
        if (candidate.parameters.parameter_guard == 0) ++looked_at;
        if (std::all_of(choices.begin(), choices.end(),
                        [&](const Choice& smaller) { return better_somehow(choice, smaller); })) {
            choices.push_back(choice);
        }
    }
    if (other) choices.push_back(*other);
    for (Choice& choice : choices) find_binds(choice);
    return choices;
}

bool Chooser::possible() {
    std::vector<Candidate> candidates = all_candidates(requirement_);
    return std::any_of(candidates.rbegin(), candidates.rend(), [&](const Candidate& candidate) {
        Choice choice;
        return coarse(candidate.parameters) &&
               !hopeless(candidate, most_load(candidate, fastest(candidate))) &&
               judge(candidate, choice) == Reason::kNone;
    });
}

}  // namespace curvecore::sysc
