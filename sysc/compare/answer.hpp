// SPDX-License-Identifier: Apache-2.0
// The answer of a comparison: which of its configurations to take on a device.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sysc/compare/compare_options.hpp"
#include "sysc/core/core_file.hpp"

namespace curvecore::sysc {

/// A configuration of the comparison in one build, on one device.
struct AnswerCore {
    const Row* row = nullptr;
    Core core;
    CoreParameters parameters;
    CostEstimate cost;
};

/// | field  | meaning                                                                            |
/// |--------|------------------------------------------------------------------------------------|
/// | keep   | configurations that keep the error that was asked for                              |
/// | fit    | of these, in any build that was asked for, those that fit the device               |
/// | take   | the smallest of those (CostEstimate::size()); none: none fits, or nothing is known |
/// | finest | the one of the least worst error; none: it is no finer                             |
struct Answer {
    const Device* device = nullptr;
    std::size_t keep = 0;
    std::size_t fit = 0;
    std::optional<AnswerCore> take;
    std::optional<AnswerCore> finest;

    /// One sentence or two. @param asked number of configurations
    std::string text(const CompareOptions& options, std::size_t asked) const;
    /// The core to take, for --core.
    CoreFile core(const CompareOptions& options) const;
};

/// The answer for each device that was asked for.
std::vector<Answer> answers(const CompareOptions& options, const ref::Program& program,
                            const SweepResult& result);

}  // namespace curvecore::sysc
