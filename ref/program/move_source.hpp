// SPDX-License-Identifier: Apache-2.0
// A program's moves one after the other, from wherever they come.
#pragma once

#include <functional>

#include "ref/program/move.hpp"

namespace curvecore::ref {

/// Gives the next move; false: there is none, and none will come. @throws InputError
using MoveSource = std::function<bool(Move& move)>;

/// Those of a program, which must outlive the source.
inline MoveSource source_of(const Program& program) {
    return [&program, next = std::size_t(0)](Move& move) mutable {
        if (next == program.moves.size()) return false;
        move = program.moves[next++];
        return true;
    };
}

/// All that a stream has to give: GcodeStream, ProgramStream. @throws InputError
template <class Stream>
Program read_all(Stream& stream, const std::string& file) {
    Program program;
    program.file = file;
    for (Move move; stream.next(move);) program.moves.push_back(move);
    program.aux_axes = stream.aux_axes();
    program.warnings = stream.warnings();
    return program;
}

}  // namespace curvecore::ref
