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

/// Words of a segment behind those of X Y Z: of auxiliary axes and of its table, from the memory;
/// and the former's ends as fine positions.
class WordsBehindAxes {
  public:
    WordsBehindAxes(const ref::CoreParameters& core, Assembly& assembly)
        : axes_(core.axes()), assembly_(assembly) {
        if (!core.table) {
            return;
        }
        for (const auto& [place, row] : core.table->bus) {
            const ref::BusPlace at = ref::bus_place(place);
            if (at.further()) {
                further_[at.number] = {place, core.table->rows.at(row).of_axis};
            }
        }
    }

    /// Leaves out what has nothing to do; before it is called.
    void leave_out() {
        if (axes_ > kFirstAuxiliary) return;
        assembly_.leave_out("land_auxiliary");
        if (further_.empty()) assembly_.leave_out("fetch_auxiliary");
    }

    void write() {
        if (axes_ > kFirstAuxiliary) write_land();
        if (axes_ > kFirstAuxiliary || !further_.empty()) write_fetch();
    }

  private:
    void write_land() {
        begin("land_auxiliary");
        for (int axis = kFirstAuxiliary; axis < axes_; ++axis) {
            assembly_.from({"", 0, fmt::format("fine[{0}] = end[{0}]", axis)});
            assembly_.copy(word("fine", axis), word("end", axis));
        }
        end();
    }
    void write_fetch() {
        begin("fetch_auxiliary");
        for (int axis = kFirstAuxiliary; axis < axes_; ++axis) {
            fetch("start", axis, hls::kPointField.bits);
            fetch("end", axis, hls::kPointField.bits);
            fetch("advance", axis, hls::kCoefField.bits);
        }
        if (axes_ > kFirstAuxiliary) {
            assembly_.close_axes();
        }
        fetch_further();
        assembly_.give_back();
    }
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
    void fetch(const char* what, int axis, int bits) {
        fetch(word(what, axis), bits, fmt::format("{}[{}]", what, axis));
    }
    /// The low `bits` of a word, signed.
    void fetch(const Field& to, int bits, const std::string& what) {
        constexpr int kProduct = 45;
        assembly_.from({"", 0, fmt::format("{}, {} bits", what, bits)});
        const auto memory = static_cast<int>(assembly_.defined("memory").value());
        assembly_.put(Op::kIn, to, {memory, "memory"}, {});
        assembly_.put(Op::kMull, to, to, assembly_.power(kProduct - bits));
        assembly_.put(Op::kMulr, to, to, assembly_.power(bits), true);
    }

    /// Further words, one after the other.
    void fetch_further() {
        constexpr int kBits = hls::kCoefField.bits;
        for (const auto& [number, row] : further_) {
            const std::string& place = row.place;
            if (row.of_axis) {
                assembly_.from({"", 0, place});
                assembly_.for_axes(
                    [&] { fetch(assembly_.axis_word(place + "[k]"), kBits, place); });
            } else {
                fetch(assembly_.word(place), kBits, place);
            }
        }
    }

    struct FurtherRow {
        std::string place;
        bool of_axis = false;
    };

    int axes_;
    Assembly& assembly_;
    std::map<int, FurtherRow> further_;  // by the number of the first word
};

}  // namespace

void assemble_follow(const std::string& programs, const std::vector<ref::CurveTable>& tables,
                     const ref::CoreParameters& core, Assembly& assembly) {
    const int fine = fine_scale(core).fine;
    const int words = core.segment_words();
    assembly.define("fine_exponent", fine);
    assembly.define("step_lift", hls::kPathFrac - fine);
    assembly.define("words_behind_axes", words - ref::segment_bus_words(0));
    if ((*assembly.defined("segment_end") - *assembly.defined("segment_begin")) %
            (kEntries * words) !=
        0) {
        throw AssemblyError(
            fmt::format("segment.asm: error: the queue holds whole segments, of {} words", words));
    }
    WordsBehindAxes behind(core, assembly);
    behind.leave_out();
    assemble_source(programs + "/follow.asm", assembly);
    assemble_source(programs + "/segment.asm", assembly);
    behind.write();
    assemble_curves(tables, core, assembly, "measure_step", "drawn");
}

}  // namespace curvecore::assembler
