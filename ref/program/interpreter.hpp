// SPDX-License-Identifier: Apache-2.0
// What the blocks of a program mean, one after the other: modal state in, moves out.
//
// A block is carried out in RS274/NGC's order: feed, spindle and tool, dwell, modes, offsets,
// motion, stop. One difference: an F word is read in the units of its own block (G20 F10 is
// 10 inches a minute). The machine starts at 0 on all axes with G17 G21 G40 G49 G54 G64 G90 G91.1
// G94 and no motion mode.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "ref/program/arc_geometry.hpp"
#include "ref/program/codes.hpp"
#include "ref/program/coordinates.hpp"
#include "ref/program/move.hpp"

namespace curvecore::ref {

class Interpreter {
  public:
    explicit Interpreter(const std::string& file) { program_.file = file; }

    /// Carries out a block; false when it ends the program. @throws InputError
    bool execute(Block block, const Place& place);
    /// The whole program. @throws InputError when it has no moves or an arc lacks its end point.
    Program finish();

  private:
    void set_feed(Block& block, const Codes& codes, const Place& place);
    void use_spindle_and_tool(Block& block, const Codes& codes, const Place& place);
    void set_modes(Block& block, const Codes& codes, const Place& place);
    static double use_p(Block& block, const Place& place);
    void dwell(Block& block, const Place& place);
    void set_offsets(int action, Block& block, const Codes& codes, const Place& place);
    void move(Block& block, const Codes& codes, const Place& place);
    void arc(Block& block, const Place& place);
    Eigen::Vector2d plane_centre(Block& block, const Eigen::Vector2d& start,
                                 const Place& place) const;
    void space_arc(Block& block, const Codes& codes, const Place& place);
    void check_no_arc_waits(const Place& place) const;

    Move move_to(const Point& target, const Place& place) const;
    void add(Move move, const Point& target, const Place& place);
    double feed_of(const Move& move, const Place& place) const;
    void stop();
    void warn(const std::string& text, const Place& place);

    /// A point that a G2.4 arc goes through, waiting for the block with its end point.
    struct Middle {
        Point start;
        Vec3 point;
        int line;
        std::optional<double> feed;  // F of that block, for G93
    };

    struct Warning {
        int line;
        int count;
    };

    Program program_;
    Coordinates coordinates_;
    int motion_ = 800;  // G code in tenths
    int normal_axis_ = 2;
    bool absolute_centre_ = false;
    bool exact_stop_ = false;
    bool inverse_time_ = false;
    std::optional<double> feed_;  // F as written: per minute, of degrees or ..
    double feed_unit_ = 1;        // .. of this many mm
    std::optional<Middle> middle_;
    std::map<std::string, Warning> warnings_;
};

}  // namespace curvecore::ref
