// SPDX-License-Identifier: Apache-2.0
// Encoders of a machine at a board that watches them: how far its axes may be from their steps'
// place. Names are LinuxCNC's, in its .ini.
#pragma once

#include <string>
#include <vector>

#include "sysc/wire/remote_machine.hpp"

namespace curvecore::sysc {

/// | field         | name in [JOINT_n]           | remark                                        |
/// |---------------|-----------------------------|-----------------------------------------------|
/// | counts_per_mm | ENCODER_SCALE, edges a unit | negative: it counts backwards                 |
/// | limit_mm      | FERROR                      | the board stops beyond it, at any speed       |
/// | rest_mm       | MIN_FERROR                  | at the end of a program; FERROR when missing  |
struct AxisEncoder {
    int axis = 0;
    std::string joint;  // name of its section
    int line = 0;       // line of ENCODER_SCALE
    double counts_per_mm = 0;
    double limit_mm = 0;
    double rest_mm = 0;
};

/// Reads the axes of a machine that have an encoder.
/// @throws ref::InputError
std::vector<AxisEncoder> read_encoders(const std::string& machine_file);

/// Returns the edges and steps of the same distance, as exactly as a board can represent the ratio.
/// @throws UsageError: there is no such ratio
EncoderRatio ratio_of(double counts_per_mm, double steps_per_mm);

/// Following error of an axis, mm.
struct Following {
    AxisEncoder encoder;
    double now_mm = 0;
    double worst_mm = 0;  // with its sign
};

class Encoders {
  public:
    /// Sets up the encoders of the machine's file, and no others; without a file none. Warns of
    /// encoders that have no inputs.
    /// @throws UsageError: an encoder that the board cannot support
    Encoders(RemoteMachine& machine, const std::string& machine_file, const Drives& drives);

    /// Returns the errors as they are.
    std::vector<Following> now() const;
    /// Returns the errors of a machine that has stopped, once it stands or after a while.
    std::vector<Following> following() const;
    /// Returns the axes that stand beyond their MIN_FERROR; empty: none.
    static std::string astray(const std::vector<Following>& axes);

  private:
    RemoteMachine& machine_;
    std::vector<AxisEncoder> encoders_;
    std::vector<double> units_per_mm_;  // scale of the board's errors
};

}  // namespace curvecore::sysc
