// SPDX-License-Identifier: Apache-2.0
// A curve's table (ref/curves/curve_table.hpp) as steps of the engine, for a core's parameters.
//
// A product is rounded at 2^45, so for a shift of s its factors are lifted by 2^(45 - s) together:
// the copies that this takes are made where they are read most, those of a segment's words at its
// load. Sums of products stand in a wide word and are shifted once. What is read of no step is made
// at load, too: weights, and the angle's series of an arc. Words of data are scarcer than clocks:
// weights have their sign where they are read, orders over i are made anew behind the last one, and
// a sum of `next` is made there if no sample reads its series.
#pragma once

#include "ref/curves/curve_table.hpp"
#include "ref/format/parameters.hpp"
#include "rtl/engine/compiler/curve_code.hpp"

namespace curvecore::assembler {

/// Values that the steps take from their segment, besides those of the bus. All but the last are
/// words by the names beside them.
namespace scale_word {
constexpr char kToTau[] = "2^(27-k)";               // tau_scale
constexpr char kToFine[] = "2^(fine+k)";            // fine_scale
constexpr char kPlaceToFine[] = "2^(fine+lambda)";  // place_scale
constexpr char kDown[] = "2^(44-s)";                // step_scale
constexpr char kDownTwice[] = "2^(44-2s)";
}  // namespace scale_word

/// Values of places, which no row of a table is: no name of a row has a space.
namespace place_word {
constexpr char kStart[] = "start[k] of the segment";  // start[k]
constexpr char kOrigin[] = "origin[k] of the step";   // origin[k]
constexpr char kFine[] = "fine[k] of the sample";     // fine[k]
constexpr char kSigma[] = "sigma of the sample";      // sigma
}  // namespace place_word

/// Scale of a displacement to a fine position: lifted by 2^lift, times the word 2^(fine + k), over
/// 2^45.
struct FineScale {
    int lift;
    int fine;
};
FineScale fine_scale(const ref::CoreParameters& core);

/// @throws AssemblyError with file, line and reason
CurveCode lower(const ref::CurveTable& table, const ref::CoreParameters& core);

}  // namespace curvecore::assembler
