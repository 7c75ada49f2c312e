// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/motion_program.hpp"

#include "ref/curves/table_reader.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/compiler/follow_assembler.hpp"
#include "rtl/engine/compiler/places_assembler.hpp"
#include "rtl/engine/compiler/word_numbers.hpp"

namespace curvecore::assembler {
namespace {

/// Writes the program put_sample: the fine positions of all axes.
void put_sample(const ref::CoreParameters& core, Assembly& assembly) {
    const Field port{static_cast<int>(*assembly.defined("sample")), "sample"};
    const auto put = [&](const Field& fine) { assembly.put(engine::Op::kOut, {}, fine, port); };
    assembly.from({"motion", 0, "put a sample"});
    assembly.label("put_sample");
    const Field back = assembly.scratch(0);
    const Field link{engine::kPortLink, "link"};
    assembly.put(engine::Op::kIn, back, link, {}, false, 1);
    assembly.call_for_axes("put_axis");
    if (core.aux_axes > 0) {
        assembly.open_auxiliary();
        for (int axis = kAxes; axis < core.axes(); ++axis) {
            put(assembly.auxiliary_word("fine[" + std::to_string(axis) + "]"));
        }
        assembly.close_axes();
    }
    assembly.put(engine::Op::kOut, {}, back, link, false, 1);
    assembly.give_back();
    assembly.label("put_axis");
    put(assembly.axis_word("fine[k]"));
    assembly.give_back();
    assembly.label("put_position");  // of a host, which there is not
    assembly.give_back();
}

}  // namespace

void assemble_table_words(const std::string& programs, const ref::CoreParameters& core,
                          Assembly& assembly) {
    if (core.table) {
        assemble_source(programs + "/table_words.asm", assembly);
        return;
    }
    assembly.label("no_kind", "bad_word");
    assembly.label("axes_end", "segment_whole");
}

StoreSize motion_store(const ref::CoreParameters& core) {
    StoreSize size;
    const bool small = core.order <= 6 && core.aux_axes == 0 && !core.table;
    const bool large = core.order > 9 || core.order + core.aux_axes > 12 || core.table;
    size.program = small ? 1536 : large ? 4096 : 2048;
    size.data = small ? 256 : 512;
    size.axis_pages = small ? 1 : 2;
    return size;
}

Assembly motion_program(const ref::CoreParameters& core, const QueueWords& queues,
                        const std::string& tree, int rate_bits) {
    std::vector<ref::CurveTable> tables{ref::read_curve_table(tree + "/ref/curves/arc.net")};
    if (core.splines != 0) tables.push_back(ref::read_curve_table(tree + "/ref/curves/spline.net"));
    if (core.table) tables.push_back(*core.table);
    return motion_program(tables, core, queues, tree, rate_bits);
}

Assembly motion_program(const std::vector<ref::CurveTable>& tables, const ref::CoreParameters& core,
                        const QueueWords& queues, const std::string& tree, int rate_bits) {
    Assembly assembly(motion_store(core));
    define_words(core, queues.segments, queues.profile, assembly, rate_bits);
    assemble_source(tree + "/rtl/engine/programs/ports.asm", assembly);
    assemble_source(tree + "/rtl/engine/programs/reset.asm", assembly);
    assemble_follow(tree + "/rtl/engine/programs", tables, core, assembly);
    if (rate_bits == 0) {
        put_sample(core, assembly);
    } else {
        assemble_places(tree + "/rtl/engine/programs", core, rate_bits, assembly);
    }
    for (const char* source : {"path", "stops", "rate", "pieces", "share", "words", "segment_words",
                               "piece_words", "ledger", "settings", "powers", "motion"}) {
        assemble_source(tree + "/rtl/engine/programs/" + source + ".asm", assembly);
    }
    assemble_table_words(tree + "/rtl/engine/programs", core, assembly);
    assembly.label("first_values");
    assembly.open_further();
    assembly.put_starts();
    assembly.call("put_powers");
    if (rate_bits != 0) assembly.call("read_scales");
    assembly.branch("first_settings");
    assembly.finish();
    return assembly;
}

}  // namespace curvecore::assembler
