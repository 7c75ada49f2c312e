// SPDX-License-Identifier: Apache-2.0
#include "ref/machine/kinematics.hpp"

#include <Eigen/Geometry>

namespace curvecore::ref {
namespace {

template <std::size_t... I>
std::vector<std::string_view> names_of(std::index_sequence<I...> /*all*/) {
    return {std::variant_alternative_t<I, Kinematics>::kName...};
}

}  // namespace

std::vector<std::string_view> kinematics_names() {
    return names_of(std::make_index_sequence<std::variant_size_v<Kinematics>>());
}

// Each carriage, lowered along its tower, is the centre of a sphere of a rod's length; the two
// points of all three lie on a line at right angles to the plane through the centres.
Vec3 LinearDelta::tool(const Vec3& j, const Vec3& /*abc*/) const {
    std::array<Vec3, 3> centre;
    for (std::size_t i = 0; i < 3; ++i) {
        centre[i] = tower(i) + Vec3(0, 0, j[static_cast<Eigen::Index>(i)]);
    }
    const Vec3 a = centre[1] - centre[0];
    const Vec3 b = centre[2] - centre[0];
    const Vec3 normal = a.cross(b);
    // The circumcentre of a triangle.
    const Vec3 middle = (a.squaredNorm() * b.cross(normal) + b.squaredNorm() * normal.cross(a)) /
                        (2 * normal.squaredNorm());
    const double rest = rod * rod - middle.squaredNorm();
    const Vec3 upwards = normal.z() > 0 ? normal : Vec3(-normal);
    return centre[0] + middle - upwards.normalized() * std::sqrt(rest);
}

// The inverse's two turns, backwards.
Vec3 TiltingTable::tool(const Vec3& j, const Vec3& abc) const {
    const double sense = conventional != 0 ? 1 : -1;
    const double ca = std::cos(abc[0] * kRadiansPerDegree);
    const double sa = std::sin(abc[0] * kRadiansPerDegree) * sense;
    const double cc = std::cos(abc[2] * kRadiansPerDegree);
    const double sc = std::sin(abc[2] * kRadiansPerDegree) * sense;
    const double x = j[0] - x_turn;
    const double p = j[1] - y_offset - y_turn;
    const double q = j[2] - z_turn - z_offset - tool_length;
    const double y = p * ca - q * sa + y_offset;
    return {x * cc - y * sc + x_turn, x * sc + y * cc + y_turn,
            p * sa + q * ca + z_turn + z_offset + tool_length};
}

std::array<bool, 3> turning(const Kinematics& kinematics) {
    return std::visit([](const auto& machine) { return machine.kTurns; }, kinematics);
}

Vec3 tool_of(const Kinematics& kinematics, const Vec3& joints, const Vec3& abc) {
    return std::visit([&](const auto& machine) { return machine.tool(joints, abc); }, kinematics);
}

double tool_error(const Kinematics& kinematics, const Vec3& joints, const Vec3& abc, double error) {
    constexpr double kStep = 1e-4;  // mm, degrees
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        const Vec3 step = kStep * Vec3::Unit(i);
        const Vec3 moved =
            tool_of(kinematics, joints + step, abc) - tool_of(kinematics, joints - step, abc);
        const Vec3 turned =
            tool_of(kinematics, joints, abc + step) - tool_of(kinematics, joints, abc - step);
        sum += (moved.cwiseAbs() + turned.cwiseAbs()) / (2 * kStep);
    }
    return error * sum.norm();
}

}  // namespace curvecore::ref
