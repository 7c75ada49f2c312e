// SPDX-License-Identifier: Apache-2.0
// The planned path as a person sees it: what is at a place of it, and points to draw it by. One
// thread adds parts while others ask.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

#include "ref/machine/machine.hpp"
#include "ref/plan/segment.hpp"
#include "sysc/panel/shown_points.hpp"

namespace curvecore::sysc {

struct PathPlace {
    int line = 0;          // of the program
    double time_s = 0;     // at the rate 1, from the program's start
    double feed_mm_s = 0;  // at the rate 1
};

class PlannedPath {
  public:
    /// @param begin of what is added, in quanta: what is before that is not known
    explicit PlannedPath(const ref::Machine& machine = {}, std::uint64_t begin = 0)
        : machine_(machine), begin_(begin), path_(begin) {}

    void add(const ref::Plan& part);
    /// Forgets what is before a place, in quanta: it is drawn.
    void pass(std::uint64_t path);

    /// Returns what is at a place, in quanta, which is not before one that was passed.
    PathPlace at(std::uint64_t path);
    /// Returns true if the program rests at a place, which is not before one that was passed.
    bool rests_at(std::uint64_t path);
    /// Planned so far.
    double time_s() const;
    double length_mm() const;

    /// Returns the points of the tool from a number on, mm, as ShownPoints::json does.
    std::string json(std::size_t from) const;

  private:
    struct Stretch {  // of a segment
        std::uint64_t end;
        int line;
    };
    struct Piece {
        std::uint64_t begin;
        double time_s;
        ref::ProfilePiece piece;
    };

    void add(const ref::Segment& segment, double unit_mm);
    void forget(std::uint64_t path);

    ref::Machine machine_;
    mutable std::mutex mutex_;
    std::deque<Stretch> stretches_;  // those before the place that was passed are gone
    std::deque<Piece> pieces_;
    std::deque<std::uint64_t> rests_;  // places
    std::uint64_t begin_;
    std::uint64_t path_;
    double time_s_ = 0;
    double tick_s_ = 0;
    double quantum_mm_ = 0;
    ShownPoints points_;
};

}  // namespace curvecore::sysc
