// SPDX-License-Identifier: Apache-2.0
// Instructions of hls/engine.hpp against 128-bit integers, their clocks, hazards and programs.
#include "hls/engine.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace curvecore::engine::engine_test {

__extension__ using Wide = __int128;

/// A word of `limbs` limbs at a limb's place.
Wide value(const std::vector<std::int16_t>& memory, int place, int limbs) {
    Wide sum = 0;
    for (int limb = limbs - 1; limb >= 0; --limb) {
        sum = sum * 32768 + memory[static_cast<std::size_t>(place + limb)];
    }
    return sum;
}

/// Modulo 2^bits, signed.
Wide wrapped(Wide x, int bits) {
    const Wide half = Wide(1) << (bits - 1);
    return ((x + half) & (2 * half - 1)) - half;
}

Instruction instruction(Op op, int limbs, int f0, int f1, int f2, bool flag = false) {
    Instruction i;
    i.op = op;
    i.limbs = limbs;
    i.flag = flag;
    i.f0 = f0;
    i.f1 = f1;
    i.f2 = f2;
    return i;
}
Instruction branch(int f0, int place, bool wait = false) {
    return instruction(Op::kBr, 1, f0, place >> 8, place & 0xff, wait);
}
constexpr int kAlways = kNot | kNever;

/// An engine whose background executes `lines` from place 0 on.
Engine engine_of(const std::vector<Instruction>& lines, std::vector<std::int16_t> memory) {
    std::vector<std::uint32_t> program(256);
    for (std::size_t n = 0; n < lines.size(); ++n) program[n] = encode(lines[n]);
    return {program, std::move(memory)};
}

/// Random words from 8 on: of 3 limbs, signed, with bits of any number; wide ones from 64 on.
std::vector<std::int16_t> random_memory(std::mt19937_64& random) {
    std::vector<std::int16_t> memory = empty_memory();
    for (int word = 8; word < 128; ++word) {
        const auto bits = static_cast<int>(random() % 45);
        auto x = static_cast<std::int64_t>(random()) >> 19 >> bits;
        for (int limb = 0; limb < 3; ++limb, x >>= 15) {
            const bool top = limb == 2 && (word < 64 || word % 2 == 1);
            memory[static_cast<std::size_t>(4 * word + limb)] =
                static_cast<std::int16_t>(top ? x : x & 0x7fff);
        }
        if (word >= 64 && word % 2 == 0) {
            memory[static_cast<std::size_t>(4 * word + 3)] =
                static_cast<std::int16_t>(random() & 0x7fff);
        }
        if (word >= 64 && word % 2 == 1) {
            const auto top = static_cast<std::int16_t>(random() % 64 - 32);
            memory[static_cast<std::size_t>(4 * word + 1)] = top;
            memory[static_cast<std::size_t>(4 * word + 2)] = 0;
        }
    }
    return memory;
}

/// F2 after an instruction, by the table of hls/instruction.hpp.
Wide expected(const Instruction& i, const std::vector<std::int16_t>& before) {
    const bool short_words = is_sum(i.op);
    const int read = short_words ? i.limbs : 3;
    const Wide a = value(before, 4 * i.f0, i.op == Op::kShr ? 6 : read);
    const Wide power = (i.f1 & 15) == 15 ? -(Wide(1) << (i.f1 >> 4 & 3) * 15)
                                         : Wide(1) << ((i.f1 >> 4 & 3) * 15 + (i.f1 & 15));
    const Wide b = is_power(i.f1) ? power : value(before, 4 * i.f1, read);
    const Wide c = value(before, 4 * i.f2, i.op == Op::kMac ? 6 : 3);
    const int bits = 15 * i.limbs;
    const Wide half = i.flag ? 0 : Wide(1) << 44;
    switch (i.op) {
        case Op::kAdd:
            return a + b;
        case Op::kSub:
            return a - b;
        case Op::kMull:
            return wrapped(a * b, bits);
        case Op::kMulr:
        case Op::kShr:
            return wrapped((a * b + half) >> 45, bits);
        case Op::kMadr:
            return wrapped(value(before, 4 * i.f0, i.limbs) + ((c * b + half) >> 45), bits);
        default:
            return wrapped(i.flag ? a * b : c + a * b, 90);
    }
}

/// A random line of an operation with a result; no word of F2 is an operand's.
Instruction random_line(std::mt19937_64& random) {
    const Op ops[] = {Op::kAdd, Op::kSub, Op::kMull, Op::kMulr, Op::kMadr, Op::kMac, Op::kShr};
    const Op op = ops[random() % 7];
    const int limbs = op == Op::kMull || is_high(op) ? 1 + static_cast<int>(random() % 4) : 3;
    const int f0 = op == Op::kShr ? 64 + 2 * static_cast<int>(random() % 16)
                                  : 8 + static_cast<int>(random() % 40);
    // A wide word times a factor must fit the arithmetic here.
    const int shift = static_cast<int>(random() % 15 + 15 * (random() % 3));
    const int f1 = random() % 3 == 0   ? power(shift)
                   : random() % 9 == 0 ? minus_power(shift / 15)
                                       : 8 + static_cast<int>(random() % 40);
    const int f2 = op == Op::kMac ? 100 + 2 * static_cast<int>(random() % 8)
                                  : 48 + static_cast<int>(random() % 8);
    return instruction(op, limbs, f0, f1, f2, random() % 2 == 0);
}

TEST(Engine, EachOperationIsItsLineOnWholeWords) {
    std::mt19937_64 random(1);
    for (int n = 0; n < 100'000; ++n) {
        std::vector<std::int16_t> memory = random_memory(random);
        const Instruction i = random_line(random);
        Engine engine = engine_of({i}, memory);
        QuietBoard board;
        engine.step(board);
        const Wide want = expected(i, memory);
        const int limbs = i.op == Op::kMac ? 6 : i.limbs;
        const Wide got = value(engine.memory(), 4 * i.f2, limbs);
        ASSERT_TRUE(got == want) << static_cast<int>(i.op) << " n " << i.limbs << " flag " << i.flag
                                 << " F0 " << i.f0 << " F1 " << i.f1 << " F2 " << i.f2 << ": "
                                 << static_cast<std::int64_t>(got) << ", not "
                                 << static_cast<std::int64_t>(want);
        ASSERT_FALSE(engine.hazard());
        // Nothing else is written.
        for (int limb = 0; limb < limbs; ++limb) {
            const auto place = static_cast<std::size_t>(4 * i.f2 + limb);
            memory[place] = engine.memory()[place];
        }
        ASSERT_EQ(memory, engine.memory());
    }
}

TEST(Engine, InstructionsTakeTheClocksOfTheTable) {
    std::mt19937_64 random(2);
    for (int n = 0; n < 100'000; ++n) {
        const auto word = static_cast<std::uint32_t>(random());
        std::vector<std::uint32_t> program(2, word);
        Engine engine(program, empty_memory());
        QuietBoard board;
        const std::uint64_t begin = engine.clock();
        const int taken = engine.step(board);
        ASSERT_EQ(taken, clocks(decode(word)));
        ASSERT_EQ(engine.clock(), begin + static_cast<std::uint64_t>(taken));
    }
}

TEST(Engine, OverlapsTellsEveryHazard) {
    const int fields[] = {10, 11, 12, 13, power(3), power(20), power(40), power(50)};
    std::set<Op> seen;
    for (int op = 0; op < 16; ++op) {
        for (int n = 0; n < 8 * 4 * 8 * 4; ++n) {
            const Instruction i = instruction(Op(op), n / 256 % 4 + 1, fields[n % 4],
                                              fields[n / 4 % 8], fields[n / 32 % 4], n / 128 % 2);
            Engine engine = engine_of({i}, empty_memory());
            QuietBoard board;
            engine.step(board);
            ASSERT_TRUE(overlaps(i) || !engine.hazard()) << op << " " << i.f0 << " " << i.f1;
            if (engine.hazard()) seen.insert(i.op);
        }
    }
    EXPECT_EQ(seen, (std::set<Op>{Op::kMull, Op::kMac, Op::kShr}));
}

TEST(Engine, InstructionsAreTheirWords) {
    std::mt19937_64 random(3);
    for (int n = 0; n < 100'000; ++n) {
        const auto word = static_cast<std::uint32_t>(random());
        ASSERT_EQ(encode(decode(word)), is_whole(word) ? word : word ^ kParity);
        ASSERT_EQ(is_whole(word), __builtin_popcount(word) % 2 == 1);
    }
    EXPECT_FALSE(is_whole(0));
}

TEST(Engine, PutsOutNothingFromAChangedInstructionOn) {
    struct Ear : QuietBoard {
        int heard = 0;
        void out(int, int, std::int16_t, std::uint64_t) { ++heard; }
    };
    const Instruction put = instruction(Op::kOut, 2, 8, 20, 0);
    const Instruction sum = instruction(Op::kAdd, 3, 8, 9, 10);
    for (int bit = 0; bit < 32; ++bit) {
        for (const int changed : {0, 1, 2}) {
            std::vector<std::uint32_t> program(4);
            const Instruction lines[] = {put, sum, put};
            for (std::size_t n = 0; n < 3; ++n) program[n] = encode(lines[n]);
            program[std::size_t(changed)] ^= std::uint32_t(1) << bit;
            Engine engine(program, empty_memory());
            Ear board;
            for (int n = 0; n < 3; ++n) {
                ASSERT_EQ(engine.changed(), n > changed);
                engine.step(board);
            }
            EXPECT_TRUE(engine.changed());
            EXPECT_EQ(board.heard, changed == 0 ? 0 : 2) << bit;
        }
    }
}

TEST(Engine, FlagsAreOfTheResultExactly) {
    std::mt19937_64 random(4);
    for (int n = 0; n < 10'000; ++n) {
        std::vector<std::int16_t> memory = random_memory(random);
        const int f0 = 8 + n % 4;
        const int f1 = 8 + n / 4 % 4;
        const Wide sum = value(memory, 4 * f0, 3) - value(memory, 4 * f1, 3);
        // Compares without a result; counts in word 20 whether it was negative, in 21 whether zero.
        Engine engine = engine_of(
            {instruction(Op::kSub, 3, f0, f1, 0), branch(kNegative, 4), branch(kIsZero, 6),
             branch(kAlways, 7), instruction(Op::kMull, 3, 0, power(0), 20), branch(kAlways, 7),
             instruction(Op::kMull, 3, 0, power(0), 21)},
            memory);
        QuietBoard board;
        while (engine.place(false) != 8) engine.step(board);
        memory[80] = sum < 0 ? 1 : memory[80];
        memory[84] = sum == 0 ? 1 : memory[84];
        ASSERT_EQ(engine.memory()[80], memory[80]) << n;
        ASSERT_EQ(engine.memory()[84], memory[84]) << n;
    }
}

/// Due and tick in clocks that a test says.
struct TimedBoard : QuietBoard {
    std::set<std::uint64_t> dues, ticks;
    bool due(std::uint64_t clock) { return dues.count(clock) > 0; }
    bool tick(std::uint64_t clock) { return ticks.count(clock) > 0; }
};

TEST(Engine, ForegroundBeginsThreeClocksBehindDueAtAnInstructionsEnd) {
    for (std::uint64_t due = 0; due < 30; ++due) {
        // The background turns on the spot, 3 clocks a turn; the foreground ends at once.
        Engine engine = engine_of({branch(kAlways, 0), branch(kAlways | kEnd, 1)}, empty_memory());
        TimedBoard board;
        board.dues = {due};
        std::uint64_t begin = 0;
        do {
            begin = engine.clock();
            engine.step(board);
        } while (!engine.in_foreground());
        ASSERT_GE(begin, due + 3) << due;
        ASSERT_LT(begin, std::max(due + 6, std::uint64_t{5})) << due;
        engine.step(board);
        ASSERT_FALSE(engine.in_foreground());
        ASSERT_FALSE(engine.late());
    }
}

TEST(Engine, ForegroundIsLateIfDueComesUntilTheClockOfItsEnd) {
    for (std::uint64_t again = 11; again < 40; ++again) {
        // Due in clock 10: begins in 13, waits for the tick in 20, ends in 23.
        Engine engine =
            engine_of({branch(kAlways, 0), branch(kNever, 0, true), branch(kAlways | kEnd, 1)},
                      empty_memory());
        TimedBoard board;
        board.dues = {10, again};
        board.ticks = {20, 60};
        while (engine.clock() < 50) engine.step(board);
        EXPECT_EQ(engine.late(), again <= 23) << again;
        // What was late is not run again; what was due behind the end, waits for its tick.
        EXPECT_EQ(engine.in_foreground(), again > 23) << again;
    }
}

TEST(Engine, PagesAndLinksAreOfTheirProgram) {
    // The background's X is page 4 and its Y page 5; routine 8 saves the link and calls 12, which
    // doubles a word of X into Y; the foreground's X is page 6.
    std::vector<std::int16_t> memory = empty_memory();
    memory[4 * 5] = 4;
    memory[4 * 6] = 5;
    memory[4 * 7] = 6;
    memory[4 * (4 * kPageWords + 3)] = 21;
    memory[4 * (6 * kPageWords + 3)] = 55;
    Engine engine = engine_of(
        {branch(kAlways, 2), branch(kAlways, 16), instruction(Op::kOut, 1, 5, kPortX, 0),
         instruction(Op::kOut, 1, 6, kPortY, 0), branch(kAlways | kCall, 8), branch(kAlways, 5),
         Instruction(), Instruction(),  // routines at 8 and 12
         instruction(Op::kIn, 1, kPortLink, 0, 30), branch(kAlways | kCall, 12),
         instruction(Op::kOut, 1, 30, kPortLink, 0), branch(kAlways | kReturn, 0),
         instruction(Op::kMull, 3, kX | 3, power(1), kY | 4), branch(kAlways | kReturn, 0),
         Instruction(), Instruction(),  // the foreground at 16
         instruction(Op::kOut, 1, 7, kPortX, 0),
         instruction(Op::kMull, 3, kX | 3, power(0), kX | 5), branch(kAlways | kEnd, 1)},
        memory);
    TimedBoard board;
    board.dues = {2};
    for (int n = 0; n < 40; ++n) engine.step(board);
    EXPECT_EQ(engine.place(false), 5);
    EXPECT_EQ(engine.memory()[4 * (5 * kPageWords + 4)], 42);
    EXPECT_EQ(engine.memory()[4 * (6 * kPageWords + 5)], 55);
    EXPECT_EQ(engine.memory()[4 * 30], 5);
    EXPECT_FALSE(engine.hazard());
}

TEST(Engine, ConstantsAreNeverWritten) {
    std::mt19937_64 random(5);
    std::vector<std::uint32_t> program(1024);
    for (std::uint32_t& word : program) word = static_cast<std::uint32_t>(random());
    Engine engine(program, empty_memory());
    QuietBoard board;
    for (int n = 0; n < 100'000; ++n) engine.step(board);
    const std::vector<std::int16_t> begin = empty_memory();
    for (std::size_t place = 0; place < kConstantWords * kWordLimbs; ++place) {
        ASSERT_EQ(engine.memory()[place], begin[place]) << place;
    }
    EXPECT_NE(engine.memory(), begin);
}

TEST(Engine, RefusesStoresThatNoAddressFits) {
    const std::vector<std::uint32_t> program(256);
    EXPECT_THROW(Engine(std::vector<std::uint32_t>(300), empty_memory()), std::invalid_argument);
    EXPECT_THROW(Engine(std::vector<std::uint32_t>(65536), empty_memory()), std::invalid_argument);
    EXPECT_THROW(Engine(program, empty_memory(128)), std::invalid_argument);
    EXPECT_THROW(Engine(program, empty_memory(300)), std::invalid_argument);
    EXPECT_NO_THROW(Engine(program, empty_memory(512)));
}

}  // namespace curvecore::engine::engine_test
