// SPDX-License-Identifier: Apache-2.0
// The known G and M codes, their modal groups, and the reasons why others are refused.
#pragma once

#include <array>
#include <optional>

#include "ref/gcode/blocks/block.hpp"

namespace curvecore::ref {

/// Modal groups of RS274/NGC: at most one code of each in a block, except coolants and the
/// machine's own codes; G80 yields to any other motion code.
enum class Group {
    kAction,  // G4 G10 G28 G30 G52 G53 G92.x: not modal, yet one at most
    kMotion,
    kPlane,
    kDistance,
    kArcDistance,
    kFeedMode,
    kUnits,
    kCompensation,
    kToolLength,
    kReturn,
    kSystem,
    kPathControl,
    kSpindleMode,
    kDiameter,
    kStop,  // M0 M1 M2 M30 M60
    kOutput,
    kToolChange,
    kSpindle,
    kCoolant,
    kOverride,
    kOwn,  // M100 .. M199 and unknown codes
    kCount
};

constexpr int kNoMotion = 800;  // G80

/// The codes of a block by group (G codes in tenths).
class Codes {
  public:
    /// @throws InputError for unknown and unsupported G codes and for two of a group
    Codes(const Block& block, const Place& place);

    /// Returns true if LinuxCNC knows the M code.
    static bool known(int m_code);
    std::optional<int> of(Group group) const { return code_[static_cast<int>(group)]; }

  private:
    void add(Group group, int code, char letter, const Place& place);

    std::array<std::optional<int>, static_cast<int>(Group::kCount)> code_;
};

}  // namespace curvecore::ref
