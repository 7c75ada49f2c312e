// SPDX-License-Identifier: Apache-2.0
// The winner through place and route.
#pragma once

#include <stdexcept>

#include "tb/choose/candidate.hpp"

namespace curvecore::tb {

/// Place and route that did not run, or failed: what() says why.
class ConfirmationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct Confirmation {
    double lut4 = 0;
    double ff = 0;
    double mhz = 0;
    int dsp = 0;
    int ram = 0;
    int seeds = 0;
};

/// Runs scripts/synth.sh of this source tree, or the program that CURVECORE_SYNTH names, with
/// `--core --build --device --set Name=Value ...`, and reads the file that it names last.
/// @throws ConfirmationError
Confirmation place_and_route(const Candidate& candidate, const Device& device);

}  // namespace curvecore::tb
