// SPDX-License-Identifier: Apache-2.0
// The page join.html, in which an idle move is designed; one file, no network.
#pragma once

#include "sysc/join/join_file.hpp"

namespace curvecore::sysc {

/// The program join.ngc without the idle move's blocks.
struct JoinProgram {
    std::string head, tail;

    std::string with(const std::string& idle) const { return head + idle + tail; }
};

/// Makes the program; `a` ends at the first joint, `b` begins at the second (ref/join/joint.hpp).
/// @throws ref::InputError: a spline with auxiliary axes
JoinProgram join_program(const ref::Program& a, const ref::Program& b);

/// Writes the page. Its mathematics is that of ref/join; a test compares the two.
std::string join_html(const JoinFile& file, const ref::Program& a, const ref::Program& b,
                      const JoinProgram& program);

}  // namespace curvecore::sysc
