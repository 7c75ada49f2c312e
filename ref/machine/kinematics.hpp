// SPDX-License-Identifier: Apache-2.0
// Joints of a machine for a place of its tool, and the place that joints make. The names, joints
// and parameters are those of LinuxCNC's kinematics modules.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ref/curve/vec3.hpp"
#include "ref/numeric/angles.hpp"

namespace curvecore::ref {

/// A place of the tool, mm, and of A B C, degrees; Number: double, or a series in the path.
template <class Number>
struct ToolPose {
    std::array<Number, 3> xyz;
    std::array<Number, 3> abc;
};

/// The joints 0, 1, 2 of a machine: mm, degrees of those that turn.
template <class Number>
using Joints = std::array<Number, 3>;

/// A parameter of a machine in its .ini. kTurns says which of the joints 0, 1, 2 are angles,
/// kUndriven which letters have no joint.
struct KinematicsParameter {
    enum class Kind { kLength, kOffset, kNumber };  // above 0, any, not in the .ini's unit

    std::string_view name;
    std::optional<double> value;  // without it; none: it is needed
    Kind kind;
};
constexpr auto kLengthOf = KinematicsParameter::Kind::kLength;
constexpr auto kOffsetOf = KinematicsParameter::Kind::kOffset;
constexpr auto kNumberOf = KinematicsParameter::Kind::kNumber;

/// X Y Z are the joints.
struct TrivialKinematics {
    static constexpr std::string_view kName = "trivkins";
    static constexpr std::array<bool, 3> kTurns{};
    static constexpr std::string_view kUndriven = "";
    static constexpr std::array<KinematicsParameter, 0> kParameters{};

    template <class Number>
    Joints<Number> joints(const ToolPose<Number>& tool) const {
        return tool.xyz;
    }
    Vec3 tool(const Vec3& j, const Vec3& /*abc*/) const { return j; }
};

/// Two belts that both carry X and Y.
struct CoreXy {
    static constexpr std::string_view kName = "corexykins";
    static constexpr std::array<bool, 3> kTurns{};
    static constexpr std::string_view kUndriven = "";
    static constexpr std::array<KinematicsParameter, 0> kParameters{};

    template <class Number>
    Joints<Number> joints(const ToolPose<Number>& tool) const {
        return {tool.xyz[0] + tool.xyz[1], tool.xyz[0] - tool.xyz[1], tool.xyz[2]};
    }
    Vec3 tool(const Vec3& j, const Vec3& /*abc*/) const {
        return {(j[0] + j[1]) / 2, (j[0] - j[1]) / 2, j[2]};
    }
};

/// A spindle that turns, and a slide through its axis: radius, Z, angle.
struct Rose {
    static constexpr std::string_view kName = "rosekins";
    static constexpr std::array<bool, 3> kTurns{false, false, true};
    static constexpr std::string_view kUndriven = "ABCUVW";
    static constexpr std::array<KinematicsParameter, 0> kParameters{};

    template <class Number>
    Joints<Number> joints(const ToolPose<Number>& tool) const {
        using std::atan2;
        using std::sqrt;
        const auto& [x, y, z] = tool.xyz;
        return {sqrt(x * x + y * y), z, atan2(y, x) / kRadiansPerDegree};
    }
    Vec3 tool(const Vec3& j, const Vec3& /*abc*/) const {
        const double angle = j[2] * kRadiansPerDegree;
        return {j[0] * std::cos(angle), j[0] * std::sin(angle), j[1]};
    }
};

/// Three carriages on towers at 90, 210 and 330 degrees of a circle, with rods to the tool.
struct LinearDelta {
    static constexpr std::string_view kName = "lineardeltakins";
    static constexpr std::array<bool, 3> kTurns{};
    static constexpr std::string_view kUndriven = "";
    static constexpr std::array<KinematicsParameter, 2> kParameters{
        {{"R", {}, kLengthOf}, {"L", {}, kLengthOf}}};

    double radius, rod;

    template <class Number>
    Joints<Number> joints(const ToolPose<Number>& tool) const {
        using std::sqrt;
        Joints<Number> height{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 at = tower(i);
            const Number x = tool.xyz[0] - at[0];
            const Number y = tool.xyz[1] - at[1];
            height[i] = tool.xyz[2] + sqrt(rod * rod - x * x - y * y);
        }
        return height;
    }
    /// The lower of the two points that are a rod away from all three.
    Vec3 tool(const Vec3& j, const Vec3& abc) const;

  private:
    Vec3 tower(std::size_t i) const {
        const double angle = (90 + 120 * static_cast<double>(i)) * kRadiansPerDegree;
        return {radius * std::cos(angle), radius * std::sin(angle), 0};
    }
};

/// Two arms that turn about upright axes, and a slide that is positive downwards. The fourth joint,
/// the wrist, is not driven.
struct Scara {
    static constexpr std::string_view kName = "scarakins";
    static constexpr std::array<bool, 3> kTurns{true, true, false};
    static constexpr std::string_view kUndriven = "C";
    static constexpr std::array<KinematicsParameter, 6> kParameters{{{"D1", {}, kOffsetOf},
                                                                     {"D2", {}, kLengthOf},
                                                                     {"D3", {}, kOffsetOf},
                                                                     {"D4", {}, kLengthOf},
                                                                     {"D5", {}, kOffsetOf},
                                                                     {"ELBOW", 1.0, kNumberOf}}};

    double column, inner, rise, outer, tip;  // D1 .. D5
    double elbow;                            // the sign of joint 1

    template <class Number>
    Joints<Number> joints(const ToolPose<Number>& tool) const {
        using std::acos;
        using std::atan2;
        using std::cos;
        using std::sin;
        const auto& [x, y, z] = tool.xyz;
        const Number cosine = (x * x + y * y - inner * inner - outer * outer) / (2 * inner * outer);
        const Number bend = acos(cosine) * elbow;
        const Number arm = atan2(y, x) - atan2(outer * sin(bend), outer * cos(bend) + inner);
        return {arm / kRadiansPerDegree, bend / kRadiansPerDegree, (column + rise - tip) - z};
    }
    Vec3 tool(const Vec3& j, const Vec3& /*abc*/) const {
        const double first = j[0] * kRadiansPerDegree;
        const double both = first + j[1] * kRadiansPerDegree;
        return {inner * std::cos(first) + outer * std::cos(both),
                inner * std::sin(first) + outer * std::sin(both), column + rise - tip - j[2]};
    }
};

/// A table that tilts by A and turns by C beneath the tool: X Y Z follow the part.
struct TiltingTable {
    static constexpr std::string_view kName = "xyzac-trt-kins";
    static constexpr std::array<bool, 3> kTurns{};
    static constexpr std::string_view kUndriven = "";
    static constexpr std::array<KinematicsParameter, 7> kParameters{
        {{"X_ROT_POINT", 0.0, kOffsetOf},
         {"Y_ROT_POINT", 0.0, kOffsetOf},
         {"Z_ROT_POINT", 0.0, kOffsetOf},
         {"Y_OFFSET", 0.0, kOffsetOf},
         {"Z_OFFSET", 0.0, kOffsetOf},
         {"TOOL_OFFSET", 0.0, kOffsetOf},
         {"CONVENTIONAL_DIRECTIONS", 0.0, kNumberOf}}};

    double x_turn, y_turn, z_turn;  // a point of C's axis
    double y_offset, z_offset;      // from there to A's axis
    double tool_length;
    double conventional;  // 1: the sense of A and C is the part's; 0: the table's

    template <class Number>
    Joints<Number> joints(const ToolPose<Number>& tool) const {
        using std::cos;
        using std::sin;
        const double sense = conventional != 0 ? 1 : -1;
        const Number ca = cos(tool.abc[0] * kRadiansPerDegree);
        const Number sa = sin(tool.abc[0] * kRadiansPerDegree) * sense;
        const Number cc = cos(tool.abc[2] * kRadiansPerDegree);
        const Number sc = sin(tool.abc[2] * kRadiansPerDegree) * sense;
        const Number x = tool.xyz[0] - x_turn;
        const Number y = tool.xyz[1] - y_turn;
        // About C, then about A.
        const Number across = y * cc - x * sc - y_offset;
        const Number up = tool.xyz[2] - (z_turn + z_offset + tool_length);
        return {x * cc + y * sc + x_turn, across * ca + up * sa + (y_offset + y_turn),
                up * ca - across * sa + (z_turn + z_offset + tool_length)};
    }
    Vec3 tool(const Vec3& j, const Vec3& abc) const;
};

using Kinematics = std::variant<TrivialKinematics, CoreXy, Rose, LinearDelta, Scara, TiltingTable>;

/// Names of the kinematics, those of LinuxCNC's modules.
std::vector<std::string_view> kinematics_names();

inline bool is_trivial(const Kinematics& kinematics) {
    return std::holds_alternative<TrivialKinematics>(kinematics);
}

inline std::string_view name_of(const Kinematics& kinematics) {
    return std::visit([](const auto& machine) { return machine.kName; }, kinematics);
}

/// Returns true for each of the joints 0, 1, 2 that is an angle.
std::array<bool, 3> turning(const Kinematics& kinematics);

/// The place of the tool that joints and A B C, mm and degrees, put it at.
Vec3 tool_of(const Kinematics& kinematics, const Vec3& joints, const Vec3& abc);

/// Largest distance of the tool, mm, where each joint, A, B and C are off by so much: to the first
/// order.
double tool_error(const Kinematics& kinematics, const Vec3& joints, const Vec3& abc, double error);

}  // namespace curvecore::ref
