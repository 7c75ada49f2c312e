// SPDX-License-Identifier: Apache-2.0
// Requests of a program besides motion, such as M3, with their places.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace curvecore::ref {

/// Largest distance of lengths that are the same place.
constexpr double kSamePlace = 1e-9;  // mm
/// Least distance of an event before the place from which a program is drawn, if it has passed.
constexpr double kLeftOut = 1e-6;  // mm

/// Codes besides motion that are obeyed.
struct Obeyed {
    bool outputs = false;  // those that switch outputs (ref/outputs/output_course.hpp)
    bool waits = false;    // those that wait for a person (ref/outputs/placed_waits.hpp)
    bool analog = false;   // M67 and M68 E0 set the level of outputs, not S
};

class Events {
  public:
    /// | field  | unit | remark                                                              |
    /// |--------|------|---------------------------------------------------------------------|
    /// | line   |      | in the program's file                                               |
    /// | code   |      | index into codes(), such as M3; M67 E1, but M67 for E0              |
    /// | value  |      | number of S and T, P or Q of outputs; else 0                        |
    /// | length | mm   | of all moves before it, as Move::length()                           |
    /// | rest   | s    | of dwells between the last move and it                              |
    /// | waits  |      | the program waits there for a person                                |
    struct Event {
        int line;
        int code;
        double value;
        double length;
        double rest;
        bool waits;
    };

    /// Adds an event, whose code is named.
    void add(const std::string& code, Event event) {
        auto known = std::find(codes_.begin(), codes_.end(), code);
        if (known == codes_.end()) known = codes_.insert(known, code);
        event.code = static_cast<int>(known - codes_.begin());
        list_.push_back(event);
    }

    const std::vector<Event>& list() const { return list_; }
    const std::vector<std::string>& codes() const { return codes_; }
    const std::string& code_of(const Event& event) const { return codes_.at(event.code); }

  private:
    std::vector<std::string> codes_;
    std::vector<Event> list_;
};

}  // namespace curvecore::ref
