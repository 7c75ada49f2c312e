// SPDX-License-Identifier: Apache-2.0
// Which G and M codes there are, which exclude each other, and why the others are refused.
#pragma once

#include <array>
#include <optional>

#include "ref/program/block.hpp"

namespace curvecore::ref {

/// Modal groups of RS274/NGC: one code of each at most in a block.
enum class Group {
    kAction,  // G4 G10 G53 G92.x: not modal, yet one at most
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
    kToolChange,
    kSpindle,
    kCoolant,
    kOverride,
    kCount
};

/// The codes of a block by group (G codes in tenths).
class Codes {
  public:
    /// @throws InputError for unknown and unsupported codes and for two of a group.
    Codes(const Block& block, const Place& place);

    std::optional<int> of(Group group) const { return code_[static_cast<int>(group)]; }

  private:
    void add(Group group, int code, char letter, const Place& place);

    std::array<std::optional<int>, static_cast<int>(Group::kCount)> code_;
};

}  // namespace curvecore::ref
