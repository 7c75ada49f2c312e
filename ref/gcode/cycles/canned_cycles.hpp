// SPDX-License-Identifier: Apache-2.0
// Canned cycles: G73 G74 G81 .. G89, in steps, as LinuxCNC executes them.
//
// The sequence at each of L places in the plane: a rapid over the place and down to R, the cycle
// down to the depth, and up to where the first of a row of cycles began (G98) or to R (G99),
// whichever is higher. With G91 the depth counts from R, R from that height, and the words move on
// the place. R, depth, P, Q, I, J and K hold for later blocks of the same code.
#pragma once

#include <array>
#include <optional>

#include "ref/gcode/cycles/cycle_step.hpp"
#include "ref/gcode/state/modes.hpp"

namespace curvecore::ref {

inline bool is_canned_cycle(int g_code) {
    return g_code == 730 || g_code == 740 || (g_code >= 810 && g_code <= 890);
}

class CannedCycles {
  public:
    /// @param again true if this code has been in force since its last block
    /// @throws InputError before anything is executed
    void carry_out(int g_code, bool again, Block& block, const Coordinates& coordinates,
                   const Modes& modes, const Place& place, const CarryOut& carry_out);
    /// Ends a row at another motion: the next cycle begins a new one.
    void end_row() { initial_.reset(); }

  private:
    struct Drill;

    void keep_words(int g_code, bool again, Block& block, const Coordinates& coordinates,
                    const Modes& modes, const Place& place);

    double r_ = 0;                    // mm, as given
    double depth_ = 0;                // mm, as given
    double p_ = 0;                    // s
    double q_ = 0;                    // mm
    std::array<double, 3> offset_{};  // I J K, mm
    double clearance_ = 0;            // mm, between a peck and the rapid back to it
    std::optional<double> initial_;   // height at the start of the row
};

}  // namespace curvecore::ref
