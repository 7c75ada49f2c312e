// SPDX-License-Identifier: Apache-2.0
// join.html: the page in which an idle move is designed; one file, no network.
#pragma once

#include "sysc/join/join_file.hpp"

namespace curvecore::sysc {

/// join.ngc but for the idle move's blocks.
struct JoinProgram {
    std::string head, tail;

    std::string with(const std::string& idle) const { return head + idle + tail; }
};

/// `a` ends at the first joint, `b` begins at the second (ref/join/joint.hpp).
/// @throws ref::InputError: a spline with auxiliary axes
JoinProgram join_program(const ref::Program& a, const ref::Program& b);

/// The page's mathematics is that of ref/join; a test holds both to the same numbers.
std::string join_html(const JoinFile& file, const ref::Program& a, const ref::Program& b,
                      const JoinProgram& program);

}  // namespace curvecore::sysc
