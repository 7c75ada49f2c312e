// SPDX-License-Identifier: Apache-2.0
// Report of `curvecore explore`: a table, explore.json, explore.html.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sysc/explore/explorer.hpp"

namespace curvecore::sysc {

struct ExploreReport {
    const Job& job;
    const ExploreGrid& grid;
    const std::vector<ExploreRow>& rows;

    /// Returns true if at least one host and bus has a pair that fits.
    bool answered() const;
    std::string table() const;
    nlohmann::ordered_json json() const;
    std::string html() const;
};

/// Time as --host and --word take it: 100us, 2.5ms.
std::string short_time(double seconds);

}  // namespace curvecore::sysc
