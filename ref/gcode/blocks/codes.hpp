// SPDX-License-Identifier: Apache-2.0
// Which G and M codes there are, which exclude each other, and why the others are refused.
#pragma once

#include <array>
#include <optional>

#include "ref/gcode/blocks/block.hpp"

namespace curvecore::ref {

/// Modal groups of RS274/NGC: one code of each at most in a block, but for coolants and codes of
/// the machine's own; G80 gives way to any other motion code.
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
    kOwn,  // M100 .. M199 and what nobody knows
    kCount
};

constexpr int kNoMotion = 800;  // G80

/// The codes of a block by group (G codes in tenths).
class Codes {
  public:
    /// @throws InputError for unknown and unsupported G codes and for two of a group.
    Codes(const Block& block, const Place& place);

    /// Whether LinuxCNC knows the M code.
    static bool known(int m_code);
    std::optional<int> of(Group group) const { return code_[static_cast<int>(group)]; }

  private:
    void add(Group group, int code, char letter, const Place& place);

    std::array<std::optional<int>, static_cast<int>(Group::kCount)> code_;
};

}  // namespace curvecore::ref
