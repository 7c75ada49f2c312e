// SPDX-License-Identifier: Apache-2.0
// Programs as text, an instruction a line, as the listing shows them (listing.hpp):
//
//     word NAME ..     wide NAME ..     axis NAME ..            words, of six limbs, of each axis
//     local NAME ..       word NAME = NUMBER   wide NAME = 0    with its value at reset
//                         word NAME = place of L                .. where the link may go to
//     data NAME = NUMBER                                        a constant, known to all sources
//     NAME:                                                     a label
//     d = a                                                     a copy
//     d = a + b        d = a - b        d = a * b               of three limbs, or `, 1 limb` ..
//     d = a * b >> 45                   d = floor(a * b >> 45)  rounded to nearest, or down
//     d = c + (d * b >> 45)             the same on top of c
//     w = wide a * b   w += wide a * b  a sum of products in a wide word
//     d = wide w * b >> 45              what it is, shifted and rounded; or floor(wide ..)
//     test a - b                        sets negative and zero alone
//     d = port 5       port 6 = a
//     go to L          if negative go to L          if not port 3 call L          return
//     wait for the tick, go to L        end, then L             for each axis call L
//     loop  ..  repeat 19 times         its body, at most so often again; a branch leads out
//
// a, b, c and d are words, or 0, or a number, or the place of a label; b may be 2^n or -1, and that
// of a sum 2^n. A number has a word, but not one that is 2^n and stands for itself, or as b of a
// sum. A word of each axis has a name like x or x[k]. A port is a number, too, or the name of one.
// Locals live in one call of one of their source's programs: those of all sources have the same
// words. A program that calls another keeps its link: `back = port 2` .. `port 2 = back`.
#pragma once

#include <string>

#include "rtl/engine/assembler/assembly.hpp"

namespace curvecore::assembler {

/// Adds a file's programs. @throws AssemblyError or ref::InputError with file, line and reason
void assemble_source(const std::string& file, Assembly& assembly);

/// Adds programs from text; `file` names it in errors.
void assemble_text(const std::string& file, const std::string& text, Assembly& assembly);

}  // namespace curvecore::assembler
