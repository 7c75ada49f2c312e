// SPDX-License-Identifier: Apache-2.0
// Homing: drives axes to their switches, one after the other, until their places are known.
//
//   switch      ______|^^^^^^^^      closed at the end of the travel
//   off it        <-----             if it is closed at the beginning
//   search        -------->          fast; the board holds where it closes
//   back          <-------           until it opens
//   latch           -->              slowly; HOME_OFFSET is where it closes
//   home      <-------
//
// Each is a separate line, planned as any program is; the board notes the steps at the edge.
#pragma once

#include <functional>
#include <stdexcept>

#include "sysc/home/home_settings.hpp"
#include "sysc/job/options.hpp"
#include "sysc/wire/wire_stream.hpp"

namespace curvecore::sysc {

/// An axis cannot be homed; what() gives the reason.
class HomingError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The operator ended the homing; the machine stands.
class HomingStopped : public std::runtime_error {
  public:
    HomingStopped() : std::runtime_error("stopped") {}
};

class Homing {
  public:
    /// Creates the homing; `options` are those of a program for this machine, which is prepared.
    /// `turn` is called repeatedly.
    Homing(RemoteMachine& machine, const Options& options, const Drives& drives,
           int watchdog_samples, WishQueue& wishes, std::function<void()> turn);

    /// Returns the steps of the axis at its switch.
    /// @throws HomingError, HomingStopped, BoardLost, what `turn` throws
    std::int32_t home(const AxisHome& axis);

  private:
    enum class Until { kEnd, kClosed, kOpen };

    bool drive(int axis, double way_mm, double speed, Until until);
    void seek(const AxisHome& axis, double speed, double reach_mm, Until until);
    ref::Program line(int axis, double way_mm, double speed) const;

    RemoteMachine& machine_;
    const Options& options_;
    const Drives& drives_;
    int watchdog_samples_;
    WishQueue& wishes_;
    std::function<void()> turn_;
};

}  // namespace curvecore::sysc
