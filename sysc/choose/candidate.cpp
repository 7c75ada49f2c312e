// SPDX-License-Identifier: Apache-2.0
#include "sysc/choose/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sysc/cost/board_cost.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kLeastLimit = 1e-3;  // units: below it no segment can be planned

/// Values of one parameter that choose tries, all of the table's or fewer; a later parameter varies
/// faster.
struct Tried {
    int CoreParameters::*value;
    std::vector<int> values;
};

Tried every(int CoreParameters::*value) {
    const ref::Parameter& row = ref::parameter_of(value);
    Tried tried{value, {}};
    for (int number = row.low; number <= row.high; ++number) {
        if (row.holds(number)) tried.values.push_back(number);
    }
    return tried;
}

const std::vector<Tried>& all_tried() {
    static const std::vector<Tried> kAll{
        every(&CoreParameters::sample_interval), every(&CoreParameters::mode),
        every(&CoreParameters::order),           {&CoreParameters::parameter_guard, {0, 4}},
        every(&CoreParameters::guard_bits),      every(&CoreParameters::coef_bits)};
    return kAll;
}

/// Visits every core that is built, with the values of the parameters from the n-th on.
template <class Visit>
void each_core(CoreParameters& parameters, std::size_t n, Visit visit) {
    if (n == all_tried().size()) {
        visit(parameters);
        return;
    }
    const Tried& tried = all_tried()[n];
    for (const int value : tried.values) {
        parameters.*tried.value = value;
        if (ref::legal(parameters)) each_core(parameters, n + 1, visit);
    }
    parameters.*tried.value = ref::parameter_of(tried.value).default_value;
}

/// The build beside the parallel one: of a curve core alone, of a board.
Build small_build(const Requirement& requirement) {
    return requirement.whole_board ? Build::kEngine : Build::kSerial;
}

int position_bits(const Requirement& requirement, double unit_mm) {
    return static_cast<int>(std::ceil(std::log2(requirement.travel_mm / unit_mm + 1))) + 1;
}

}  // namespace

std::optional<Candidate> make_candidate(const Requirement& requirement,
                                        const CoreParameters& parameters, double unit_mm) {
    Candidate candidate;
    candidate.limit = requirement.error_mm / unit_mm - parameters.rounding();
    const int bits = position_bits(requirement, unit_mm);
    if (candidate.limit < kLeastLimit || bits > 32) return std::nullopt;
    // A board draws arcs whatever it is asked for.
    const bool arcs = requirement.arcs() || requirement.whole_board;
    candidate.core = core_for(arcs, requirement.splines(), parameters.build);
    candidate.parameters = parameters;
    candidate.parameters.position_bits = std::max(16, bits);
    candidate.unit_mm = unit_mm;
    return candidate;
}

std::optional<CostEstimate> cost_of(const Requirement& requirement, const Candidate& candidate) {
    const auto cost = requirement.whole_board ? board_estimate : estimate;
    return cost(candidate.core, candidate.parameters, *requirement.device);
}

std::vector<Candidate> all_candidates(const Requirement& requirement) {
    std::vector<Candidate> all;
    const auto add = [&](const CoreParameters& parameters, double unit) {
        // motion_board has no such parameter.
        if (requirement.whole_board && parameters.parameter_guard > 0) return;
        std::optional<Candidate> one = make_candidate(requirement, parameters, unit);
        if (!one) return;
        const auto cost = cost_of(requirement, *one);
        if (!cost || !cost->fits(*requirement.device)) return;
        one->cost = *cost;
        one->size = cost->size(*requirement.device);
        all.push_back(*one);
    };
    std::vector<double> units(kUnits.begin(), kUnits.end());
    if (requirement.unit_mm) units = {*requirement.unit_mm};
    for (const double unit : units) {
        for (const Build build : {small_build(requirement), Build::kParallel}) {
            if (requirement.build && *requirement.build != build) continue;
            CoreParameters parameters;
            parameters.build = build;
            parameters.splines = requirement.splines() ? 1 : 0;
            parameters.multiplier_form = requirement.device->form;
            // The small builds take their own time between samples.
            const std::size_t first = build == Build::kParallel ? 0 : 1;
            each_core(parameters, first, [&](const CoreParameters& core) { add(core, unit); });
        }
    }
    const auto rank = [](const Candidate& candidate) {
        const CoreParameters& p = candidate.parameters;
        return std::make_tuple(candidate.size, p.coef_bits, p.position_bits + p.guard_bits, p.order,
                               p.parameter_guard, candidate.limit);
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); });
    return all;
}

bool cost_is_known(const Requirement& requirement) {
    const auto known = [&](Build build) {
        return requirement.whole_board ? board_cost_is_known(build, *requirement.device)
                                       : cost_is_known(build, *requirement.device);
    };
    if (requirement.build) return known(*requirement.build);
    return known(small_build(requirement)) || known(Build::kParallel);
}

}  // namespace curvecore::sysc
