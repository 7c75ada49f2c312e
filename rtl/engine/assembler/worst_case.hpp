// SPDX-License-Identifier: Apache-2.0
// Longest time of a program in clocks (hls/instruction.hpp): over all ways from its label to an
// end, every loop taken as often as it may be. A wait for the tick counts as none.
#pragma once

#include <set>
#include <string>

#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Clocks from a label until an instruction of `ends` comes, or the foreground ends, or a
/// subroutine gives back. @throws AssemblyError if there is a way round that is no loop
int worst_case(const Assembly& assembly, const std::string& label,
               const std::set<std::string>& ends = {});

/// @throws AssemblyError if a program may take longer than a period
void keep_period(const Assembly& assembly, const std::string& label,
                 const std::set<std::string>& ends, int period);

}  // namespace curvecore::assembler
