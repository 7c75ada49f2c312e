// SPDX-License-Identifier: Apache-2.0
// join.json: an idle move as it was designed, to be loaded again by `curvecore join` and its page.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "ref/join/idle_gcode.hpp"

namespace curvecore::sysc {

/// Of the file's layout, not of the program.
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
    /// With `result`: lengths and jumps of this move and of others, which nobody reads back.
    nlohmann::ordered_json json() const;
    std::string text() const;  // of the file
};

/// @throws ref::InputError, with the line of what is wrong: no JSON, another version, a missing or
///         impossible value
JoinFile read_join_file(const std::string& file);
JoinFile read_join_text(const std::string& text, const std::string& file_name);

/// What the points of a move must be, also those of a command line. Empty: they are.
std::string flaw_of(const ref::IdleMove& move);

nlohmann::ordered_json joint_json(const ref::Joint& joint);

}  // namespace curvecore::sysc
