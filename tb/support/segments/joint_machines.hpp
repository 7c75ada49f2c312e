// SPDX-License-Identifier: Apache-2.0
// The machines of tb/data/machines, and moves of their tools.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "ref/curves/row_powers.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/joints/joint_moves.hpp"
#include "ref/machine/machine.hpp"

namespace curvecore::tb {

inline const std::vector<std::string>& joint_machine_names() {
    static const std::vector<std::string> kNames{"corexy", "delta", "polar", "scara", "trunnion"};
    return kNames;
}

inline ref::Machine joint_machine(const std::string& name) {
    return ref::read_machine(std::string(DATA_DIR) + "/machines/" + name + ".ini");
}

/// A core that draws series.
inline ref::PlanOptions series_options() {
    auto table = std::make_shared<ref::CurveTable>(
        ref::read_curve_table(std::string(CURVES_DIR) + "/series.net"));
    table->powers = ref::row_powers(*table);
    ref::PlanOptions options;
    options.format.build = ref::Build::kEngine;
    ref::add_table(table, options.format);
    return options;
}

/// A place that the tool of a machine reaches, far from singular ones.
inline ref::ToolPose<double> tool_within_reach(const std::string& name, std::mt19937_64& random) {
    const auto real = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    ref::ToolPose<double> pose{{real(-60, 60), real(-60, 60), real(0, 20)}, {}};
    if (name == "corexy") pose.xyz = {real(20, 120), real(20, 120), real(0, 20)};
    if (name == "polar") pose.xyz = {real(20, 60), real(-60, 60), real(0, 20)};
    if (name == "scara") pose.xyz = {real(150, 300), real(-150, 150), real(0, 20)};
    if (name == "trunnion") pose.abc = {real(-30, 30), 0, real(-90, 90)};
    return pose;
}

/// A random line, arc or cubic of a machine's tool.
inline ref::Move tool_move(const std::string& name, std::mt19937_64& random) {
    const auto vec = [](const ref::ToolPose<double>& pose) {
        return ref::Vec3(pose.xyz[0], pose.xyz[1], pose.xyz[2]);
    };
    const ref::ToolPose<double> from = tool_within_reach(name, random);
    const ref::ToolPose<double> to = tool_within_reach(name, random);
    ref::Move move;
    move.feed = 50;
    move.start = vec(from);
    move.end = vec(to);
    for (std::size_t i = 0; i < 3; ++i) {
        move.aux_start[i] = from.abc[i];
        move.aux_end[i] = from.abc[i] + (to.abc[i] - from.abc[i]) / 20;
    }
    const auto kind = std::uniform_int_distribution<int>(0, 2)(random);
    if (kind == 1) {
        move.kind = ref::Move::Kind::kArc;
        const ref::Vec3 arm(std::uniform_real_distribution<double>(-8, 8)(random), 5, 0);
        move.centre = move.start - arm;
        move.angle = std::uniform_real_distribution<double>(0.5, 3)(random);
        move.advance = ref::Vec3(0, 0, std::uniform_real_distribution<double>(0, 5)(random));
        const ref::Vec3 side = move.normal.cross(arm);
        move.end =
            move.centre + std::cos(move.angle) * arm + std::sin(move.angle) * side + move.advance;
    } else if (kind == 2) {
        move.kind = ref::Move::Kind::kCubic;
        const ref::Vec3 way = move.end - move.start;
        const ref::Vec3 bow(0, 0, std::uniform_real_distribution<double>(2, 12)(random));
        move.cubic.d = move.start;
        move.cubic.c = way + bow;
        move.cubic.b = -bow;
    }
    move.to = move.length();
    return move;
}

}  // namespace curvecore::tb
