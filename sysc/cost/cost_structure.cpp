// SPDX-License-Identifier: Apache-2.0
// Multipliers and block memories of a core, counted as the RTL instantiates them.
#include "sysc/cost/cost_structure.hpp"

namespace curvecore::sysc {
namespace {

// Bits of either operand for which Yosys takes a block of a GW2A; of an XC7.
constexpr int kGowinLeast = 3;
constexpr int kXilinxLeast = 5;

int blocks(int bits, int width) { return (bits + width - 1) / width; }

/// Blocks of rtl/multiplier/multiplier_portable.sv as Yosys maps it: a product of the high halves,
/// 18 bits signed, and one for every pair with a low half, which is unsigned and takes the bits
/// above 18.
int portable(int bits, const Device& device) {
    const int low = bits - 18;
    if (device.family == "gw2a-18") {  // up to 9 x 9 it is half a block
        return 1 + (low >= kGowinLeast ? 2 : 0) + (low > kGowinLeast ? 1 : 0);
    }
    if (device.family == "lifcl-40") {  // 18 bits signed by 18 unsigned: MULT18X36, two blocks
        return low == 18 ? 6 : low > 0 ? 4 : 1;
    }
    if (device.family == "xc7") {  // 25 x 18 bits signed
        return 1 + (low > 0 ? 2 : 0) + (low == 18 ? 2 : low >= kXilinxLeast ? 1 : 0);
    }
    return 0;
}

/// Blocks of rtl/multiplier/multiplier.sv.
int multiplier(int bits, const Device& device) {
    if (device.form == 1) return blocks(bits, 18) * blocks(bits, 18);
    if (device.form == 2) return bits > 32 ? 8 : 4;
    return portable(bits, device);
}

/// Blocks of a product of the spline's network: 18 x 18 bits, one of them signed by a bit more.
int narrow_multiplier(const Device& device) {
    if (device.form == 1) return 1;
    return device.family == "xc7" ? 2 : 0;
}

}  // namespace

MultiplierCount count_multipliers(Core core, const CoreParameters& parameters) {
    if (parameters.build == Build::kSerial) return {1, 0};
    const bool arcs = core != Core::kSpline;
    const bool splines = core != Core::kSpherical;
    const int interval = parameters.sample_interval;
    const int order = parameters.order;
    const auto stages = [interval](int passes) { return (passes + interval - 1) / interval; };
    MultiplierCount count;
    if (parameters.mode == 0) {
        count.wide = 3 * stages(order);
    } else {
        if (arcs) {
            const int axis = interval == 1 ? 3 : interval == 2 ? 2 : 1;
            count.wide += 1 + stages(order / 2) + stages((order - 1) / 2) + 3 * axis;
        }
        if (splines) count.wide += stages(order) + 3 * stages(3);
    }
    count.wide += parameters.aux_axes;
    // V and P of each axis, phi; one for Q, R and the anchor; the axes' own series.
    if (splines) count.narrow = 8 + (parameters.mode == 0 ? 3 : 0);
    return count;
}

int count_dsp(Core core, const CoreParameters& parameters, const Device& device) {
    const MultiplierCount count = count_multipliers(core, parameters);
    const int bits = parameters.coef_bits;
    // Of tau^2 Yosys makes the two products that are the same one once.
    const bool square = device.family == "xc7" && parameters.build == Build::kParallel &&
                        parameters.mode == 1 && core != Core::kSpline && bits > 18;
    return count.wide * multiplier(bits, device) + count.narrow * narrow_multiplier(device) -
           (square ? 1 : 0);
}

int soft_bits(const CoreParameters& parameters, const Device& device) {
    const int bits = parameters.coef_bits;
    const int low = bits - 18;
    if (device.family == "hx8k") return bits * bits;
    if (device.family != "gw2a-18" || low > kGowinLeast) return 0;
    return low == kGowinLeast ? low * low : bits * bits - 18 * 18;
}

bool wide_block(const CoreParameters& parameters, const Device& device) {
    return device.family == "lifcl-40" && parameters.coef_bits == 36;
}

int count_ram(Core core, const CoreParameters& parameters, const Device& device) {
    if (parameters.build == Build::kParallel) return 0;  // its memories are distributed
    // Three copies of the words, the program and, where there is no distributed memory, two copies
    // of points. Some of the program's 61 bits are alike.
    const bool splines = core == Core::kCurve;
    const int fine_bits = parameters.position_bits + parameters.guard_bits;
    if (device.family == "xc7") return 3 + blocks(fine_bits, 36);  // one of points, no program
    if (device.family != "up5k" && device.family != "hx8k") return 3 + 2;  // words of 36 bits
    const int words = blocks(parameters.coef_bits, splines ? 8 : 16);
    const int points = blocks(fine_bits, 16);
    return 3 * words + 2 * points + (splines ? 4 : 3);
}

}  // namespace curvecore::sysc
