// SPDX-License-Identifier: Apache-2.0
// A change of outputs at a place of the path: what a program asks for besides motion, and can be
// had while it moves.
#pragma once

#include <cstdint>

namespace curvecore::ref {

enum class OutputKind { kBits = 0, kLevel, kFollow };
constexpr double kAtAnySpeed = 0;
constexpr double kAtAnyButRest = -1;

/// | field | unit   | remark                                                                     |
/// |-------|--------|----------------------------------------------------------------------------|
/// | place | quanta | of the path, program-wide                                                  |
/// | value |        | kBits: all of them, 0 .. 255; kLevel: 0 .. 1; kFollow: the speed along the  |
/// |       | mm/s   | path at which the level is whole, below it in proportion; kAtAnySpeed,      |
/// |       |        | kAtAnyButRest                                                              |
/// | line  |        | of the program that asked for it                                           |
/// | waits |        | PlannedWaits of the program that come before it                            |
struct PlannedOutput {
    std::uint64_t place = 0;
    OutputKind kind = OutputKind::kBits;
    double value = 0;
    int line = 0;
    int waits = 0;
};

}  // namespace curvecore::ref
