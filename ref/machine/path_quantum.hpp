// SPDX-License-Identifier: Apache-2.0
// The path's quantum in millimetres. A machine with joints has a path that is so much longer than
// the tool's, as its joints need it: ref/joints/joint_moves.hpp.
#pragma once

#include "ref/format/path_words.hpp"
#include "ref/machine/machine.hpp"

namespace curvecore::ref {

/// Millimetres of the tool's path for a quantum of the path, with lengths in units of `unit_mm`.
inline double path_quantum_mm(const Machine& machine, double unit_mm) {
    return kQuantum * unit_mm / machine.joint_stretch();
}

}  // namespace curvecore::ref
