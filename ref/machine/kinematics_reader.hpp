// SPDX-License-Identifier: Apache-2.0
// A machine's kinematics from LinuxCNC's .ini.
#pragma once

#include "ref/machine/ini_file.hpp"
#include "ref/machine/kinematics.hpp"

namespace curvecore::ref {

/// Reads [KINS] KINEMATICS: the name of LinuxCNC's module; and the module's parameters, which
/// LinuxCNC has as HAL pins, by their names in capitals: R and L of lineardeltakins, D1 .. of
/// scarakins, X_ROT_POINT .. of xyzac-trt-kins. Lengths in the file's unit, `unit` mm. Without the
/// section, and of modules that do no more: trivial.
/// @throws InputError: another module; a parameter that is missing, or no length
Kinematics read_kinematics(const IniFile& ini, double unit);

/// Largest rate of a joint, [KINS] JOINT_RATIO. @throws InputError
double read_joint_ratio(const IniFile& ini, double otherwise);

}  // namespace curvecore::ref
