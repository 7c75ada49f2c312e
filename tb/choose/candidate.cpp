// SPDX-License-Identifier: Apache-2.0
#include "tb/choose/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace curvecore::tb {
namespace {

constexpr std::array<int, 7> kTurnBits{0, 2, 4, 6, 8, 10, 12};
constexpr std::array<int, 2> kParameterGuards{0, 4};
constexpr double kLeastLimit = 1e-3;  // units: below it no segment can be planned

/// With those parameters that few cores have.
template <class Visit>
void each_special(CoreParameters parameters, Visit visit) {
    for (const int guard : kParameterGuards) {
        parameters.parameter_guard = guard;
        if (guard > 0 && !takes_parameter_guard(parameters)) break;
        for (const int turn_bits : kTurnBits) {
            parameters.turn_bits = turn_bits;
            if (turn_bits == 0 || takes_turn_bits(parameters)) visit(parameters);
        }
    }
}

/// Every value of a core's parameters that choose varies.
template <class Visit>
void each_core(const Wish& wish, Visit visit) {
    CoreParameters parameters;
    parameters.splines = wish.splines() ? 1 : 0;
    for (const Build build : {Build::kSerial, Build::kParallel}) {
        if (wish.build && *wish.build != build) continue;
        parameters.build = build;
        for (const int interval : {1, 2, 4, 8}) {
            if (build == Build::kSerial && interval > 1) break;
            parameters.sample_interval = interval;
            for (parameters.mode = 0; parameters.mode <= 1; ++parameters.mode) {
                for (parameters.order = 2; parameters.order <= 12; ++parameters.order) {
                    each_special(parameters, visit);
                }
            }
        }
    }
}

int position_bits(const Wish& wish, double unit_mm) {
    return static_cast<int>(std::ceil(std::log2(wish.travel_mm / unit_mm + 1))) + 1;
}

}  // namespace

std::optional<Candidate> make_candidate(const Wish& wish, const CoreParameters& parameters,
                                        double unit_mm) {
    Candidate candidate;
    candidate.limit = wish.error_mm / unit_mm - 0.5;
    const int bits = position_bits(wish, unit_mm);
    if (candidate.limit < kLeastLimit || bits > 32) return std::nullopt;
    candidate.core = core_for(wish.arcs(), wish.splines(), parameters.build);
    candidate.parameters = parameters;
    candidate.parameters.position_bits = std::max(16, bits);
    candidate.unit_mm = unit_mm;
    return candidate;
}

std::vector<Candidate> all_candidates(const Wish& wish) {
    std::vector<Candidate> all;
    for (const double unit : kUnits) {
        if (wish.unit_mm && *wish.unit_mm != unit) continue;
        each_core(wish, [&](CoreParameters parameters) {
            for (parameters.guard_bits = 2; parameters.guard_bits <= 12; ++parameters.guard_bits) {
                for (parameters.coef_bits = 18; parameters.coef_bits <= 36;
                     ++parameters.coef_bits) {
                    std::optional<Candidate> one = make_candidate(wish, parameters, unit);
                    if (!one) return;
                    const auto cost = estimate(one->core, one->parameters, *wish.device);
                    if (!cost) return;
                    if (!cost->fits(*wish.device)) continue;
                    one->cost = *cost;
                    one->size = cost->size(*wish.device);
                    all.push_back(*one);
                }
            }
        });
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

bool cost_is_known(const Wish& wish) {
    const auto known = [&](Build build) { return cost_is_known(build, *wish.device); };
    if (wish.build) return known(*wish.build);
    return known(Build::kSerial) || known(Build::kParallel);
}

}  // namespace curvecore::tb
