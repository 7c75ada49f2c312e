// SPDX-License-Identifier: Apache-2.0
// The program of the serial build as two files in the given folder: serial_program_pkg.sv, the
// places of its parts, and serial_program.sv, the words. No word depends on Order, AuxAxes or
// CoefBits: the sequencer does.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "rtl/serial/spline_program.hpp"

namespace {

using curvecore::serial::Program;
using curvecore::serial::Word;

constexpr std::size_t kArcPlaces = 128;
constexpr std::size_t kPlaces = 256;

constexpr char kMade[] =
    "// SPDX-License-Identifier: Apache-2.0\n"
    "// {}, made by\n"
    "// rtl/serial/program_generator.cpp: do not edit.\n";

std::string entries(const Program& program, std::size_t first) {
    std::string text;
    for (const Program::Part& part : program.parts()) {
        text += fmt::format("  localparam logic [7:0] {}Entry = 8'd{};\n", part.name,
                            first + part.place);
    }
    return text;
}

std::string words(const Program& program, std::size_t first, std::size_t last, int indent) {
    std::string text;
    for (std::size_t place = first; place < last; ++place) {
        const std::size_t n = place - first;
        const Word word = n < program.words().size() ? program.words()[n] : Word{};
        text += fmt::format("{:{}}{:<17}= {}'h{:016x};\n", "", indent,
                            fmt::format("program_rom[{}]", place), curvecore::serial::kWordBits,
                            bits(word));
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: program_generator FOLDER\n");
        return 2;
    }
    Program arcs;
    arc_parts(arcs);
    Program splines;
    spline_parts(splines);
    if (arcs.words().size() > kArcPlaces || splines.words().size() > kPlaces - kArcPlaces) {
        std::fprintf(stderr, "program_generator: %zu and %zu words are too many\n",
                     arcs.words().size(), splines.words().size());
        return 1;
    }

    const std::string folder = argv[1];
    std::ofstream package(folder + "/serial_program_pkg.sv");
    package << fmt::format(kMade, "Places of the parts of the serial build's program")
            << "package serial_program_pkg;\n"
            << entries(arcs, 0) << entries(splines, kArcPlaces) << "endpackage\n";

    std::ofstream rom(folder + "/serial_program.sv");
    rom << fmt::format(kMade, "Program of the serial build, that of splines behind that of arcs")
        << "// Places of its parts: rtl/serial/serial_program_pkg.sv.\n"
           "`default_nettype none\n"
           "module serial_program #(\n"
           "    parameter int Splines = 1  // 0, 1\n"
           ") (\n"
           "    input  wire logic               clk_i,\n"
           "    input  wire logic               en_i,\n"
           "    input  wire logic [6+Splines:0] place_i,\n"
           "    output logic      [       60:0] word_o    // word of the clock before\n"
           ");\n\n"
        << fmt::format("  logic [60:0] program_rom[{} * (1 + Splines)];\n", kArcPlaces)
        << "  always_ff @(posedge clk_i) if (en_i) word_o <= program_rom[place_i];\n\n"
           "  initial begin\n"
        << words(arcs, 0, kArcPlaces, 4)
        << "  end\n"
           "  if (Splines != 0) begin : g_splines\n"
           "    initial begin\n"
        << words(splines, kArcPlaces, kPlaces, 6)
        << "    end\n"
           "  end\n\n"
           "endmodule\n"
           "`default_nettype wire\n";
    return package.good() && rom.good() ? 0 : 1;
}
