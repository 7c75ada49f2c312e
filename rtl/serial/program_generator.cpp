// SPDX-License-Identifier: Apache-2.0
// The program of the serial build from the networks' tables, as two files in the given folder:
// spherical_program_pkg.sv, where its parts begin, and spherical_program.sv, the words.
//
// A word is one operation D = C + round(A B) of rtl/serial/folded_datapath.sv; words form frames of
// at least nine, so that a frame reads what the frame before has written (three contexts take turns
// with frames of three words). A Riemann node is one word per order. What depends on Order,
// AuxAxes and CoefBits is left to the sequencer: no word does.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "ref/series/figures.hpp"

namespace {

using curvecore::ref::kSineCosine;
using curvecore::ref::kSpherical;

/// How the low (or, for kContext, the high) nibble of an address is made.
enum Select { kPlain = 0, kContext = 1, kBelow = 4, kOrder = 5, kAbove = 6, kAboveTwo = 7 };
struct Address {
    int base;
    Select select = kPlain;
};

// The word memory (rtl/serial/folded_datapath.sv): 16 rows of 16.
constexpr int kAngle = 6;  // coefficient rows: the six of Fig. 8, then the two of Fig. 2
constexpr Address coefficient(std::size_t node, Select order) {
    return {static_cast<int>(node) << 4, order};
}
constexpr Address state(std::size_t node) { return {static_cast<int>(node) << 4}; }
constexpr Address kWeight{0x80, kOrder};
constexpr Address kMinusWeight{0x90, kOrder};
constexpr Address kReciprocal{0xa0, kOrder};
constexpr Address kZero{0xa0};
constexpr Address kTheta{0xa1};
constexpr Address kOne{0x81};
constexpr Address kMinusOne{0x91};
constexpr Address sum(std::size_t node) { return {0xb0 + static_cast<int>(node)}; }
constexpr Address advance(int axis) { return {0xc0 + axis}; }
constexpr Address accumulator(int axis) { return {0xd0 + axis, kContext}; }
constexpr Address kTau{0xd3, kContext};
constexpr Address kSquare{0xd4, kContext};
constexpr Address kSine{0xd5, kContext};
constexpr Address kVersine{0xd6, kContext};
constexpr Address inward(int axis) { return {0xd8 + axis, kContext}; }

enum Scale { kUnit = 0, kCoef = 1, kFirstCoef = 2 };  // product / 2^(W-1), / 2^(W-2), that if i = 1
enum Target { kNowhere = 0, kMemory = 1, kSample = 2, kOrigin = 3 };
enum Control { kGo = 0, kNext, kLoop, kSkip, kHalt, kHaltNoAux, kHaltThreeAux, kLoopHalt };

struct Word {
    Address d{0};
    Address c = kZero;
    Address a = kZero;
    Address b = kZero;
    Scale scale = kUnit;
    Target target = kNowhere;
    Control control = kGo;
};

Word make(Address d, Address c, Address a, Address b, Scale scale = kUnit) {
    return {d, c, a, b, scale, kMemory, kGo};
}
Word to(Target target, int axis, Address c, Address a, Address b, Scale scale) {
    return {{axis}, c, a, b, scale, target, kGo};
}

std::vector<Word> program;

/// Control stands in a frame's last word but two: the fetch of the last two hides the branch.
void frame(std::vector<Word> words, Control control, std::size_t length = 9) {
    if (words.size() < length) words.resize(length);
    words[words.size() - 3].control = control;
    program.insert(program.end(), words.begin(), words.end());
}

/// One order of every node, from row `first` on.
template <class Network>
std::vector<Word> expansion(const Network& network, std::size_t first) {
    std::vector<Word> words;
    for (const std::size_t n : evaluation_order(network)) {
        const auto& node = network.nodes[n];
        words.push_back(make(coefficient(first + n, kOrder), kZero,
                             coefficient(first + network.node(node.integrand), kBelow),
                             node.gain.factor < 0 ? kMinusWeight : kWeight, kFirstCoef));
    }
    return words;
}

void weights() {
    std::vector<Word> words{make(kWeight, kZero, kReciprocal, kTheta)};
    words.resize(9);
    words.push_back(make(kMinusWeight, kZero, kWeight, kMinusOne, kCoef));
    frame(words, kLoopHalt, 11);
}

/// The series of sine and cosine, for the polynomial mode; the versine has no constant term.
void angle() {
    const std::size_t cosine = kAngle + kSineCosine.node("z");
    frame({make(state(cosine), kZero, kOne, kOne, kCoef)}, kNext);
    frame(expansion(kSineCosine, kAngle), kLoop, 11);
    frame({make(state(cosine), kZero, kZero, kZero)}, kHalt);
}

const std::size_t kOutput[3] = {kSpherical.node("x"), kSpherical.node("y"), kSpherical.node("z")};
const std::size_t kSpeed[3] = {kSpherical.node("F"), kSpherical.node("G"), kSpherical.node("H")};

/// The sums' frame, then per order the nodes and their sums, then the advance in order 1.
void expand() {
    std::vector<Word> clear;
    for (std::size_t n = 0; n < kSpherical.size(); ++n) {
        clear.push_back(make(sum(n), kZero, kZero, kZero));
    }
    frame(clear, kNext);
    std::vector<Word> order = expansion(kSpherical, 0);
    order.resize(9);
    for (std::size_t n = 0; n < kSpherical.size(); ++n) {
        order.push_back(make(sum(n), sum(n), coefficient(n, kOrder), kOne, kCoef));
    }
    frame(order, kLoop);
    std::vector<Word> rate;
    for (int axis = 0; axis < 3; ++axis) {
        const Address first{state(kOutput[axis]).base + 1};
        rate.push_back(make(first, first, advance(axis), kOne, kCoef));
    }
    frame(rate, kHalt, 5);  // samples come later than its results
}

void step() {
    std::vector<Word> words;
    for (std::size_t n = 0; n < kSpherical.size(); ++n) {
        words.push_back(make(state(n), state(n), sum(n), kTheta));
    }
    for (int axis = 0; axis < 3; ++axis) {
        words.push_back(to(kOrigin, axis, sum(kOutput[axis]), advance(axis), kOne, kCoef));
    }
    frame(words, kNext);
    words.clear();
    for (int axis = 3; axis < 9; ++axis) {
        words.push_back(to(kOrigin, axis, kZero, advance(axis), kOne, kCoef));
    }
    frame(words, kHalt);
}

void auxiliary() {
    for (int first = 3; first < 9; first += 3) {
        std::vector<Word> words;
        for (int axis = first; axis < first + 3; ++axis) {
            words.push_back(to(kSample, axis, kZero, advance(axis), kTau, kUnit));
        }
        frame(words, first == 3 ? kHaltThreeAux : kHalt, 3);
    }
}

void series() {
    std::vector<Word> top;
    std::vector<Word> loop;
    std::vector<Word> last;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t n = kOutput[axis];
        top.push_back(
            make(accumulator(axis), coefficient(n, kOrder), coefficient(n, kAbove), kTau));
        loop.push_back(make(accumulator(axis), coefficient(n, kOrder), accumulator(axis), kTau));
        last.push_back(to(kSample, axis, kZero, accumulator(axis), kTau, kUnit));
    }
    frame(top, kSkip, 3);
    frame(loop, kLoop, 3);
    frame(last, kHaltNoAux, 3);
    auxiliary();
}

void polynomial() {
    const std::size_t y = kAngle + kSineCosine.node("y");
    const std::size_t z = kAngle + kSineCosine.node("z");
    frame({make(kSquare, kZero, kTau, kTau)}, kNext, 3);
    frame({make(kSine, coefficient(y, kOrder), coefficient(y, kAboveTwo), kSquare),
           make(kVersine, coefficient(z, kBelow), coefficient(z, kAbove), kSquare)},
          kSkip, 3);
    frame({make(kSine, coefficient(y, kOrder), kSine, kSquare),
           make(kVersine, coefficient(z, kBelow), kVersine, kSquare)},
          kLoop, 3);
    std::vector<Word> rate;
    std::vector<Word> pull;
    std::vector<Word> last;
    for (int axis = 0; axis < 3; ++axis) {
        rate.push_back(make(accumulator(axis), advance(axis), state(kSpeed[axis]), kSine, kCoef));
        pull.push_back(make(inward(axis), kZero, state(kOutput[axis]), kVersine, kCoef));
        last.push_back(to(kSample, axis, inward(axis), accumulator(axis), kTau, kUnit));
    }
    frame(rate, kNext, 3);
    frame(pull, kNext, 3);
    frame(last, kHaltNoAux, 3);
    auxiliary();
}

unsigned long long bits(const Address& address) {
    return static_cast<unsigned long long>(address.select << 8 | address.base);
}
unsigned long long bits(const Word& word) {
    return static_cast<unsigned long long>(word.control) << 48 |
           static_cast<unsigned long long>(word.target) << 46 |
           static_cast<unsigned long long>(word.scale) << 44 | bits(word.d) << 33 |
           bits(word.c) << 22 | bits(word.b) << 11 | bits(word.a);
}

struct Part {
    const char* name;
    void (*write)();
};
constexpr std::size_t kPlaces = 128;
constexpr Part kParts[] = {{"Weights", weights}, {"Angle", angle},   {"Expand", expand},
                           {"Step", step},       {"Series", series}, {"Polynomial", polynomial}};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: program_generator FOLDER\n");
        return 2;
    }
    const std::string folder = argv[1];
    std::ofstream package(folder + "/spherical_program_pkg.sv");
    package << "// SPDX-License-Identifier: Apache-2.0\n"
               "// Where the parts of the serial build's program begin, made by\n"
               "// rtl/serial/program_generator.cpp: do not edit.\n"
               "package spherical_program_pkg;\n";
    for (const Part& part : kParts) {
        package << fmt::format("  localparam logic [6:0] {}Entry = 7'd{};\n", part.name,
                               program.size());
        part.write();
    }
    package << "endpackage\n";

    std::ofstream words(folder + "/spherical_program.sv");
    words << "// SPDX-License-Identifier: Apache-2.0\n"
             "// Program of the serial build, made by rtl/serial/program_generator.cpp: do not "
             "edit.\n"
             "// Its parts begin where rtl/spherical_program_pkg.sv says.\n"
             "`default_nettype none\n"
             "module spherical_program (\n"
             "    input  wire logic        clk_i,\n"
             "    input  wire logic [ 6:0] place_i,\n"
             "    output logic      [50:0] word_o    // of the clock before\n"
             ");\n\n"
             "  logic [50:0] program_rom[128];\n"
             "  always_ff @(posedge clk_i) word_o <= program_rom[place_i];\n\n"
             "  initial begin\n";
    program.resize(std::max<std::size_t>(program.size(), kPlaces));
    for (std::size_t place = 0; place < program.size(); ++place) {
        words << fmt::format("    {:<17}= 51'h{:013x};\n", fmt::format("program_rom[{}]", place),
                             bits(program[place]));
    }
    words << "  end\n\nendmodule\n`default_nettype wire\n";
    return program.size() == kPlaces && package.good() && words.good() ? 0 : 1;
}
