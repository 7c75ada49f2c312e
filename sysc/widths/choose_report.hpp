// SPDX-License-Identifier: Apache-2.0
// The answer of `curvecore choose`: a table, and choose.json.
#pragma once

#include <nlohmann/json.hpp>

#include "tb/choose/chooser.hpp"
#include "tb/choose/concession.hpp"
#include "tb/choose/confirmation.hpp"

namespace curvecore::tb {

struct ChooseReport {
    const Wish& wish;
    std::vector<Choice> choices;          // the winner first; empty: none keeps the wish
    std::vector<Concession> concessions;  // then
    std::optional<Confirmation> confirmation;
    double seconds = 0;

    std::string text() const;
    nlohmann::ordered_json json() const;
};

}  // namespace curvecore::tb
