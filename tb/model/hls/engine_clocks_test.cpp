// SPDX-License-Identifier: Apache-2.0
// Clocks of the engine (hls/clocks.hpp) are no less than the assembler's worst case of its
// programs, and close to it, in every configuration of tb/configurations.csv.
#include <gtest/gtest.h>

#include <algorithm>

#include "hls/clocks.hpp"
#include "ref/curves/table_reader.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "rtl/engine/compiler/follow_assembler.hpp"
#include "rtl/engine/compiler/motion_program.hpp"
#include "sysc/core/core_clocks.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"
#include "tb/support/segments/table_families.hpp"

namespace curvecore::tb::engine_clocks_test {

using assembler::worst_case;

const std::string kPrograms = RTL_DIR "/engine/programs";

/// Programs that draw samples of arcs, or of both curves.
assembler::Assembly drawing(const CurveCase& of) {
    assembler::Assembly assembly({8192, 1024, 2});
    assembly.from({"clocks", 0, ""});
    assembly.define("segment_begin", 0);
    assembly.define("segment_end", 3 * 64 * (17 + 3 * of.core.aux_axes));
    assemble_source(kPrograms + "/ports.asm", assembly);
    std::vector<ref::CurveTable> tables{ref::read_curve_table(CURVES_DIR "/arc.net")};
    if (of.spline) tables.push_back(ref::read_curve_table(CURVES_DIR "/spline.net"));
    assemble_follow(kPrograms, tables, of.core, assembly);
    assembly.finish();
    return assembly;
}

/// Share of a bound that is not used, over all cases.
class Slack {
  public:
    void add(int bound, int worst, const std::string& what) {
        EXPECT_GE(bound, worst) << what;
        least_ = std::min(least_, bound - worst);
        most_ = std::max(most_, double(bound - worst) / bound);
    }
    int least() const { return least_; }
    double most() const { return most_; }

  private:
    int least_ = 1 << 30;
    double most_ = 0;
};

TEST(EngineClocks, AreThoseOfItsPrograms) {
    Slack sample, step, segment;
    for (const CurveCase& of : configurations()) {
        const assembler::Assembly made = drawing(of);
        hls::TimedCore core = sysc::timed_core(of.core);
        core.build = ref::Build::kEngine;
        const int again = worst_case(made, "in_step", {"leave_step", "curve_sample", "land"});
        int curve = hls::engine_curve_clocks(core, false);  // of either kind
        if (of.spline) curve = std::max(curve, hls::engine_curve_clocks(core, true));
        sample.add(hls::kEngineFollowClocks + curve, worst_case(made, "follow", {"leave_step"}),
                   text(of));
        step.add(hls::engine_step_clocks(core, of.spline),
                 worst_case(made, "leave_step", {"in_step", "open_segment"}) + again, text(of));
        const int enters = hls::kEngineEntryClocks * hls::engine_entry_words(core);
        segment.add(hls::engine_segment_clocks(core, of.spline) - enters,
                    worst_case(made, "leave_step", {"in_step", "curve_step", "no_length"}) + again,
                    text(of));
    }
    for (const Slack* one : {&sample, &step, &segment}) {
        EXPECT_LT(one->least(), 100);
        EXPECT_LT(one->most(), 0.3);
    }
}

/// Clocks of a core that has a table besides arcs: the larger of both kinds.
TEST(EngineClocks, CoverTables) {
    TableFamilies families(RTL_DIR "/../ref/curves", 1);
    for (const std::string& name : TableFamilies::names()) {
        ref::CoreParameters core;
        core.build = ref::Build::kEngine;
        ref::add_table(families.table(name), core);
        const assembler::Assembly made =
            assembler::motion_program(core, {1024, 1024}, RTL_DIR "/..");
        const int again = worst_case(made, "in_step", {"leave_step", "curve_sample", "land"});
        const hls::TimedCore timed = sysc::timed_core(core);
        const hls::Clocks arc = sysc::core_clocks(core, ref::CurveKind::kArc);
        const hls::Clocks of = sysc::core_clocks(core, ref::CurveKind::kTable);
        const int words = hls::engine_entry_words(timed) + core.further_words;
        EXPECT_LE(worst_case(made, "follow", {"leave_step"}),
                  std::max(arc.sample, of.sample) - hls::engine_sample_clocks(timed, 0) +
                      hls::kEngineFollowClocks)
            << name;
        EXPECT_LE(worst_case(made, "leave_step", {"in_step", "open_segment"}) + again,
                  std::max(arc.step - arc.sample, of.step - of.sample))
            << name;
        EXPECT_LE(worst_case(made, "leave_step", {"in_step", "curve_step", "no_length"}) + again,
                  std::max(arc.segment - arc.sample, of.segment - of.sample) -
                      hls::kEngineEntryClocks * words)
            << name;
    }
}

/// Most clocks of a word: it comes in, is judged where its stream goes on, and passes. A stop comes
/// in where a piece is expected.
int most_word_clocks(const assembler::Assembly& made) {
    int judged = 0;
    for (const auto& [label, place] : made.labels()) {
        const bool of_word = label.size() > 5 && label.substr(label.size() - 5) == "_word";
        if (!of_word || label.substr(0, 6) == "enter_" || label == "stop_word") continue;
        const int clocks = worst_case(made, label, {"next_segment", "next_piece", "stop_word"});
        judged = std::max(judged, clocks);
    }
    const int comes =
        std::max(worst_case(made, "enter_segment_word", {"word_stays", "bad_word"}),
                 worst_case(made, "enter_piece_word", {"word_stays", "bad_word", "stop_here"}));
    const int stop = worst_case(made, "enter_piece_word") +
                     worst_case(made, "piece_word", {"of_piece", "next_piece"});
    return std::max(comes + judged, stop) +
           std::max(worst_case(made, "next_segment"), worst_case(made, "next_piece"));
}

/// Clocks of the loop (rtl/engine/programs/motion.asm) from a request to the next one's. A piece is
/// fetched at most once a tick. What it is at when a sample is asked for is over in less than a
/// tick.
TEST(EngineClocks, AreThoseOfItsLoop) {
    for (const bool spline : {false, true}) {
        ref::CoreParameters core;
        core.build = ref::Build::kEngine;
        core.splines = spline ? 1 : 0;
        core.mode = core.splines;
        const assembler::Assembly made =
            assembler::motion_program(core, {1024, 1024}, RTL_DIR "/..");
        const auto clocks = [&](const char* from, const std::set<std::string>& ends = {}) {
            return worst_case(made, from, ends);
        };
        const int fetch = clocks("fetch_piece");
        const int share_tick = clocks("share") - clocks("next_share");
        const int tick = clocks("tick_is_due", {"sample", "fetch"}) + fetch +
                         clocks("sample", {"guarded"}) + clocks("guarded", {"shares_on"}) +
                         share_tick;
        const int rest = clocks("motion", {"tick_is_due", "draw", "words", "shares_on"}) +
                         clocks("shares_on", {"draw"}) - share_tick +
                         clocks("draw", {"leave_step", "words", "motion"}) -
                         clocks("follow", {"leave_step"}) - fetch;
        EXPECT_LE(tick, hls::kEngineTickClocks);
        EXPECT_GE(tick, 0.95 * hls::kEngineTickClocks);
        EXPECT_LE(rest, hls::kEngineRestClocks);
        EXPECT_GE(rest, 0.95 * hls::kEngineRestClocks);
        const int words =
            2 * most_word_clocks(made) - clocks("enter_segment_word") - clocks("enter_piece_word");
        EXPECT_LE(clocks("words", {"motion"}) + words, hls::kEngineTickClocks);
        // Where the motion stands, a word of each stream enters behind each sample, and no piece is
        // fetched.
        const int still = tick - fetch - clocks("tick") + clocks("tick", {"branch_passes"}) + rest +
                          clocks("follow", {"leave_step"}) +
                          clocks("words", {"motion", "settings"}) + words;
        EXPECT_LE(still, sysc::least_period_clocks(core, false));
    }
}

/// Rates of the axes, on top of positions.
TEST(EngineClocks, AreThoseOfItsPlaces) {
    for (const int aux_axes : {0, 1, 6}) {
        ref::CoreParameters core;
        core.splines = 1;
        core.mode = 1;
        core.aux_axes = aux_axes;
        hls::TimedCore timed;
        timed.aux_axes = aux_axes;
        int clocks[2];
        for (const int rate_bits : {0, 29}) {
            clocks[rate_bits == 0 ? 0 : 1] =
                worst_case(assembler::motion_program(core, {1024, 1024}, RTL_DIR "/..", rate_bits),
                           "put_sample");
        }
        const int bound = hls::engine_place_clocks(timed);
        EXPECT_LE(clocks[1] - clocks[0], bound) << aux_axes;
        EXPECT_GE(clocks[1] - clocks[0], 0.9 * bound) << aux_axes;
    }
}

}  // namespace curvecore::tb::engine_clocks_test
