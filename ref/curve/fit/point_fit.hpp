// SPDX-License-Identifier: Apache-2.0
// Splines through points as cubics: the choice of parameter and of slopes.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "ref/curve/cubic.hpp"
#include "ref/curve/fit/cubic_fit.hpp"

namespace curvecore::ref {

/// | fit      | derivatives it reads                   | joints   | source                        |
/// |----------|----------------------------------------|----------|-------------------------------|
/// | bessel   | nothing                                | C1       | [Obukhov] (2)                 |
/// | akima    | nothing                                | C1       | Akima 1970                    |
/// | natural  | nothing                                | C2       |                               |
/// | clamped  | first derivative at both ends          | C2       |                               |
/// | hermite  | first derivatives (+)                  | C1       | [Petrakov] (2)                |
/// | moments  | second derivatives (+)                 | C0 (*)   | [Petrakov] (3)-(5), corrected |
/// | quintic  | first and second derivatives (+)       | G1, near C2 | [Petrakov], announced      |
/// | c2       | what `Ends` says, at both ends (+)     | C2       | [Petrakov] (3)-(5), solved    |
/// | arcs     | first derivatives (+)                  | G1       | [Chikurov], fit/arc_fit.hpp   |
///
/// (+) Where the points have none, [Petrakov] (1) takes the first derivatives from the positions,
/// and once more the second ones from the first.
/// (*) C2 if they are those of a C2 spline. The quintic is C2; what is drawn of it are cubics with
/// its tangents, within the tolerance. For arcs the cubics here are those of hermite.
enum class Fit { kBessel, kAkima, kNatural, kClamped, kHermite, kMoments, kQuintic, kC2, kArcs };
constexpr std::array<std::string_view, 9> kFitNames = {
    "bessel", "akima", "natural", "clamped", "hermite", "moments", "quintic", "c2", "arcs"};

/// End conditions of `c2`: no second derivative; the first or second derivatives of the points; the
/// start again, without a seam.
enum class Ends { kNatural, kSlope, kSecond, kClosed };
constexpr std::array<std::string_view, 4> kEndsNames = {"natural", "slope", "second", "closed"};

/// Step of the parameter from point to point: their distance, its square root, or 1. Derivatives
/// are by this parameter: with kChord a first derivative of length 1 is a unit tangent.
enum class Parametrisation { kChord, kCentripetal, kUniform };
constexpr std::array<std::string_view, 3> kParametrisationNames = {"chord", "centripetal",
                                                                   "uniform"};

struct FitPoint {
    Vec3 position = Vec3::Zero();
    std::optional<Vec3> d1;  // first derivative
    std::optional<Vec3> d2;  // second derivative
};

/// Points at which a fit reads a derivative, if they have any: none, both ends, all.
enum class Reads { kNothing, kEnds, kAll };
Reads reads_d1(Fit fit, Ends ends);
Reads reads_d2(Fit fit, Ends ends);

/// Parameters of the points, 0 at the first.
std::vector<double> parameters(const std::vector<FitPoint>& points,
                               Parametrisation parametrisation);

/// Fits a chain of cubics between every two neighbours: a single cubic, or for quintics the number
/// that the tolerance needs. At least two points, no two neighbours the same, with the derivatives
/// that the fit reads; a closed spline has at least four, the last of them the first again.
std::vector<std::vector<Cubic>> fit_points(const std::vector<FitPoint>& points, Fit fit,
                                           Parametrisation parametrisation,
                                           double tolerance = kFitTolerance,
                                           Ends ends = Ends::kNatural);

}  // namespace curvecore::ref
