// SPDX-License-Identifier: Apache-2.0
// Options of `stream` besides the program: the board's link, and the drives at its pins.
#pragma once

#include <string>

#include "sysc/job/options.hpp"
#include "sysc/wire/remote_machine.hpp"

namespace curvecore::sysc {

struct WireOptions {
    std::string to;           // the link, as open_link() takes it
    Drives drives{{400.0}};   // one scale, or one an axis
    double watchdog_s = 0.5;  // silence of this program that is a hold; 0: none
    std::string control;      // file of commands; empty: none
};

/// Returns the drives of a board's axes. @throws UsageError: as many scales as it has axes are
/// wanted
Drives drives_of(const WireOptions& options, int axes);

/// Sets the shaper of the drives as the machine asks for it. @throws UsageError: the board has none
void shape(const ref::Machine& machine, const RemoteBuild& build, Drives& drives);

/// Sets the options to those of this board: a program is planned for it.
/// @throws UsageError: it draws another table than the program needs
void take_board(const RemoteBuild& build, Options& options);
/// Sets them to those of the board at the end of this link, which is only read.
/// @throws UsageError: no board is there, or one of another kind
void take_board(const std::string& link, Options& options);

/// Reads a duration in [0, 10s], s; units ns, us, ms, s. @throws UsageError
double duration_of(const std::string& option, const std::string& text);

}  // namespace curvecore::sysc
