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
    std::vector<Choice> choices;          // the winner first; empty: none keeps the requirement
    std::vector<Relaxation> relaxations;  // then
    std::optional<Confirmation> confirmation;
    double seconds = 0;

    std::string text() const;
    nlohmann::ordered_json json() const;
    /// The winner, which must be there.
    CoreFile core() const;
};

}  // namespace curvecore::sysc
