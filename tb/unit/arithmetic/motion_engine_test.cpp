// SPDX-License-Identifier: Apache-2.0
// rtl/engine/motion_engine.sv beside its twin: random instructions on random words, of both
// programs, with due, tick, conditions and answers of ports at random clocks. On every clock the
// same instruction begins, the same limb is written, asked for and put out; late and the whole
// memory are the same in the end. In every other program a bit of an instruction is changed.
#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <set>

#include "Vmotion_engine.h"
#include "Vmotion_engine___024root.h"
#include "hls/engine.hpp"
#include "sysc/cores/clocked_dut.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {
namespace {

using engine::Engine;
using engine::Op;

constexpr int kProgram = CFG_Instructions;
constexpr int kWords = 1 << CFG_WordBits;

/// A random number of a clock, the same whoever asks.
std::uint64_t noise(std::uint64_t seed, std::uint64_t clock) {
    std::uint64_t x = seed + clock * 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

/// Something that happens in a clock: what, where, which value.
struct Event {
    std::uint64_t clock;
    char what;  // i: an instruction begins; w: write; a: ask; o: out
    int place;
    int value;

    bool operator==(const Event& other) const {
        return clock == other.clock && what == other.what && place == other.place &&
               value == other.value;
    }
    bool operator<(const Event& other) const {
        return clock != other.clock ? clock < other.clock : what < other.what;
    }
};
std::ostream& operator<<(std::ostream& out, const Event& event) {
    return out << event.what << " in clock " << event.clock << ", at " << event.place << ": "
               << event.value;
}

/// The inputs of a clock, of the seed of a program, and what the twin does.
struct NoisyBoard : engine::QuietBoard {
    std::uint64_t seed = 0;
    std::uint64_t period = 1;      // mean clocks from due to due
    std::set<std::uint64_t> dues;  // in place of random ones
    std::deque<Event> events;
    std::uint64_t late_clock = ~std::uint64_t{0};

    bool due(std::uint64_t clock) {
        return dues.empty() ? noise(seed, clock) % period == 0 : dues.count(clock) > 0;
    }
    bool tick(std::uint64_t clock) { return noise(seed + 1, clock) % 8 == 0; }
    std::uint64_t conditions(std::uint64_t clock) { return noise(seed + 2, clock) & 0x1fff; }
    std::int16_t answer(std::uint64_t clock) {
        const std::uint64_t bits = noise(seed + 3, clock);
        return static_cast<std::int16_t>(bits % 8 == 0 ? 0 : bits >> 8);
    }
    bool condition(int code, std::uint64_t clock) { return conditions(clock) >> (code - 3) & 1; }
    void late(std::uint64_t clock) { late_clock = std::min(late_clock, clock); }
    std::int16_t in(int port, int limb, std::uint64_t clock) {
        add({clock - 2, 'a', port, limb});
        return answer(clock);
    }
    void out(int port, int limb, std::int16_t value, std::uint64_t clock) {
        add({clock, 'o', port * 4 + limb, value});
    }
    void wrote(int place, std::int16_t value, std::uint64_t clock) {
        add({clock, 'w', place, value});
    }
    void add(const Event& event) {
        events.insert(std::upper_bound(events.begin(), events.end(), event), event);
    }
};

/// A random instruction: any word, or one whose fields are likely to meet.
std::uint32_t random_instruction(std::mt19937_64& random) {
    auto word = static_cast<std::uint32_t>(random());
    if (random() % 4 == 0) return engine::is_whole(word) ? word : word ^ engine::kParity;
    const Op ops[] = {Op::kBr,   Op::kOut,  Op::kIn,   Op::kAdd, Op::kSub,
                      Op::kMull, Op::kMulr, Op::kMadr, Op::kMac, Op::kShr};
    engine::Instruction i = engine::decode(word);
    i.op = ops[random() % 10];
    if (i.op == Op::kOut && random() % 2 == 0) i.f1 = static_cast<int>(random() % 3);
    if (i.op == Op::kIn && random() % 4 == 0) i.f0 = engine::kPortLink;
    if (i.op == Op::kBr && random() % 2 == 0) i.flag = false;
    if (random() % 4 == 0) i.f2 = i.f0 ^ static_cast<int>(random() % 2);
    if (random() % 4 == 0) i.f1 = i.f2;
    return engine::encode(i);
}

/// Random limbs: any bits, digits, extremes; constants where the engine reads them.
std::vector<std::int16_t> random_limbs(std::mt19937_64& random) {
    std::vector<std::int16_t> memory = engine::empty_memory(kWords);
    for (std::size_t place = engine::kZero + 1; place < memory.size(); ++place) {
        const std::uint64_t bits = random();
        const auto any = static_cast<std::int16_t>(bits >> 16);
        const std::int16_t extremes[] = {-32768, 32767, -1, 0};
        memory[place] = bits % 4 == 0   ? extremes[bits >> 8 & 3]
                        : bits % 4 == 1 ? any
                                        : static_cast<std::int16_t>(any & 0x7fff);
    }
    return memory;
}

class MotionEngine : public testing::Test {
  protected:
    MotionEngine() { dut_.limit_cycles(~std::uint64_t{0}); }

    /// Loads a program, or a random one, and random words into both.
    void load(std::uint64_t seed, const std::vector<std::uint32_t>& lines = {}) {
        dut_.reset(1);  // first: an instruction under way may still write
        std::mt19937_64 random(seed);
        program_.resize(kProgram);
        for (std::uint32_t& word : program_) word = random_instruction(random);
        std::copy(lines.begin(), lines.end(), program_.begin());
        if (lines.empty() && seed % 2 == 0) {
            // Every other time among the first ones: few come to one of many.
            const std::size_t places = seed % 4 == 0 ? 16 : program_.size();
            program_[random() % places] ^= std::uint32_t{1} << random() % 32;
        }
        memory_ = random_limbs(random);
        for (int n = 0; n < kProgram; ++n) {
            dut_->rootp->motion_engine__DOT__u_program__DOT__memory[n] =
                program_[static_cast<std::size_t>(n)];
        }
        for (int n = 0; n < 4 * kWords; ++n) {
            const auto limb = static_cast<std::uint16_t>(memory_[static_cast<std::size_t>(n)]);
            dut_->rootp->motion_engine__DOT__u_memory__DOT__memory_a[n] = limb;
            dut_->rootp->motion_engine__DOT__u_memory__DOT__memory_b[n] = limb;
        }
        board_ = NoisyBoard();
        board_.seed = random();
        board_.period = 64 << random() % 8;
        late_clock_ = ~std::uint64_t{0};
        clock_ = 0;
        fetched_ = false;
    }

    /// Runs the RTL through the next clock and compares what it does with the twin.
    void clock() {
        auto& inside = *dut_->rootp;
        dut_->due_i = board_.due(clock_);
        dut_->tick_i = board_.tick(clock_);
        dut_->conditions_i = static_cast<std::uint16_t>(board_.conditions(clock_));
        dut_->in_data_i = static_cast<std::uint16_t>(board_.answer(clock_));
        dut_.settle();
        if (dut_->in_valid_o) expect({clock_, 'a', dut_->in_port_o, dut_->in_limb_o});
        if (fetched_) {
            const int thread = inside.motion_engine__DOT__u_sequencer__DOT__thread_o;
            expect({clock_, 'i', thread, inside.motion_engine__DOT__u_branch__DOT__pc_q[thread]});
        }
        if (dut_->out_valid_o) {
            expect({clock_, 'o', dut_->out_port_o * 4 + dut_->out_limb_o,
                    static_cast<std::int16_t>(dut_->out_data_o)});
        }
        if (inside.motion_engine__DOT__u_memory__DOT__write_i) {
            const auto limb = inside.motion_engine__DOT__u_memory__DOT__write_limb_i;
            expect({clock_, 'w', inside.motion_engine__DOT__u_memory__DOT__write_place_i,
                    static_cast<std::int16_t>(limb)});
        }
        const bool missing = !board_.events.empty() && board_.events.front().clock == clock_;
        ASSERT_FALSE(missing) << "not so in the RTL: " << board_.events.front();
        if (dut_->late_o && late_clock_ > clock_) late_clock_ = clock_ - 1;
        fetched_ = inside.motion_engine__DOT__u_sequencer__DOT__fetch_o;
        dut_.tick();
        ++clock_;
    }

    /// Checks that the twin does it, too.
    void expect(const Event& event) {
        ASSERT_FALSE(board_.events.empty()) << event;
        ASSERT_EQ(board_.events.front(), event);
        board_.events.pop_front();
    }

    /// Runs a program for some instructions in both; adds its clocks.
    void run(int instructions) {
        Engine twin(program_, memory_);
        std::uint64_t begin = 0;
        for (int n = 0; n < instructions; ++n) {
            begin = twin.clock();
            const int places[] = {twin.place(false), twin.place(true)};
            twin.step(board_);
            const int thread = twin.in_foreground() ? 1 : 0;
            board_.add({begin, 'i', thread, (places[thread] + 1) % kProgram});
            foreground_ += thread;
            while (clock_ < twin.clock()) ASSERT_NO_FATAL_FAILURE(clock());
        }
        clocks_ += clock_;
        // The twin has looked at every due until shortly before its last instruction.
        const std::uint64_t seen = begin - 2;
        ASSERT_EQ(std::min(late_clock_, seen), std::min(board_.late_clock, seen));
        ASSERT_EQ(dut_->changed_o != 0, twin.changed());
        changed_ += twin.changed() ? 1 : 0;
        lates_ += board_.late_clock < seen;
        for (int n = 0; n < 4 * kWords; ++n) {
            const auto limb =
                static_cast<std::uint16_t>(twin.memory()[static_cast<std::size_t>(n)]);
            ASSERT_EQ(dut_->rootp->motion_engine__DOT__u_memory__DOT__memory_a[n], limb) << n;
            ASSERT_EQ(dut_->rootp->motion_engine__DOT__u_memory__DOT__memory_b[n], limb) << n;
        }
    }

    sysc::ClockedDut<Vmotion_engine> dut_;
    NoisyBoard board_;
    std::vector<std::uint32_t> program_;
    std::vector<std::int16_t> memory_;
    std::uint64_t clock_ = 0;
    std::uint64_t late_clock_ = 0;
    bool fetched_ = false;
    std::uint64_t clocks_ = 0;
    int foreground_ = 0;  // instructions of it
    int lates_ = 0;       // programs that were late
    int changed_ = 0;     // programs that came to a changed instruction
};

TEST_F(MotionEngine, IsItsTwinOnEveryClock) {
    const int programs = cases(50, 50'000);
    const int instructions = 2'000;
    for (int n = 0; n < programs; ++n) {
        load(static_cast<std::uint64_t>(n) + 1);
        ASSERT_NO_FATAL_FAILURE(run(instructions)) << "program " << n;
    }
    std::cout << programs * instructions << " instructions, " << foreground_
              << " of them of the foreground, in " << clocks_ << " clocks; " << lates_ << " of "
              << programs << " programs late, " << changed_ << " found a change\n";
    EXPECT_GT(foreground_, programs * instructions / 10);
    EXPECT_LT(foreground_, programs * instructions / 10 * 9);
    EXPECT_GT(lates_, programs / 10);
    EXPECT_LT(lates_, programs);
    EXPECT_GT(changed_, programs / 20);
    EXPECT_LE(changed_, programs / 2);
}

TEST_F(MotionEngine, IsLateIfDueComesUntilTheClockOfTheForegroundsEnd) {
    // The background turns on the spot; the foreground waits for a tick and ends.
    constexpr int kAlways = engine::kNot | engine::kNever;
    const auto branch = [](int f0, int place, bool wait) {
        engine::Instruction i;
        i.flag = wait;
        i.f0 = f0;
        i.f2 = place;
        return engine::encode(i);
    };
    for (std::uint64_t again = 11; again < 40; ++again) {
        for (std::uint64_t seed = 1; seed < 20; ++seed) {
            load(seed, {branch(kAlways, 0, false), branch(engine::kNever, 0, true),
                        branch(kAlways | engine::kEnd, 1, false)});
            board_.dues = {10, again};
            ASSERT_NO_FATAL_FAILURE(run(20)) << seed << " " << again;
        }
    }
    EXPECT_GT(lates_, 100);
    EXPECT_LT(lates_, 450);
}

}  // namespace
}  // namespace curvecore::tb
