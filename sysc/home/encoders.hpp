// SPDX-License-Identifier: Apache-2.0
// Encoders of a machine at a board that watches them: how far its axes may be from where their
// steps say. LinuxCNC's names, in its .ini.
#pragma once

#include <string>
#include <vector>

#include "sysc/wire/remote_machine.hpp"

namespace curvecore::sysc {

/// | field         | name in [JOINT_n]           | remark                                        |
/// |---------------|-----------------------------|-----------------------------------------------|
/// | counts_per_mm | ENCODER_SCALE, edges a unit | negative: it counts backwards                 |
/// | limit_mm      | FERROR                      | beyond it the board stops, at any speed       |
/// | rest_mm       | MIN_FERROR                  | for the end of a program; FERROR when missing |
struct AxisEncoder {
    int axis = 0;
    std::string joint;  // its section
    int line = 0;       // of ENCODER_SCALE
    double counts_per_mm = 0;
    double limit_mm = 0;
    double rest_mm = 0;
};

/// The axes of a machine that have an encoder.
/// @throws ref::InputError
std::vector<AxisEncoder> read_encoders(const std::string& machine_file);

/// Edges and steps that are the same way, as good as a board can have it.
/// @throws UsageError: there is none
EncoderRatio ratio_of(double counts_per_mm, double steps_per_mm);

/// How an axis follows, mm.
struct Following {
    AxisEncoder encoder;
    double now_mm = 0;
    double worst_mm = 0;  // with its sign
};

class Encoders {
  public:
    /// The board watches those of the machine's file, and no others; of no file: none. Warns of
    /// those that have no inputs.
    /// @throws UsageError: an encoder that the board cannot have
    Encoders(RemoteMachine& machine, const std::string& machine_file, const Drives& drives);

    /// Of a machine that has stopped: when it stands, or a while later.
    std::vector<Following> following() const;
    /// Axes that stand beyond their MIN_FERROR; empty: none.
    static std::string astray(const std::vector<Following>& axes);

  private:
    RemoteMachine& machine_;
    std::vector<AxisEncoder> encoders_;
    std::vector<double> units_per_mm_;  // of the board's errors
};

}  // namespace curvecore::sysc
