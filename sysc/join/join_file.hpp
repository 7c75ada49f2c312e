// SPDX-License-Identifier: Apache-2.0
// The file join.json: an idle move as designed, which `curvecore join` and its page load again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "ref/join/idle_gcode.hpp"

namespace curvecore::sysc {

/// Version of the file's layout, not of the program.
constexpr int kJoinVersion = 1;
constexpr std::size_t kMostJoinPoints = 100;

/// | field     | in the file                                                                     |
/// |-----------|---------------------------------------------------------------------------------|
/// | a, b      | the working programs, as the command line named them                            |
/// | move      | start, end {position mm, tangent, curvature 1/mm, feed mm/s}; fit; t; points     |
/// | law       | speed                                                                           |
/// | gcode     | gcode {form, size_mm}                                                           |
struct JoinFile {
    std::string a, b;
    ref::IdleMove move;
    ref::SpeedLaw law = ref::SpeedLaw::kSmooth;
    ref::GcodeChoice gcode;

    ref::SpeedCourse course(double length) const {
        return {law, move.start.feed, move.end.feed, length};
    }
    /// Returns the file's data; with `result` also lengths and jumps of this move and of others,
    /// which no reader uses.
    nlohmann::ordered_json json() const;
    std::string text() const;  // text of the file
};

/// @throws ref::InputError, with the line of the flaw: no JSON, another version, a missing or
/// invalid value
JoinFile read_join_file(const std::string& file);
JoinFile read_join_text(const std::string& text, const std::string& file_name);

/// Describes a flaw in the points of a move, also of a command line; empty: there is none.
std::string flaw_of(const ref::IdleMove& move);

nlohmann::ordered_json joint_json(const ref::Joint& joint);

}  // namespace curvecore::sysc
