// SPDX-License-Identifier: Apache-2.0
// Wishes of a person at the machine.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>

namespace curvecore::sysc {

struct Wish {
    enum class Kind { kHold, kResume, kOverride, kStop, kEstop };
    Kind kind;
    int percent = 0;  // for kOverride
};

/// Returns the wish of a text: hold, resume, override N (1..200), stop, estop.
std::optional<Wish> wish_of(const std::string& text);

/// Wishes that wait, from any thread. Of a kind only the last one waits, so that a storm of them
/// neither grows nor delays what comes behind it; an e-stop passes all others.
class WishQueue {
  public:
    void push(const Wish& wish);
    std::optional<Wish> next();

  private:
    std::mutex mutex_;
    std::deque<Wish> wishes_;
};

}  // namespace curvecore::sysc
