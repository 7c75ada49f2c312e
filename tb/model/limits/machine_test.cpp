// SPDX-License-Identifier: Apache-2.0
// LinuxCNC's machine files: units, axes and joints, and reported defaults.
#include "ref/machine/machine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace curvecore::tb::machine_test {

using ref::Machine;

Machine read(const std::string& text) { return ref::read_machine_text(text, "mill.ini"); }

bool says(const Machine& machine, const std::string& note) {
    return std::find(machine.notes.begin(), machine.notes.end(), note) != machine.notes.end();
}

TEST(MachineFile, GivesTheLimitsOfPathAndAxes) {
    const Machine machine = ref::read_machine(std::string(DATA_DIR) + "/example_machine.ini");
    EXPECT_EQ(machine.name, "example_machine.ini");
    EXPECT_EQ(machine.velocity, 200);
    EXPECT_EQ(machine.acceleration, 2000);
    EXPECT_EQ(machine.jerk, 50000);
    EXPECT_EQ(machine.joint_time, 1e-3);
    EXPECT_EQ(machine.axis[0].velocity, 150);
    EXPECT_EQ(machine.axis[1].acceleration, 1500);
    EXPECT_EQ(machine.axis[2].jerk, 30000);
    EXPECT_EQ(machine.axis[1].min, -150);
    EXPECT_EQ(machine.axis[3].max, 7200);
}

TEST(MachineFile, TighterOfAxisAndJointHolds) {
    const Machine machine = ref::read_machine(std::string(DATA_DIR) + "/example_machine.ini");
    EXPECT_EQ(machine.axis[2].velocity, 75);
    const Machine gantry = read(
        "[TRAJ]\nCOORDINATES = X Y Y Z\n[AXIS_Y]\nMAX_VELOCITY = 90\nMIN_LIMIT = -50\n"
        "[JOINT_1]\nMAX_VELOCITY = 80\nMAX_LIMIT = 60\n"
        "[JOINT_2]\nMAX_VELOCITY = 70\nMIN_LIMIT = -40\n[JOINT_3]\nMAX_VELOCITY = 20\n");
    EXPECT_EQ(gantry.axis[1].velocity, 70);
    EXPECT_EQ(gantry.axis[1].min, -40);
    EXPECT_EQ(gantry.axis[1].max, 60);
    EXPECT_EQ(gantry.axis[2].velocity, 20);
}

TEST(MachineFile, AnAxisOfAnglesWithoutLimitsIsRotary) {
    const auto rotary = [](const std::string& axis) {
        const Machine machine = read("[TRAJ]\nCOORDINATES = X A\n" + axis);
        return machine.axis[3].rotary;
    };
    EXPECT_TRUE(rotary("[JOINT_1]\nTYPE = ANGULAR\nMAX_VELOCITY = 90\n"));
    EXPECT_FALSE(rotary("[JOINT_1]\nTYPE = ANGULAR\nMIN_LIMIT = -120\nMAX_LIMIT = 120\n"));
    EXPECT_FALSE(rotary("[JOINT_1]\nTYPE = LINEAR\nMAX_VELOCITY = 90\n"));
    EXPECT_TRUE(rotary("[AXIS_A]\nWRAPPED_ROTARY = 1\nMIN_LIMIT = 0\nMAX_LIMIT = 360\n"));
    EXPECT_FALSE(rotary("[AXIS_A]\nWRAPPED_ROTARY = 0\nMAX_VELOCITY = 90\n"));
    EXPECT_TRUE(Machine().axis[3].rotary);
    EXPECT_FALSE(Machine().axis[0].rotary);
    EXPECT_FALSE(Machine().axis[6].rotary);
}

TEST(MachineFile, InchFilesScaleLengthsButNotDegrees) {
    const Machine machine = read(
        "[TRAJ]\nLINEAR_UNITS = inch\nMAX_LINEAR_VELOCITY = 2\nJOINT_TIME = 0.002\n"
        "[AXIS_X]\nMAX_VELOCITY = 1\nMIN_LIMIT = -2\n[AXIS_B]\nMAX_VELOCITY = 90\n"
        "MAX_LIMIT = 360\n[AXIS_W]\nMAX_ACCELERATION = 10\n");
    EXPECT_EQ(machine.velocity, 50.8);
    EXPECT_EQ(machine.joint_time, 0.002);
    EXPECT_EQ(machine.axis[0].velocity, 25.4);
    EXPECT_EQ(machine.axis[0].min, -50.8);
    EXPECT_EQ(machine.axis[4].velocity, 90);
    EXPECT_EQ(machine.axis[4].max, 360);
    EXPECT_EQ(machine.axis[8].acceleration, 254);
}

TEST(MachineFile, WhatIsMissingIsSaid) {
    const Machine machine = read(
        "[TRAJ]\nLINEAR_UNITS = mm\n[AXIS_X]\nMAX_VELOCITY = 30\nMAX_ACCELERATION = 300\n"
        "[AXIS_Y]\nMAX_VELOCITY = 40\nMAX_ACCELERATION = 400\n");
    EXPECT_EQ(machine.axis[0].jerk, 6000);
    EXPECT_TRUE(says(machine, "X MAX_JERK: 6000"));
    EXPECT_EQ(machine.velocity, 50);
    EXPECT_TRUE(says(machine, "MAX_LINEAR_VELOCITY: 50, from the axes"));
    EXPECT_EQ(machine.acceleration, 500);
    EXPECT_TRUE(says(machine, "Z: the built-in machine's limits"));
    EXPECT_GE(machine.axis[0].max, 1e99);
    EXPECT_TRUE(says(read("[TRAJ]\n"), "LINEAR_UNITS: mm"));
}

TEST(MachineFile, WithoutAnyJerkThePathReachesItsAccelerationAsItsAxesDo) {
    const std::string limits =
        "[TRAJ]\nLINEAR_UNITS = mm\nCOORDINATES = X Y\nMAX_LINEAR_VELOCITY = 80\n"
        "MAX_LINEAR_ACCELERATION = 500\n[AXIS_X]\nMAX_ACCELERATION = 500\n";
    const Machine none = read(limits + "[AXIS_Y]\nMAX_ACCELERATION = 400\n");
    EXPECT_EQ(none.axis[0].jerk, 10000);
    EXPECT_EQ(none.axis[1].jerk, 8000);
    EXPECT_EQ(none.jerk, 10000);
    EXPECT_TRUE(says(none, "MAX_LINEAR_JERK: 10000, from the acceleration"));
    const Machine one = read(limits + "MAX_JERK = 30000\n[AXIS_Y]\nMAX_JERK = 40000\n");
    EXPECT_EQ(one.jerk, 50000);
    EXPECT_TRUE(says(one, "MAX_LINEAR_JERK: 50000, from the axes"));
}

TEST(MachineFile, OlderNamesAndFreeFormattingAreRead) {
    const Machine machine = read(
        "[traj]\r\n  max_velocity=+60.5 ; mm/s\r\nMAX_ACCELERATION\t= 6e2 # mm/s^2\r\n"
        "DISPLAY = axis \\\r\n  not a setting\r\n[ AXIS_1 ]\r\nMAX_VELOCITY = 20\r\n");
    EXPECT_EQ(machine.velocity, 60.5);
    EXPECT_EQ(machine.acceleration, 600);
    EXPECT_EQ(machine.axis[1].velocity, 20);
}

TEST(MachineFile, JointsOfOtherKinematicsAreNotTheToolsAxes) {
    const Machine machine = read(
        "[KINS]\nKINEMATICS = rosekins\n[TRAJ]\nMAX_LINEAR_VELOCITY = 9\n"
        "[JOINT_0]\nMAX_VELOCITY = 1\n[JOINT_2]\nMAX_VELOCITY = 3\n[AXIS_X]\nMAX_VELOCITY = 5\n");
    EXPECT_EQ(machine.axis[0].velocity, 1);
    EXPECT_EQ(machine.axis[2].velocity, 3);
    EXPECT_EQ(machine.tool[0].velocity, 5);
    EXPECT_EQ(machine.of_tool().axis[0].velocity, 5);
    EXPECT_EQ(machine.of_tool().axis[3].velocity, machine.axis[3].velocity);
}

TEST(MachineFile, SameLimitTwiceIsHarmlessIfEqual) {
    EXPECT_EQ(read("[TRAJ]\nMAX_LINEAR_VELOCITY = 5\nMAX_LINEAR_VELOCITY = 5\n").velocity, 5);
}

}  // namespace curvecore::tb::machine_test
