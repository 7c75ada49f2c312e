// SPDX-License-Identifier: Apache-2.0
// Pieces of a cubic that a core can draw.
#pragma once

#include <vector>

#include "ref/bound/error_bound.hpp"
#include "ref/curve/cubic.hpp"
#include "ref/plan/segment.hpp"
#include "ref/segment/spline_cut.hpp"

namespace curvecore::ref {

/// Scales a cubic of 0 <= u <= 1, in length units, for a core: v = beta u, lengths over 2^lambda.
///
///     beta = max |dr/du| / 2^lambda (a little more, so that |V| < 1)       lambda >= 0, least
///
/// | field    | set here                                                  |
/// |----------|-----------------------------------------------------------|
/// | curve    | SplinePiece; beta is v of the end, below 1                |
/// | start    | r(0), units                                               |
/// | end      | r(1), units                                               |
/// | length   | path quanta, rounded; a chain of pieces corrects its sums |
///
/// Errors: roundings of double, the length's 1e-13. Source: theory of [Chikurov] (30), trap D2.
Segment spline_segment(const Cubic& piece, const CoreParameters& format);

/// Finds the longest step exponent with which every word keeps its range and the derived bound
/// stays within the limit, and within half of it along the path (two samples' distance keeps the
/// limit); sets step_exponent and bound. Returns false, with the segment unchanged, if there is
/// none.
bool choose_step(const CoreParameters& format, double limit, Segment& segment);

/// Places the pieces of a cubic that begins at `path`, program-wide and in units, moved to its end:
/// a piece's length is the difference of two rounded sums.
std::vector<Segment> placed(SplineCut cut, long double& path);

/// Cuts a cubic in halves of u until each fits and keeps the limit. Tips of a few units' radius,
/// and cusps, are drawn by lines of a few units.
///
/// `path` is that of placed(). Auxiliary axes share the bound.
/// @throws std::domain_error when halving does not help, the limit is below four half guard bits,
///         or the pieces are more than max_pieces
std::vector<Segment> split_spline(const Cubic& cubic, const CoreParameters& format, double limit,
                                  long double& path, const Aux& aux_advance = {},
                                  int max_pieces = 1 << 16);

/// Cuts the same cubic from s_start (quanta) on.
std::vector<Segment> split_spline(const Cubic& cubic, const CoreParameters& format, double limit,
                                  std::uint64_t s_start = 0);

}  // namespace curvecore::ref
