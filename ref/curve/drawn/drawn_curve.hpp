// SPDX-License-Identifier: Apache-2.0
// The kinds of curves that a core draws. Each is a struct with a name and an exact path; what
// depends on a kind besides is a function for each of them: its bound (ref/bound), its words (hls).
#pragma once

#include <array>
#include <variant>

#include "ref/curve/drawn/arc_piece.hpp"
#include "ref/curve/drawn/spline_piece.hpp"
#include "ref/curve/drawn/table_piece.hpp"
#include "ref/format/parameters.hpp"

namespace curvecore::ref {

using DrawnCurve = std::variant<ArcPiece, SplinePiece, TablePiece>;

/// The kinds in the order of DrawnCurve.
enum class CurveKind { kArc, kSpline, kTable };
constexpr std::array<CurveKind, std::variant_size_v<DrawnCurve>> kCurveKinds = {
    CurveKind::kArc, CurveKind::kSpline, CurveKind::kTable};

/// Returns true if a core of these parameters draws curves of this kind.
inline bool draws(const CoreParameters& core, CurveKind kind) {
    if (kind == CurveKind::kTable) return core.table != nullptr;
    return kind == CurveKind::kArc || core.splines != 0;
}

/// A value for each kind.
template <class T>
struct ByKind {
    std::array<T, kCurveKinds.size()> values{};

    T& operator[](CurveKind kind) { return values[static_cast<std::size_t>(kind)]; }
    const T& operator[](CurveKind kind) const { return values[static_cast<std::size_t>(kind)]; }
};

}  // namespace curvecore::ref
