// SPDX-License-Identifier: Apache-2.0
// A program's moves one after the other, from wherever they come.
#pragma once

#include <functional>

#include "ref/program/move.hpp"

namespace curvecore::ref {

/// Gives the next move; false: there is none, and none will come. @throws InputError
using MoveSource = std::function<bool(Move& move)>;

}  // namespace curvecore::ref
