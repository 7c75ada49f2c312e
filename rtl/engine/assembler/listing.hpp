// SPDX-License-Identifier: Apache-2.0
// A listing to read, and texts for $readmemh.
//
// A row of the listing is an instruction: its place and word in hexadecimal, its clocks, what it
// does on named words, and behind | the line of source that it comes from. A name is a row of a
// curve's table: N[k].3 is order 3 of N of the axis at hand, w<<10 is w times 2^10, t7 a word
// between two steps of a line. `>> 45` rounds to nearest, ties upwards; floor(..) rounds down.
#pragma once

#include <string>
#include <vector>

#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// A program for the listing: its label, and where it ends.
struct Program {
    std::string label;
    std::string end;
};

/// Lists the programs' longest times, the instructions and the words of data.
std::string listing(const Assembly& assembly, const std::vector<Program>& programs);

/// Instructions, a word of 8 digits a line.
std::string program_hex(const Assembly& assembly);
/// Limbs, four of a word, 4 digits a line.
std::string data_hex(const Assembly& assembly);

}  // namespace curvecore::assembler
