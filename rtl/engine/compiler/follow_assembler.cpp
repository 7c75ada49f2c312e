// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/follow_assembler.hpp"

#include <fmt/format.h>

#include "hls/words.hpp"
#include "ref/format/path_words.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/compiler/curve_assembler.hpp"
#include "rtl/engine/compiler/table_lowering.hpp"

namespace curvecore::assembler {
namespace {

using engine::Op;

constexpr int kFirstAuxiliary = 3;
constexpr int kEntries = 3;  // of the memory, for a queued word

/// Auxiliary axes of a segment: their words from the memory, and their ends as fine positions.
class AuxiliaryAxes {
  public:
    AuxiliaryAxes(const ref::CoreParameters& core, Assembly& assembly)
        : axes_(core.axes()), assembly_(assembly) {}

    void write() {
        begin("land_auxiliary");
        for (int axis = kFirstAuxiliary; axis < axes_; ++axis) {
            assembly_.from({"", 0, fmt::format("fine[{0}] = end[{0}]", axis)});
            assembly_.copy(word("fine", axis), word("end", axis));
        }
        end();
        begin("fetch_auxiliary");
        for (int axis = kFirstAuxiliary; axis < axes_; ++axis) {
            fetch("start", axis, hls::kPointField.bits);
            fetch("end", axis, hls::kPointField.bits);
            fetch("advance", axis, hls::kCoefField.bits);
        }
        end();
    }

  private:
    void begin(const std::string& label) {
        assembly_.from({"", 0, label});
        assembly_.label(label);
        if (axes_ > kFirstAuxiliary) {
            assembly_.open_auxiliary();
        }
    }
    void end() {
        if (axes_ > kFirstAuxiliary) {
            assembly_.close_axes();
        }
        assembly_.give_back();
    }
    Field word(const char* what, int axis) {
        return assembly_.auxiliary_word(fmt::format("{}[{}]", what, axis));
    }
    /// The low `bits` of a word, signed.
    void fetch(const char* what, int axis, int bits) {
        constexpr int kProduct = 45;
        const Field to = word(what, axis);
        assembly_.from({"", 0, fmt::format("{}[{}], {} bits", what, axis, bits)});
        const auto memory = static_cast<int>(assembly_.defined("memory").value());
        assembly_.put(Op::kIn, to, {memory, "memory"}, {});
        assembly_.put(Op::kMull, to, to, assembly_.power(kProduct - bits));
        assembly_.put(Op::kMulr, to, to, assembly_.power(bits), true);
    }

    int axes_;
    Assembly& assembly_;
};

}  // namespace

void assemble_follow(const std::string& programs, const std::vector<ref::CurveTable>& tables,
                     const ref::CoreParameters& core, Assembly& assembly) {
    const int fine = fine_scale(core).fine;
    const int words = ref::segment_bus_words(core.aux_axes);
    assembly.define("fine_exponent", fine);
    assembly.define("step_lift", hls::kPathFrac - fine);
    assembly.define("aux_words", ref::kAxisBusWords * core.aux_axes);
    if ((*assembly.defined("segment_end") - *assembly.defined("segment_begin")) %
            (kEntries * words) !=
        0) {
        throw AssemblyError(
            fmt::format("segment.asm: error: the queue holds whole segments, of {} words", words));
    }
    assemble_source(programs + "/follow.asm", assembly);
    assemble_source(programs + "/segment.asm", assembly);
    AuxiliaryAxes(core, assembly).write();
    assemble_curves(tables, core, assembly, "measure_step", "drawn");
}

}  // namespace curvecore::assembler
