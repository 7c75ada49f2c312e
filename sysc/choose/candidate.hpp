// SPDX-License-Identifier: Apache-2.0
// One configuration that could be the answer.
#pragma once

#include <array>
#include <vector>

#include "sysc/choose/requirement.hpp"

namespace curvecore::sysc {

constexpr std::array<double, 4> kUnits{1e-3, 1e-4, 1e-5, 1e-6};  // mm

/// | field      | meaning                                                                    |
/// |------------|----------------------------------------------------------------------------|
/// | parameters | PositionBits as few as the travel needs, with MultiplierForm of the device |
/// | unit_mm    | length unit                                                                |
/// | limit      | units: bound that the planner keeps for each segment; with half a unit for |
/// |            | the rounding of the output the error keeps the requirement                 |
/// | size       | share of the device, CostEstimate::size()                                  |
struct Candidate {
    Core core = Core::kSpherical;
    CoreParameters parameters;
    double unit_mm = 0;
    double limit = 0;
    CostEstimate cost;
    double size = 0;
};

/// Makes the candidate of one set of widths, all but size and cost. Returns none if the unit is too
/// coarse for the error or too fine for the travel.
std::optional<Candidate> make_candidate(const Requirement& requirement,
                                        const CoreParameters& parameters, double unit_mm);

/// Returns the cost of the core, or of the whole board; none where it is not known.
std::optional<CostEstimate> cost_of(const Requirement& requirement, const Candidate& candidate);

/// Returns every configuration that fits the device, smallest first.
std::vector<Candidate> all_candidates(const Requirement& requirement);

/// Returns true if runs of any build were measured for the device.
bool cost_is_known(const Requirement& requirement);

}  // namespace curvecore::sysc
