// SPDX-License-Identifier: Apache-2.0
// The program moves_of PROGRAM FILE: writes our own reader's moves as chords: X Y Z A B C U V W and
// the difference of the radii at the arc's ends, ten doubles a vertex, in mm and degrees.
#include <cmath>
#include <cstdio>
#include <fstream>

#include "ref/moves/move_part.hpp"
#include "ref/program/program_reader.hpp"
#include "ref/text/input_error.hpp"

namespace {

using namespace curvecore::ref;

constexpr double kChordError = 1e-5;  // mm, of arcs
constexpr int kCubicChords = 60;

int chords_of(const Move& move) {
    if (move.kind == Move::Kind::kLine) return 1;
    if (move.kind == Move::Kind::kCubic) return kCubicChords;
    const double radius = (move.start - move.centre).norm();
    const double step = 2 * std::acos(std::max(0.5, 1 - kChordError / radius));
    return static_cast<int>(std::ceil(move.angle / step));
}

double mismatch_of(const Move& move) {
    if (move.kind != Move::Kind::kArc) return 0;
    return 4 * (move.advance - move.normal.dot(move.advance) * move.normal).norm();
}

class Vertices {
  public:
    explicit Vertices(const char* file) : file_(file, std::ios::binary) {}

    void add(const Vec3& place, const Aux& aux, double mismatch) {
        write(place.data(), 3);
        write(aux.data(), kAuxAxes);
        write(&mismatch, 1);
    }

  private:
    void write(const double* values, int count) {
        file_.write(reinterpret_cast<const char*>(values),
                    static_cast<std::streamsize>(count * sizeof(double)));
    }

    std::ofstream file_;
};

void write_moves(const char* program, const char* file) {
    const Program read = read_program(program, {});
    Vertices vertices(file);
    vertices.add(read.moves.front().start, read.moves.front().aux_start, 0);
    for (const Move& move : read.moves) {
        const int chords = chords_of(move);
        for (int i = 1; i <= chords; ++i) {
            const double part = static_cast<double>(i) / chords;
            Aux aux;
            for (int a = 0; a < kAuxAxes; ++a) {
                aux[a] = move.aux_start[a] + (move.aux_end[a] - move.aux_start[a]) * part;
            }
            vertices.add(i == chords ? move.end : place_on(move, move.length() * part).position,
                         aux, mismatch_of(move));
        }
    }
}

}  // namespace

int main(int count, char** argument) {
    if (count != 3) {
        std::fprintf(stderr, "moves_of PROGRAM FILE\n");
        return 2;
    }
    try {
        write_moves(argument[1], argument[2]);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
