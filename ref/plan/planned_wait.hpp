// SPDX-License-Identifier: Apache-2.0
// A wait for a person at a place of the path where the machine stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace curvecore::ref {

/// | field            | unit   | remark                                                      |
/// |------------------|--------|-------------------------------------------------------------|
/// | place            | quanta | of the path, program-wide                                   |
/// | segments, pieces | 1      | of the part that are drawn before it                        |
/// | line             |        | of the program that asked for it                            |
/// | what             |        | the code, with the tool if it is a change of tools: "M6 T2" |
struct PlannedWait {
    std::uint64_t place = 0;
    std::size_t segments = 0;
    std::size_t pieces = 0;
    int line = 0;
    std::string what;
};

}  // namespace curvecore::ref
