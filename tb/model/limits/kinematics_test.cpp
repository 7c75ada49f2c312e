// SPDX-License-Identifier: Apache-2.0
// Kinematics of machines: forward undoes inverse, and the .ini says which. LinuxCNC's own modules
// judge them in tb/linuxcnc/kinematics_test.py.
#include "ref/machine/kinematics.hpp"

#include <gtest/gtest.h>

#include <random>

#include "ref/machine/machine.hpp"
#include "ref/text/input_error.hpp"
#include "tb/support/segments/joint_machines.hpp"

namespace curvecore::tb::kinematics_test {

using ref::Vec3;

TEST(Kinematics, ForwardUndoesInverse) {
    std::mt19937_64 random(1);
    for (const std::string& name : joint_machine_names()) {
        const ref::Machine machine = joint_machine(name);
        for (int i = 0; i < 1000; ++i) {
            const ref::ToolPose<double> tool = tool_within_reach(name, random);
            const ref::Joints<double> joints =
                std::visit([&](const auto& of) { return of.joints(tool); }, machine.kinematics);
            const Vec3 again = ref::tool_of(machine.kinematics, {joints[0], joints[1], joints[2]},
                                            {tool.abc[0], tool.abc[1], tool.abc[2]});
            const Vec3 asked(tool.xyz[0], tool.xyz[1], tool.xyz[2]);
            EXPECT_LT((again - asked).norm(), 1e-10) << name;
        }
    }
}

TEST(Kinematics, ErrorOfTheToolIsThatOfItsJoints) {
    std::mt19937_64 random(2);
    constexpr double kError = 1e-5;
    double closest = 0;
    for (const std::string& name : joint_machine_names()) {
        const ref::Machine machine = joint_machine(name);
        for (int i = 0; i < 200; ++i) {
            const ref::ToolPose<double> pose = tool_within_reach(name, random);
            const ref::Joints<double> at =
                std::visit([&](const auto& of) { return of.joints(pose); }, machine.kinematics);
            const Vec3 joints(at[0], at[1], at[2]);
            const Vec3 abc(pose.abc[0], pose.abc[1], pose.abc[2]);
            const double bound = ref::tool_error(machine.kinematics, joints, abc, kError);
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 off(corner & 1 ? kError : -kError, corner & 2 ? kError : -kError,
                               corner & 4 ? kError : -kError);
                const double moved = (ref::tool_of(machine.kinematics, joints + off, abc) -
                                      ref::tool_of(machine.kinematics, joints, abc))
                                         .norm();
                EXPECT_LT(moved, bound * 1.001) << name;
                closest = std::max(closest, moved / bound);
            }
        }
    }
    EXPECT_GT(closest, 0.9);
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string refusal(const std::string& ini) {
    try {
        ref::read_machine_text(ini, "robot.ini");
    } catch (const ref::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Kinematics, OfTheFileAreLinuxCncs) {
    const ref::Machine delta = joint_machine("delta");
    EXPECT_EQ(ref::name_of(delta.kinematics), "lineardeltakins");
    EXPECT_EQ(delta.axis[1].max, 500);
    EXPECT_EQ(delta.tool[0].max, 100);
    EXPECT_EQ(delta.of_tool().axis[0].max, 100);
    EXPECT_NEAR(delta.of_tool().home->z(), 245 - std::sqrt(269. * 269 - 130 * 130), 1e-9);
    const ref::Machine inches = ref::read_machine_text(
        "[TRAJ]\nLINEAR_UNITS = inch\n[KINS]\nKINEMATICS = scarakins\nD1 = 9\nD2 = 10\nD3 = 0\nD4 "
        "= 8\nD5 = 0\n"
        "[JOINT_0]\nMAX_VELOCITY = 90\n[JOINT_2]\nMAX_VELOCITY = 2\n",
        "inch.ini");
    EXPECT_DOUBLE_EQ(std::get<ref::Scara>(inches.kinematics).outer, 8 * 25.4);
    EXPECT_EQ(std::get<ref::Scara>(inches.kinematics).elbow, 1);
    EXPECT_EQ(inches.axis[0].velocity, 90);  // degrees
    EXPECT_DOUBLE_EQ(inches.axis[2].velocity, 2 * 25.4);
    for (const char* name : {"trivkins coordinates=xyz", "gentrivkins", "gantrykins"}) {
        const ref::Machine plain = ref::read_machine_text(
            std::string("[KINS]\nKINEMATICS = ") + name + "\n[TRAJ]\n", "plain.ini");
        EXPECT_TRUE(ref::is_trivial(plain.kinematics)) << name;
    }
}

TEST(Kinematics, AxesBesideTheJointsHaveLimitsOfTheirOwn) {
    const ref::Machine machine = ref::read_machine_text(
        "[KINS]\nKINEMATICS = xyzac-trt-kins\n[TRAJ]\nCOORDINATES = XYZAC\n"
        "MAX_LINEAR_VELOCITY = 9\n[AXIS_A]\nMAX_VELOCITY = 3\nMAX_LIMIT = 2\nMIN_LIMIT = -2\n"
        "[JOINT_3]\nMAX_VELOCITY = 5\n[JOINT_4]\nMAX_VELOCITY = 7\n[AXIS_X]\nMAX_LIMIT = 4\n",
        "trt.ini");
    EXPECT_EQ(machine.axis[3].velocity, 3);
    EXPECT_EQ(machine.axis[3].max, 2);
    EXPECT_EQ(machine.axis[5].velocity, 7);
    EXPECT_EQ(machine.tool[0].max, 4);
    EXPECT_EQ(machine.tool[1].max, ref::kUnlimitedTravel);
    EXPECT_EQ(machine.axis[0].max, ref::Machine().axis[0].max);  // no [JOINT_0]
}

TEST(Kinematics, NoneOrHalfOfAMachineIsRefused) {
    EXPECT_PRED2(says, refusal("[KINS]\nKINEMATICS = genhexkins\n[TRAJ]\n"),
                 "robot.ini:2: error: KINEMATICS = genhexkins: one of trivkins, ");
    EXPECT_PRED2(says, refusal("[KINS]\nKINEMATICS = lineardeltakins\nR = 100\n[TRAJ]\n"),
                 "robot.ini:2: error: lineardeltakins needs L in [KINS]");
    EXPECT_PRED2(says, refusal("[KINS]\nKINEMATICS = lineardeltakins\nL = 0\nR = 1\n[TRAJ]\n"),
                 "robot.ini:3: error: L = 0: a length above 0");
    const std::string scara =
        "[KINS]\nKINEMATICS = scarakins\nD1 = 1\nD2 = 1\nD3 = 1\nD4 = 1\nD5 = 1\n";
    EXPECT_EQ(refusal(scara + "[TRAJ]\n"), "");
    EXPECT_PRED2(says, refusal(scara + "ELBOW = 2\n[TRAJ]\n"),
                 "robot.ini:8: error: ELBOW = 2: the sign of joint 1");
    EXPECT_PRED2(says, refusal(scara + "D6 = 50\n[TRAJ]\n"),
                 "robot.ini:8: error: scarakins takes no D6 here");
    EXPECT_PRED2(says, refusal("[KINS]\nKINEMATICS = scarakins\nD2 = 1\n[TRAJ]\n"),
                 "robot.ini:2: error: scarakins needs D1 in [KINS]");
    EXPECT_PRED2(says, refusal("[KINS]\nKINEMATICS = xyzac-trt-kins sparm=identityfirst\n[TRAJ]\n"),
                 "robot.ini:2: error: KINEMATICS = xyzac-trt-kins sparm=identityfirst: without");
    EXPECT_PRED2(says, refusal("[KINS]\nKINEMATICS = rosekins\nJOINT_RATIO = 0.5\n[TRAJ]\n"),
                 "robot.ini:3: error: JOINT_RATIO = 0.5: 1.9 .. 1000");
}

}  // namespace curvecore::tb::kinematics_test
