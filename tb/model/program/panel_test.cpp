// SPDX-License-Identifier: Apache-2.0
// A plan as a person at the machine is told of it, and wishes that wait.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ref/plan/segment_curve.hpp"
#include "ref/program/gcode_stream.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/panel/panel_status.hpp"
#include "sysc/panel/planned_path.hpp"
#include "sysc/panel/wish.hpp"

namespace curvecore::tb::panel_test {

using sysc::Wish;
using sysc::WishQueue;
using Kind = Wish::Kind;

sysc::Options options_of(const std::string& text) {
    std::istringstream stream(text);
    ref::GcodeStream gcode(stream, "t.ngc", {});
    ref::HeldProgram program{ref::read_all(gcode, "t.ngc"), gcode.events(), {}};
    sysc::Options options;
    options.program = std::make_shared<ref::HeldProgram>(std::move(program));
    return options;
}

const std::string kPart =
    "G64 P0.01\nG1 X20 F4800\nG3 X40 Y20 I0 J20\nG1 Y40\nG5 X30 Y50 I0 J8 P8 Q0\nG1 X20 Z5\nM2\n";

TEST(PlannedPath, SaysWhatTheProfileSays) {
    sysc::JobStream stream(options_of(kPart));
    sysc::PlannedPath path;
    ref::Plan all;
    while (const ref::Plan* part = stream.next()) {
        path.add(*part);
        static_cast<ref::PlanFrame&>(all) = *part;
        all.segments.insert(all.segments.end(), part->segments.begin(), part->segments.end());
        all.pieces.insert(all.pieces.end(), part->pieces.begin(), part->pieces.end());
    }
    const double unit = all.unit_mm;
    double time = 0;
    std::uint64_t begin = 0;
    std::size_t segment = 0;
    for (std::size_t n = 0; n < all.pieces.size(); ++n) {
        const ref::ProfilePiece& piece = all.pieces[n];
        const std::uint64_t middle = begin + piece.ds / 2;
        while (all.segments[segment].s_start + all.segments[segment].length <= middle) ++segment;
        const sysc::PathPlace place = path.at(middle);
        EXPECT_EQ(place.line, all.segments[segment].line) << n;
        EXPECT_GT(place.time_s, time);
        EXPECT_LT(place.time_s, time + piece.ticks * all.tick_s);
        // The feed is way by time.
        const auto step = static_cast<double>(piece.ds) * 1e-4;
        const sysc::PathPlace after = path.at(middle + static_cast<std::uint64_t>(step));
        const double mm = std::floor(step) * ref::kQuantum * unit;
        if (after.time_s > place.time_s && mm > 0) {
            EXPECT_NEAR(mm / (after.time_s - place.time_s), (place.feed_mm_s + after.feed_mm_s) / 2,
                        1e-3 * place.feed_mm_s + 1e-6)
                << n;
        }
        begin += piece.ds;
        time += piece.ticks * all.tick_s;
    }
    EXPECT_NEAR(path.time_s(), time, 1e-9);
}

TEST(PlannedPath, ItsPointsAreOnThePath) {
    const sysc::Job job = sysc::JobStream(options_of(kPart)).all();
    sysc::PlannedPath path;
    ref::Plan part;
    static_cast<ref::PlanFrame&>(part) = job.plan;
    std::size_t curved = 0;
    for (std::size_t n = 0; n < job.plan.segments.size(); ++n) {
        part.segments.push_back(job.plan.segments[n]);
    }
    path.add(part);
    const auto json = nlohmann::json::parse(path.json(0));
    std::size_t segment = 0;
    for (const auto& point : json["points"]) {
        const auto s = static_cast<std::uint64_t>(
            std::llround(double(point[3]) / job.plan.unit_mm * ref::kQuantaPerUnit));
        while (segment + 1 < part.segments.size() &&
               part.segments[segment].s_start + part.segments[segment].length < s) {
            ++segment;
        }
        const ref::Segment& on = part.segments[segment];
        const double along = (double(s) - double(on.s_start)) * ref::kQuantum;
        const ref::Vec3 exact = ref::exact_position(on, along) * job.plan.unit_mm;
        const ref::Vec3 shown(point[0], point[1], point[2]);
        EXPECT_LT((shown - exact).norm(), 1e-5);
        curved += on.kind_name() != std::string("line");
    }
    EXPECT_GT(curved, 60U);
    EXPECT_EQ(nlohmann::json::parse(path.json(json["points"].size()))["points"].size(), 0U);
    EXPECT_EQ(nlohmann::json::parse(path.json(5))["points"].size(), json["points"].size() - 5);
}

TEST(PlannedPath, KnowsWhereTheProgramRestsBehindWhatWasDrawnBefore) {
    const sysc::Job job = sysc::JobStream(options_of("G1 X1 F600\nG4 P1\nG1 X2\nM2\n")).all();
    ref::Plan part;
    static_cast<ref::PlanFrame&>(part) = job.plan;
    std::uint64_t rest = 0;
    bool rests = false;
    for (std::size_t n = 0; n < job.plan.segments.size(); ++n) {
        part.segments.push_back(job.plan.segments[n]);
    }
    for (std::size_t n = 0; n < job.plan.pieces.size(); ++n) {
        part.pieces.push_back(job.plan.pieces[n]);
        rests = rests || part.pieces.back().ds == 0;
        if (!rests) rest += part.pieces.back().ds;
    }
    ASSERT_TRUE(rests);
    constexpr std::uint64_t kBefore = 1'000'000'007;
    sysc::PlannedPath path({}, kBefore);
    path.add(part);
    EXPECT_EQ(path.at(kBefore + rest / 2).line, 1);
    EXPECT_FALSE(path.rests_at(kBefore + rest - 1));
    EXPECT_TRUE(path.rests_at(kBefore + rest));
    EXPECT_TRUE(path.rests_at(kBefore + rest));
    EXPECT_FALSE(path.rests_at(kBefore + rest + 1));
    EXPECT_EQ(path.at(kBefore + rest + 1).line, 3);
}

TEST(PlannedPath, HasPointsForAScreenHoweverLong) {
    const sysc::Job job = sysc::JobStream(options_of("G1 X1 F600\nM2\n")).all();
    ref::Plan part;
    static_cast<ref::PlanFrame&>(part) = job.plan;
    part.segments.push_back(job.plan.segments[0]);
    sysc::PlannedPath path;
    int thinned = 0;
    for (int n = 0; n < 100'000; ++n) {
        part.segments[0].last = n == 99'999;
        path.add(part);
        if (n % 10'000 != 0 && n != 99'999) continue;
        const auto json = nlohmann::json::parse(path.json(0));
        EXPECT_LE(json["points"].size(), 20'000U);
        EXPECT_GE(json["thinned"], thinned);
        thinned = json["thinned"];
        part.segments[0].s_start += 10'000 * part.segments[0].length;
    }
    EXPECT_GE(thinned, 3);
}

TEST(WishQueue, KeepsTheLastOfAKindAndItsOrder) {
    WishQueue wishes;
    for (int n = 1; n <= 10'000; ++n) wishes.push({Kind::kOverride, n % 100 + 1});
    wishes.push({Kind::kResume});
    wishes.push({Kind::kHold});
    wishes.push({Kind::kOverride, 70});
    wishes.push({Kind::kResume});
    wishes.push({Kind::kEstop});
    const Kind order[] = {Kind::kEstop, Kind::kHold, Kind::kOverride, Kind::kResume};
    for (const Kind kind : order) {
        const std::optional<Wish> wish = wishes.next();
        ASSERT_TRUE(wish);
        EXPECT_EQ(wish->kind, kind);
        if (kind == Kind::kOverride) {
            EXPECT_EQ(wish->percent, 70);
        }
    }
    EXPECT_FALSE(wishes.next());
}

TEST(WishQueue, UnderstandsTheWordsOfAFile) {
    EXPECT_EQ(sysc::wish_of("override 50")->percent, 50);
    EXPECT_EQ(sysc::wish_of(" hold ")->kind, Kind::kHold);
    for (const char* text : {"", "holds", "hold 5", "override", "override 0", "override 201",
                             "override 5x", "override -5", "override 50 50", "estop now"}) {
        EXPECT_FALSE(sysc::wish_of(text)) << text;
    }
}

TEST(PanelLines, AreNoLongerThanTheTerminal) {
    sysc::PanelStatus status;
    status.state = "runs";
    status.axes = {{'X', -1234.5678, 0.01}, {'Y', 0, std::nullopt}};
    status.queues = {{"segments", 4, 4096}, {"profile", 1024, 1024}};
    status.outputs = {5, 0.5};
    status.left_s = 61.2;
    status.faults = "e-stop";
    status.from = "1.5mm";
    const std::vector<std::string> wide = sysc::panel_lines(status, 200);
    const std::string text = fmt::format("{}", fmt::join(wide, "\n"));
    for (const char* part :
         {"X -1234.568", "outputs 0-2-----", "power 50 %", "1:02 left",
          "following error  X 0.0100 mm", "runs: e-stop", "at least", "went on --from 1.5mm"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    }
    for (const std::string& line : sysc::panel_lines(status, 20)) EXPECT_LE(line.size(), 20U);
}

}  // namespace curvecore::tb::panel_test
