// SPDX-License-Identifier: Apache-2.0
// A program's moves in order, from any source.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ref/moves/events.hpp"
#include "ref/moves/move.hpp"

namespace curvecore::ref {

enum class Dialect;  // ref/gcode/lines/dialect.hpp

/// Gives the next move; returns false if there is none, and none will come. @throws InputError
using MoveSource = std::function<bool(Move& move)>;

/// A program that is read move by move: GcodeStream, ProgramStream.
class MoveStream {
  public:
    MoveStream() = default;
    MoveStream(const MoveStream&) = delete;
    MoveStream& operator=(const MoveStream&) = delete;
    virtual ~MoveStream() = default;

    /// Gives the next move; returns false if there is none.
    /// @throws InputError for an invalid program, after all moves before the fault
    virtual bool next(Move& move) = 0;

    /// Dialect, if the program is G-code that this reader reads.
    virtual std::optional<Dialect> dialect() const { return {}; }

    /// Number of auxiliary axes, known at the end.
    virtual int aux_axes() const = 0;
    virtual const std::vector<std::string>& warnings() const = 0;
    /// Leaves codes that are obeyed out of the warnings; to be called at first.
    virtual void obey(const Obeyed& /*codes*/) {}
    /// Events that are read so far: those before a move are, when it is given.
    virtual const Events& events() const {
        static const Events kNone;
        return kNone;
    }
};

/// Makes a source of a program, which must outlive it.
inline MoveSource source_of(const Program& program) {
    return [&program, next = std::size_t(0)](Move& move) mutable {
        if (next == program.moves.size()) return false;
        move = program.moves[next++];
        return true;
    };
}

/// Reads all that a stream has. @throws InputError
inline Program read_all(MoveStream& stream, const std::string& file) {
    Program program;
    program.file = file;
    for (Move move; stream.next(move);) program.moves.push_back(move);
    program.aux_axes = stream.aux_axes();
    program.warnings = stream.warnings();
    return program;
}

}  // namespace curvecore::ref
