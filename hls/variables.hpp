// SPDX-License-Identifier: Apache-2.0
// The variables of both networks, for observers of their words.
#pragma once

#include "hls/storage.hpp"

namespace curvecore {
namespace hls {
inline namespace CURVECORE_STORAGE {

constexpr int kMostOrder = 12;  // largest of any configuration

enum class Variable {
    kWeight,     // arcs: theta / i
    kNormal,     // n and its series N
    kTangent,    // t and its series T
    kMove,       // displacement's series, with the advance
    kSine,       // of the angle, polynomial mode
    kVersine,    //
    kParameter,  // splines: v, the state between steps
    kStepA,      // a', 6a'
    kSixA,       //
    kSlope,      // 0 B, 1 M
    kNorm,       // V.V
    kQ,          // q = v in the step
    kW,          //
    kDV,         //
    kV,          //
    kDP,         //
    kDphi,       //
    kPhi,        //
    kS,          //
    kBigQ,       // Q
    kR,          //
    kX,          // series mode
    kCount
};

}  // namespace CURVECORE_STORAGE
}  // namespace hls
}  // namespace curvecore
