// SPDX-License-Identifier: Apache-2.0
// Requests of a program besides motion, such as M3, with their places.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace curvecore::ref {

class Events {
  public:
    /// | field  | unit | remark                                                              |
    /// |--------|------|---------------------------------------------------------------------|
    /// | line   |      | in the program's file                                               |
    /// | code   |      | index into codes()                                                  |
    /// | value  |      | number of S and T, P or Q of outputs; else 0                        |
    /// | length | mm   | of all moves before it, as Move::length()                           |
    /// | rested |      | a dwell is between the last move and it                             |
    struct Event {
        int line;
        int code;
        double value;
        double length;
        bool rested;
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
