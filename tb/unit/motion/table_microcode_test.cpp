// SPDX-License-Identifier: Apache-2.0
// Curves that no core was made for, drawn by rtl/motion_interpolator.sv as it is: microcode of
// their table beside that of arcs and splines, their segments among others. Every sample is the
// table's, run in words.
#include "hls/quantise.hpp"
#include "rtl/engine/compiler/motion_program.hpp"
#include "tb/support/bench/motion_bench.hpp"
#include "tb/support/microcode/engine_memories.hpp"
#include "tb/support/programs/long_form.hpp"
#include "tb/support/segments/table_families.hpp"

namespace curvecore::tb {
namespace {

TableFamilies& families() {
    static TableFamilies kFamilies(RTL_DIR "/../ref/curves", 5);
    return kFamilies;
}

class TableMicrocode : public MotionInterpolator, public testing::WithParamInterface<std::string> {
  protected:
    TableMicrocode() : MotionInterpolator(families().table(GetParam())) {
        dut_.limit_cycles(~std::uint64_t{0});
        CoreParameters made = core_;
        auto table = std::make_shared<ref::CurveTable>(*core_.table);
        table->text.clear();  // the model is made for table 1, which a table without lines is
        made.table = table;
        memories_.load(assembler::motion_program(made, {1024, 512}, RTL_DIR "/.."),
                       assembler::motion_store(core_));
        start_afresh();
    }

    /// Turns half of a program's arcs into segments of the table, in steps so short that each row
    /// keeps its range.
    void bend(std::vector<RunSegment>& segments) {
        const int parts = GetParam() == "archimedean" ? 9 : 6;
        for (RunSegment& segment : segments) {
            if (segment.kind == hls::SegmentKind::kSpline || random_() % 2 == 0) continue;
            const TableCase of = families().next(GetParam());
            const int k = segment.step_exponent;
            ref::Segment made;
            made.curve = of.piece.rescaled(std::ldexp(1, k + parts) / of.length);
            made.step_exponent = k;
            const RunSegment words = hls::to_words(made, format_);
            segment.kind = words.kind;
            segment.theta = words.theta;
            segment.further = words.further;
            for (int axis = 0; axis < 3; ++axis) {
                segment.tangent[axis] = words.tangent[axis];
                segment.normal[axis] = words.normal[axis];
                segment.advance[axis] = words.advance[axis];
            }
            ++of_table_;
        }
    }

    EngineMemories memories_{"motion_interpolator.g_engine.u_motion.u_engine"};
    int of_table_ = 0;
};

TEST_P(TableMicrocode, DrawsTheWordsOfItsTable) {
    const int rounds = cases(2, 20);
    int64_t samples = 0;
    for (int round = 0; round < rounds && !HasFatalFailure(); ++round) {
        start_afresh();
        const auto profile = pieces(static_cast<uint32_t>(round), 40, 20, 40, 3 << 16);
        int64_t length = 0;
        for (const hls::ProfileWords& piece : profile) length += piece.ds;
        MixedSegments shapes(core_, random_(), kMaxStepExponent);
        auto segments = chain(shapes, length, int64_t{1} << (kMaxStepExponent + hls::kPathFrac));
        bend(segments);
        program(profile, segments);
        fill();
        run();
        samples += samples_;
    }
    std::cout << samples << " samples, " << of_table_ << " segments of the table\n";
    EXPECT_GT(of_table_, 2 * rounds);
    EXPECT_GT(samples, 1000 * rounds);
}

INSTANTIATE_TEST_SUITE_P(, TableMicrocode, testing::ValuesIn(TableFamilies::names()),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace curvecore::tb
