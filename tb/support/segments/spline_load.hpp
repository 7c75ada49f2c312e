// SPDX-License-Identifier: Apache-2.0
// Positions in the word that loads the spline network, as in rtl/network/spline_pkg.sv.
#pragma once

namespace curvecore::tb::load {

constexpr int kSixA = 0;  // first of X Y Z, here and where three follow
constexpr int kV = 3;
constexpr int kW = 6;
constexpr int kPhi = 9;
constexpr int kQ = 10;
constexpr int kR = 11;
constexpr int kAgain = 12;

}  // namespace curvecore::tb::load
