// SPDX-License-Identifier: Apache-2.0
// core.json: a core with all that it was chosen for, as `choose` writes it and --core takes it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// | field           | unit | meaning                                                          |
/// |-----------------|------|------------------------------------------------------------------|
/// | core            |      | as scripts/synth.sh has it; empty: not said                      |
/// | parameters      |      | those not in the file have their defaults                        |
/// | device          |      | whose clock and multipliers it has; empty: any                   |
/// | error_mm        | mm   | worst error of a position as the core gives it                   |
/// | clock_hz        | Hz   | that it runs at                                                  |
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

/// @throws ref::InputError: no such file, no core in it, an unknown parameter, a value out of
/// range,
///         a combination that is not built
CoreFile read_core_file(const std::string& file);

}  // namespace curvecore::sysc
