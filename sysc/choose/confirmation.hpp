// SPDX-License-Identifier: Apache-2.0
// Place and route of the winner.
#pragma once

#include <stdexcept>
#include <string>

namespace curvecore::sysc {

/// Place and route did not run, or failed: what() gives the reason.
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

/// Runs scripts/synth.sh of the source tree in which this program stands, or the program that
/// CURVECORE_SYNTH names, with `--core FILE`, and reads the result that it names last.
/// @throws ConfirmationError
Confirmation place_and_route(const std::string& core_file);

}  // namespace curvecore::sysc
