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

    /// An event with its code by name.
    struct Named {
        std::string code;
        int line;
        double value;
        double length;
        bool rested;
    };

    void add(const Named& event) {
        auto known = std::find(codes_.begin(), codes_.end(), event.code);
        if (known == codes_.end()) known = codes_.insert(known, event.code);
        list_.push_back({event.line, static_cast<int>(known - codes_.begin()), event.value,
                         event.length, event.rested});
    }

    const std::vector<Event>& list() const { return list_; }
    const std::vector<std::string>& codes() const { return codes_; }
    const std::string& code_of(const Event& event) const { return codes_.at(event.code); }

  private:
    std::vector<std::string> codes_;
    std::vector<Event> list_;
};

}  // namespace curvecore::ref
