// SPDX-License-Identifier: Apache-2.0
// Points to draw a path by, thinned out as they become many.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "ref/curve/vec3.hpp"

namespace curvecore::sysc {

struct ShownPoint {
    ref::Vec3 place;
    double path;   // from the path's begin
    int line = 0;  // of the program
};

class ShownPoints {
  public:
    bool empty() const { return points_.empty(); }

    /// Adds the point that `make` makes; some that need not be `kept` are left out, and not made.
    template <class Make>
    void add(const Make& make, bool kept = false) {
        if (++made_ % every_ == 0 || kept) points_.push_back(make());
        if (points_.size() > kMost) thin();
    }

    /// Forgets all points.
    void clear() {
        points_.clear();
        every_ = 1;
        made_ = 0;
        ++thinned_;
    }

    /// Returns the points from a number on: {"thinned":..,"points":[[x,y,z,path,line],..]}. Thinned
    /// out or forgotten, they are numbered anew.
    std::string json(std::size_t from) const {
        std::string text = fmt::format(R"({{"thinned":{},"points":[)", thinned_);
        const char* comma = "";
        for (std::size_t n = from; n < points_.size(); ++n) {
            const ShownPoint& point = points_[n];
            fmt::format_to(std::back_inserter(text), "{}[{:.7g},{:.7g},{:.7g},{:.8g},{}]", comma,
                           point.place[0], point.place[1], point.place[2], point.path, point.line);
            comma = ",";
        }
        return text + "]}";
    }

  private:
    static constexpr std::size_t kMost = 20'000;

    /// Keeps every second point.
    void thin() {
        std::size_t kept = 0;
        for (std::size_t n = 0; n < points_.size(); n += 2) points_[kept++] = points_[n];
        points_.resize(kept);
        every_ *= 2;
        ++thinned_;
    }

    std::vector<ShownPoint> points_;
    std::size_t every_ = 1;  // of the points made one is kept
    std::size_t made_ = 0;
    int thinned_ = 0;
};

}  // namespace curvecore::sysc
