// SPDX-License-Identifier: Apache-2.0
// What `curvecore explore` found: a table, explore.json, explore.html.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sysc/explore/explorer.hpp"

namespace curvecore::sysc {

struct ExploreReport {
    const Job& job;
    const ExploreGrid& grid;
    const std::vector<ExploreRow>& rows;

    /// For one host and bus at least.
    bool answered() const;
    std::string table() const;
    nlohmann::ordered_json json() const;
    std::string html() const;
};

/// A time as --host and --word take it: 100us, 2.5ms.
std::string short_time(double seconds);

}  // namespace curvecore::sysc
