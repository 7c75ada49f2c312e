// SPDX-License-Identifier: Apache-2.0
// Plans for queues of any length: a program's time grows in proportion as they get shorter, and no
// plan needs more windows or pieces than its program does.
//
// A motion that a stop of N ticks bounds has a queue's words pass in N: half of them, twice the
// time. Frames are whole: of 128 and 64 words three quarters are 5 and 2 segments, 2.5 times.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "ref/feed/plan_stream.hpp"
#include "ref/path/smooth_path.hpp"
#include "ref/program/program_reader.hpp"

namespace curvecore::tb::short_queues_test {

constexpr double kSame = 1.01;   // greatest ratio of the time with longer queues
constexpr double kHalf = 4;      // greatest ratio of the time with queues half as long: see above
constexpr double kPieces = 2.5;  // greatest ratio of the pieces to those with the longest queues

struct Planned {
    double duration_s = 0;
    std::size_t parts = 0;
    std::size_t pieces = 0;
};

Planned planned(const ref::Program& program, std::size_t window, int words) {
    ref::PlanOptions options;
    options.segment_queue_words = options.profile_queue_words = words;
    options.aux_axes = program.aux_axes;
    options.window = window;
    double fastest = 0;
    for (const ref::Move& move : program.moves) {
        fastest = std::max(fastest, ref::fastest_motion(move));
    }
    ref::PlanStream stream(ref::source_of(program), {program.file, program.aux_axes, fastest},
                           ref::Machine(), options);
    Planned all;
    while (const std::optional<ref::Plan> part = stream.next()) {
        all.duration_s += part->duration_s;
        all.pieces += part->pieces.size();
        ++all.parts;
    }
    return all;
}

/// | field  | remark                                                |
/// |--------|-------------------------------------------------------|
/// | window | moves; fewer than the program has: it has several     |
class ShortQueues : public testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(ShortQueues, TakeLongerInProportion) {
    const auto [name, window] = GetParam();
    ref::Program program = ref::read_program(std::string(DATA_DIR "/") + name + ".ngc", {});
    ref::smooth_path(program, ref::Machine());
    const Planned longest = planned(program, window, 65536);
    Planned before = longest;
    for (int words = 16384; words >= 64; words /= words > 2048 ? 4 : 2) {
        const Planned now = planned(program, window, words);
        EXPECT_GE(now.duration_s * kSame, before.duration_s) << words;
        EXPECT_LE(now.duration_s, kHalf * before.duration_s) << words;
        EXPECT_LE(now.parts, 2 * longest.parts) << words;
        EXPECT_LE(static_cast<double>(now.pieces), kPieces * static_cast<double>(longest.pieces))
            << words;
        before = now;
    }
}

INSTANTIATE_TEST_SUITE_P(OfPrograms, ShortQueues,
                         testing::Values(std::pair{"demo", 3000}, std::pair{"arcs", 3000},
                                         std::pair{"butterfly", 3000}, std::pair{"tilted", 3000},
                                         std::pair{"nurbs", 3000}, std::pair{"butterfly", 60},
                                         std::pair{"demo", 60}),
                         [](const auto& one) {
                             return std::string(one.param.first) + std::to_string(one.param.second);
                         });

}  // namespace curvecore::tb::short_queues_test
