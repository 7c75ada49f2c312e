// SPDX-License-Identifier: Apache-2.0
// Threads that plan: they share work and read ahead, and the words are those of one thread.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "ref/feed/pieces/profile_words.hpp"
#include "ref/feed/plan_stream.hpp"
#include "ref/moves/moves_ahead.hpp"
#include "ref/numeric/workers.hpp"
#include "ref/text/input_error.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/words/bus_words.hpp"

namespace curvecore::tb::planning_threads_test {

TEST(Workers, DoEachPieceOfWorkOnce) {
    for (const int threads : {1, 2, 4, 8}) {
        ref::Workers workers(threads);
        for (const std::size_t count : {0, 1, 2, 7, 1000}) {
            std::vector<std::atomic<int>> done(count);
            workers.each(count, [&](std::size_t i) { ++done[i]; });
            for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i << " of " << count;
        }
    }
}

TEST(Workers, SayTheFirstFaultOnceAllIsDone) {
    ref::Workers workers(4);
    for (int round = 0; round < 100; ++round) {
        std::atomic<int> done = 0;
        try {
            workers.each(50, [&](std::size_t i) {
                ++done;
                if (i % 20 == 11) throw std::runtime_error(std::to_string(i));
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "11");
        }
        EXPECT_EQ(done, 50);
    }
}

TEST(Workers, WorkBesideTheirOwner) {
    ref::Workers workers(2);
    std::mutex both;
    std::condition_variable met;
    bool here = false;
    workers.begin([&] {
        const std::lock_guard lock(both);
        here = true;
        met.notify_all();
    });
    std::unique_lock lock(both);
    met.wait(lock, [&] { return here; });
}

/// A source that counts its moves by their lines; each third has an event before it.
class Counted {
  public:
    Counted(int moves, bool fails) : moves_(moves), fails_(fails) {}

    bool next(ref::Move& move) {
        EXPECT_FALSE(over_) << "asked once more";
        over_ = line_ == moves_;
        if (over_ && fails_) throw std::runtime_error("no more");
        if (over_) return false;
        move = ref::Move();
        move.line = ++line_;
        if (line_ % 3 == 0) events_.add(line_ % 2 == 0 ? "M3" : "M5", {line_, 0, 0, 0, 0, false});
        return true;
    }
    const ref::Events& events() const { return events_; }

  private:
    int moves_;
    bool fails_;
    bool over_ = false;
    int line_ = 0;
    ref::Events events_;
};

TEST(MovesAhead, AreThoseOfTheSourceWithTheirEvents) {
    const auto workers = std::make_shared<ref::Workers>(3);
    for (const std::size_t most : {1, 2, 5, 300}) {
        for (const bool fails : {false, true}) {
            Counted source(100, fails);
            ref::MovesAhead ahead([&](ref::Move& move) { return source.next(move); },
                                  [&]() -> const ref::Events& { return source.events(); }, workers,
                                  most);
            ref::Move move;
            for (int line = 1; line <= 100; ++line) {
                ASSERT_TRUE(ahead.next(move));
                EXPECT_EQ(move.line, line);
                ASSERT_EQ(ahead.events().list().size(), std::size_t(line / 3));
                if (line % 3 == 0) {
                    const ref::Events::Event& last = ahead.events().list().back();
                    EXPECT_EQ(last.line, line);
                    EXPECT_EQ(ahead.events().code_of(last), line % 2 == 0 ? "M3" : "M5");
                }
            }
            if (fails) {
                EXPECT_THROW(ahead.next(move), std::runtime_error);
            }
            EXPECT_FALSE(ahead.next(move));
        }
    }
}

TEST(MovesAhead, MayBeLeftAtAnyMove) {
    const auto workers = std::make_shared<ref::Workers>(2);
    for (int taken = 0; taken < 50; ++taken) {
        Counted source(1 << 30, false);
        ref::MovesAhead ahead([&](ref::Move& move) { return source.next(move); },
                              [&]() -> const ref::Events& { return source.events(); }, workers,
                              100);
        ref::Move move;
        for (int i = 0; i < taken; ++i) ASSERT_TRUE(ahead.next(move));
    }
}

/// Chords on a wavy surface within G64's tolerance, with arcs, splines, outputs, rests and rapids.
std::string random_program(unsigned seed) {
    std::mt19937 random(seed);
    std::string text = "G21 G90 G17\nG64 P0.01\nM3 S500\nF3000\n";
    double x = -900;
    for (int i = 0; i < 13000; ++i) {
        x += 0.04 + 0.08 * (random() % 100) / 100;
        text += fmt::format("G1 X{:.4f} Y{:.4f} Z{:.4f}\n", x, 4 * std::sin(x / 3),
                            std::cos(x / 2) + (random() % 3) * 0.002);
        if (random() % 50 != 0) continue;
        const double y = 4 * std::sin(x / 3);
        switch (random() % 5) {
            case 0:
                text += fmt::format("S{}\n", random() % 1000);
                break;
            case 1:
                text += fmt::format("M6{} P{}\n", 2 + random() % 2, random() % 4);
                break;
            case 2:
                text += fmt::format("G2 X{:.4f} Y{:.4f} I1 J0\n", x + 2, y), x += 2;
                break;
            case 3:
                text += "G4 P0.02\n";
                break;
            default:
                text += fmt::format("F{}\nG0 X{:.4f}\n", 500 + random() % 5000, x += 5);
        }
    }
    return text + "M2\n";
}

struct Words {
    std::vector<std::uint64_t> segments, profile;
    std::vector<std::string> warnings;
    double smoothed = 0;
    int parts = 0;

    bool operator==(const Words& other) const {
        return segments == other.segments && profile == other.profile &&
               warnings == other.warnings && smoothed == other.smoothed;
    }
};

Words words_of(const std::string& file, int threads) {
    sysc::Options options;
    options.file = file;
    options.gcode.obeyed.outputs = true;
    options.outputs = 4096;
    options.threads = threads;
    sysc::JobStream job(options);
    Words words;
    std::optional<sysc::SegmentWriter> segments;
    std::optional<sysc::ProfileWriter> profile;
    while (const ref::Plan* part = job.next()) {
        ++words.parts;
        if (!segments) {
            segments.emplace(job.job().options.core, job.job().digest());
            profile = profile_writer(job.job());
        }
        for (const ref::Segment& segment : part->segments) {
            const std::vector<std::uint64_t> some = segments->write(segment);
            words.segments.insert(words.segments.end(), some.begin(), some.end());
        }
        for (std::size_t piece = 0; piece < part->pieces.size(); ++piece) {
            const std::vector<std::uint64_t> some = profile->write(*part, piece);
            words.profile.insert(words.profile.end(), some.begin(), some.end());
        }
    }
    words.warnings = job.job().program.warnings;
    words.smoothed = job.job().smoothed->deviation;
    return words;
}

TEST(PlanningThreads, MakeTheWordsOfOne) {
    const std::string file = testing::TempDir() + fmt::format("threads_{}.ngc", getpid());
    std::ofstream(file) << random_program(1);
    const Words one = words_of(file, 1);
    EXPECT_GT(one.segments.size(), 80000U);
    EXPECT_GT(one.parts, 3);
    EXPECT_GT(one.smoothed, 0);
    for (const int threads : {2, 8}) {
        EXPECT_TRUE(words_of(file, threads) == one) << threads << " threads";
    }
    std::filesystem::remove(file);
}

/// Ticks of each part of a plan whose source fails behind some moves.
std::vector<double> ticks_until_it_fails(const std::shared_ptr<ref::Workers>& workers) {
    ref::PlanOptions options;
    options.aux_axes = 0;
    options.window = 100;
    options.workers = workers;
    int line = 0;
    const auto source = [&](ref::Move& move) {
        if (line == 1000) throw ref::InputError("t.ngc", line, "no more");
        move = ref::Move();
        move.feed = 50;
        move.start = {0.3 * line, std::sin(0.1 * line), 0};
        ++line;
        move.end = {0.3 * line, std::sin(0.1 * line), 0};
        move.line = line;
        return true;
    };
    ref::PlanStream stream(source, {"t.ngc", 0, 50}, ref::Machine{}, options);
    std::vector<double> ticks;
    EXPECT_THROW(
        while (const std::optional<ref::Plan> part = stream.next()) {
            ticks.push_back(ref::ticks_of(part->pieces) + 1e-3 * part->branches.size());
        },
        ref::InputError);
    EXPECT_FALSE(stream.next());
    return ticks;
}

TEST(PlanningThreads, GiveAllBeforeAFaultThatOneDoes) {
    const std::vector<double> one = ticks_until_it_fails({});
    EXPECT_GT(one.size(), 3U);
    for (const int threads : {1, 2, 4}) {
        EXPECT_EQ(ticks_until_it_fails(std::make_shared<ref::Workers>(threads)), one) << threads;
    }
}

}  // namespace curvecore::tb::planning_threads_test
