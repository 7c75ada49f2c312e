// SPDX-License-Identifier: Apache-2.0
// The answer of `curvecore choose`: a table, choose.json, and core.json.
#pragma once

#include <nlohmann/json.hpp>

#include "sysc/choose/chooser.hpp"
#include "sysc/choose/confirmation.hpp"
#include "sysc/choose/relaxation.hpp"
#include "sysc/core/core_file.hpp"

namespace curvecore::sysc {

struct ChooseReport {
    const Requirement& requirement;
    std::vector<Choice> choices;          // the winner first; empty: none meets the requirement
    std::vector<Relaxation> relaxations;  // found if `choices` is empty
    std::optional<Confirmation> confirmation;
    double seconds = 0;

    std::string text() const;
    nlohmann::ordered_json json() const;
    /// Returns the winner, which must exist.
    CoreFile core() const;
};

}  // namespace curvecore::sysc
