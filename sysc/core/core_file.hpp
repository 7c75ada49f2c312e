// SPDX-License-Identifier: Apache-2.0
// The file core.json: a core and what it was chosen for, as `choose` writes it and --core reads it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// | field           | unit | meaning                                                          |
/// |-----------------|------|------------------------------------------------------------------|
/// | core            |      | name as scripts/synth.sh has it; empty: not given                |
/// | parameters      |      | those not in the file have their defaults                        |
/// | device          |      | device that gives clock and multipliers; empty: any              |
/// | error_mm        | mm   | worst error of a position as the core returns it                 |
/// | clock_hz        | Hz   | clock that the core runs at                                      |
struct CoreFile {
    std::string core;
    CoreParameters parameters;
    std::string device;
    std::optional<double> unit_mm;
    std::optional<double> error_mm;
    std::optional<double> sample_period_s;
    std::optional<double> clock_hz;

    nlohmann::ordered_json json() const;
};

/// @throws ref::InputError: no such file, no core in it, an unknown parameter, a value out of its
///         range, a combination that is not built
CoreFile read_core_file(const std::string& file);

}  // namespace curvecore::sysc
