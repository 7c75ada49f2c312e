// SPDX-License-Identifier: Apache-2.0
// The digest (sysc/job/made_for.hpp): words for another configuration, by one setting or by many,
// do not enter.
#include "sysc/job/made_for.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "hls/word_entry.hpp"
#include "ref/curves/curve_table.hpp"
#include "ref/feed/planner.hpp"
#include "sysc/words/bus_words.hpp"
#include "tb/support/programs/program_builder.hpp"

namespace curvecore::tb::made_for_test {

struct Configuration {
    sysc::Options options;
    ref::Machine machine;
    std::uint16_t digest() const { return sysc::made_for(options, machine).digest(); }
};

/// A setting that words depend on, and a function to give it one of `values` values.
struct Thing {
    const char* name;
    int values;
    std::function<void(Configuration&, int)> set;
};

std::vector<Thing> things() {
    using C = Configuration;
    std::vector<Thing> all{
        {"Order", 11, [](C& c, int n) { c.options.core.order = 2 + n; }},
        {"Mode", 2, [](C& c, int n) { c.options.core.mode = n; }},
        {"CoefBits", 19, [](C& c, int n) { c.options.core.coef_bits = 18 + n; }},
        {"PositionBits", 17, [](C& c, int n) { c.options.core.position_bits = 16 + n; }},
        {"GuardBits", 11, [](C& c, int n) { c.options.core.guard_bits = 2 + n; }},
        {"AuxAxes", 7, [](C& c, int n) { c.options.core.aux_axes = n; }},
        {"Splines", 2, [](C& c, int n) { c.options.core.splines = n; }},
        {"table", 26,
         [](C& c, int n) {
             auto table = std::make_shared<ref::CurveTable>();
             table->text = std::string(1, static_cast<char>('a' + n));
             c.options.core.table = table;
         }},
        {"Build", 2, [](C& c, int n) { c.options.core.build = static_cast<sysc::Build>(n); }},
        {"period", 40, [](C& c, int n) { c.options.sample_period_s = 1e-5 * (1 + n); }},
        {"clock", 200, [](C& c, int n) { c.options.clock_hz = 1e6 * (1 + n); }},
        {"unit", 30, [](C& c, int n) { c.options.unit_mm = 1e-7 * (1 + n); }},
        {"samples per tick", 16, [](C& c, int n) { c.options.samples_per_tick = 1 << n; }},
        {"velocity", 100, [](C& c, int n) { c.machine.velocity = 10 * (1 + n); }},
        {"acceleration", 100, [](C& c, int n) { c.machine.acceleration = 50 * (1 + n); }},
        {"jerk", 100, [](C& c, int n) { c.machine.jerk = 1000 * (1 + n); }},
        {"joint time", 50, [](C& c, int n) { c.machine.joint_time = 1e-4 * (1 + n); }},
    };
    for (std::size_t a = 0; a < 3; ++a) {
        const auto add = [&](const char* name, int values, auto set) {
            all.push_back({name, values, [set, a](C& c, int n) { set(c.machine.axis[a], n); }});
        };
        using Axis = ref::AxisLimits;
        add("axis velocity", 90, [](Axis& axis, int n) { axis.velocity = 10 * (1 + n); });
        add("axis acceleration", 90, [](Axis& axis, int n) { axis.acceleration = 50 * (1 + n); });
        add("axis jerk", 90, [](Axis& axis, int n) { axis.jerk = 1000 * (1 + n); });
        add("axis min", 90, [](Axis& axis, int n) { axis.min = -10 * (1 + n); });
        add("axis max", 90, [](Axis& axis, int n) { axis.max = 10 * (1 + n); });
        add("axis rotary", 2, [](Axis& axis, int n) { axis.rotary = n == 1; });
    }
    return all;
}

/// Every value of each setting has its own digest.
TEST(MadeFor, TellsEveryThingApart) {
    for (const Thing& thing : things()) {
        std::set<std::uint16_t> digests;
        for (int n = 0; n < thing.values; ++n) {
            Configuration one;
            thing.set(one, n);
            digests.insert(one.digest());
        }
        EXPECT_EQ(digests.size(), static_cast<std::size_t>(thing.values)) << thing.name;
    }
}

/// Digests of 20,000 pairs of configurations that differ in many settings; by chance one of 65,536
/// is equal.
TEST(MadeFor, TellsConfigurationsApart) {
    std::mt19937 random(1);
    const std::vector<Thing> all = things();
    const auto any = [&] {
        Configuration one;
        for (const Thing& thing : all) {
            if (random() % 3 == 0) thing.set(one, static_cast<int>(random() % thing.values));
        }
        return one.digest();
    };
    int alike = 0;
    for (int n = 0; n < 20000; ++n) alike += any() == any() ? 1 : 0;
    EXPECT_LE(alike, 3);
}

/// Words for one digest that enter where another is required: less than a frame, for any two
/// digests.
TEST(MadeFor, LetsNoFrameInForAnother) {
    ProgramBuilder builder;
    builder.line({7, 3, 0}, 80);
    builder.tangent_arc({0, 0, 1}, {1, 0, 0}, 3, 3, 60);
    const ref::Plan plan = make_plan(builder.program(), ref::Machine(), ref::PlanOptions());
    const sysc::CoreParameters core;
    const sysc::RunTimeFormat format(core, 3);
    std::mt19937 random(2);
    const auto first = static_cast<std::uint16_t>(random());
    const auto segment = sysc::SegmentWriter(core, first).write(plan.segments.front());
    const auto piece = sysc::ProfileWriter(first).write(plan, 0);
    const auto enters = [](auto entry, const std::vector<std::uint64_t>& words) {
        hls::Entry last = hls::Entry::kPassed;
        for (const std::uint64_t word : words) last = entry.take(word);
        return last == hls::Entry::kCompleted;
    };
    for (int other = 0; other < 1 << 16; ++other) {
        const auto digest = static_cast<std::uint16_t>(other);
        ASSERT_EQ(enters(hls::SegmentEntry<sysc::RunTimeFormat>(format, false, digest), segment),
                  digest == first);
        ASSERT_EQ(enters(hls::PieceEntry(digest), piece), digest == first);
    }
}

}  // namespace curvecore::tb::made_for_test
