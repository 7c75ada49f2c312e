// SPDX-License-Identifier: Apache-2.0
// The engine: one multiplier, one instruction after the other (hls/instruction.hpp), of two
// programs, bit for bit and clock for clock. Twin: rtl/engine/motion_engine.sv.
//
// Work that happens once per sample, tick, step, segment or byte is a program of it. A board around
// it makes due and tick, answers ports and conditions, and takes what is put out.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "hls/instruction.hpp"

namespace curvecore {
namespace engine {

/// A board where nothing happens. Other boards derive from it and hide what they do.
struct QuietBoard {
    /// Pulses in a clock: the foreground is due; what BR with the flag waits for.
    bool due(std::uint64_t) { return false; }
    bool tick(std::uint64_t) { return true; }
    /// The foreground was still running when it was due, in a clock; what it does then is late.
    void late(std::uint64_t) {}
    /// Condition 3..15 in a clock.
    bool condition(int, std::uint64_t) { return false; }
    /// Limb of a port that is taken in a clock; it was asked for two clocks before.
    std::int16_t in(int /*port*/, int /*limb*/, std::uint64_t) { return 0; }
    /// Limb that is at the board in a clock.
    void out(int /*port*/, int /*limb*/, std::int16_t, std::uint64_t) {}
    /// Limb that an operand is in a clock.
    void read(std::int16_t, std::uint64_t) {}
    /// Limb that is written in a clock, at 4 word + limb.
    void wrote(int /*place*/, std::int16_t, std::uint64_t) {}
};

/// Returns memory of 2^n words, the constants in it.
inline std::vector<std::int16_t> empty_memory(int words = 256) {
    std::vector<std::int16_t> memory(std::size_t(kWordLimbs) * std::size_t(words));
    for (int place = 0; place <= kZero; ++place) memory[std::size_t(place)] = constant_limb(place);
    return memory;
}

class Engine {
  public:
    /// @throws std::invalid_argument unless there are 2^n instructions, n = 1..15, and 2^n words of
    /// 4 limbs, n = 8..12
    Engine(std::vector<std::uint32_t> program, std::vector<std::int16_t> memory)
        : program_(std::move(program)), memory_(std::move(memory)) {
        const std::size_t limbs = memory_.size();
        if (!is_power_of_two(program_.size(), 1, 15)) {
            throw std::invalid_argument("an engine has 2^n instructions, n = 1..15");
        }
        if (!is_power_of_two(limbs, 10, 14)) {
            throw std::invalid_argument("an engine has 2^n words of 4 limbs, n = 8..12");
        }
        page_mask_ = int(limbs) / (kWordLimbs * kPageWords) - 1;
        place_mask_ = int(program_.size()) - 1;
    }

    /// Executes the next instruction; returns its clocks. A wait for a tick ends with the tick.
    template <class Board>
    int step(Board& board) {
        const std::uint64_t start = now_;
        watch(board, start - 2);
        running_ = foreground_ ? 1 : 0;
        int& place = threads_[running_].place;
        const std::uint32_t word = program_[std::size_t(place)];
        const Instruction i = decode(word);
        changed_ = changed_ || !is_whole(word);
        place = (place + 1) & place_mask_;
        if (is_branch(i.op)) {
            branch(board, i);
        } else if (i.op == Op::kOut) {
            put_out(board, i);
        } else {
            compute(board, i);
        }
        return int(now_ - start);
    }

    /// Clock of the next instruction's first term; the first after a reset is 0.
    std::uint64_t clock() const { return now_; }
    /// Place of a program's next instruction.
    int place(bool foreground) const { return threads_[foreground ? 1 : 0].place; }
    /// Page X of a program, or Y.
    int page(bool foreground, bool y) const { return threads_[foreground ? 1 : 0].page[y ? 1 : 0]; }
    /// Returns whether the last instruction was of the foreground.
    bool in_foreground() const { return running_ == 1; }
    /// Returns whether a foreground program was still running when the next was due.
    bool late() const { return late_; }
    /// Returns whether an instruction was not as it was made: nothing is put out any more.
    bool changed() const { return changed_; }
    /// Returns whether an operand was read in the clock in which the same instruction wrote it, or
    /// after.
    bool hazard() const { return hazard_; }
    /// Memory, limb by limb; for loading and looking between instructions.
    std::vector<std::int16_t>& memory() { return memory_; }

  private:
    struct Thread {
        int place = 0;
        int link = 0;
        int page[2] = {0, 0};
        bool negative = false;
        bool zero = false;
    };
    struct Write {
        int place;
        std::int16_t limb;
        std::uint64_t clock;
    };

    static bool is_power_of_two(std::size_t size, int least, int most) {
        return (size & (size - 1)) == 0 && size >= std::size_t(1) << least &&
               size <= std::size_t(1) << most;
    }

    /// Sees due in the clocks before `until`.
    template <class Board>
    void watch(Board& board, std::uint64_t until) {
        for (; seen_ < until; ++seen_) {
            if (!board.due(seen_)) continue;
            if (foreground_) board.late(seen_);
            late_ = late_ || foreground_;
            foreground_ = true;
        }
    }

    template <class Board>
    void branch(Board& board, const Instruction& i) {
        Thread& thread = threads_[running_];
        const bool known = i.op == Op::kBr;
        while (known && i.flag && !board.tick(now_)) ++now_;
        const int code = i.f0 & 15;
        const bool condition = code == kNever      ? false
                               : code == kNegative ? thread.negative
                               : code == kIsZero   ? thread.zero
                                                   : board.condition(code, now_);
        if (known && condition != ((i.f0 & kNot) != 0)) {
            const int back = thread.place;
            thread.place = (i.f0 & kReturn) != 0 ? thread.link : (i.f1 << 8 | i.f2) & place_mask_;
            if ((i.f0 & kCall) != 0) thread.link = back;
            if ((i.f0 & kEnd) != 0 && in_foreground()) {
                watch(board, now_ + 1);
                foreground_ = false;
            }
        }
        now_ += 3;
    }

    template <class Board>
    void put_out(Board& board, const Instruction& i) {
        const int port = i.f1 & 31;
        std::int16_t value = 0;
        for (int limb = 0; limb < i.limbs; ++limb) {
            value = read(board, wide_limb(i.f0, limb));
            if (!changed_) board.out(port, limb, value, now_ + 2);
            ++now_;
        }
        Thread& thread = threads_[running_];
        if (port == kPortX || port == kPortY) thread.page[port] = value & page_mask_;
        if (port == kPortLink) thread.link = value & place_mask_;
        ++now_;
    }

    template <class Board>
    void compute(Board& board, const Instruction& i) {
        const int a = i.op == Op::kMadr ? i.f2 : i.f0;
        sum_ = 0;
        for (int column = 0; column <= last_column(i); ++column) {
            const bool rounds = is_high(i.op) && !i.flag && column == 3;
            const std::int64_t half = rounds ? sum_ >> (kLimbBits - 1) & 1 : 0;
            sum_ = (sum_ >> kLimbBits) + half;
            const std::uint64_t ends = now_ + std::uint64_t(terms(i, column));
            if (is_sum(i.op)) {
                term(board, wide_limb(i.f0, column), 0);
                term(board, i.op == Op::kSub ? kMinusOne : 0, second_limb(i, column));
            } else if (is_product(i.op)) {
                const int first = first_limb(i, column);
                for (int n = 0; n < products(i, column); ++n) {
                    term(board, wide_limb(a, first + n), second_limb(i, column - first - n));
                }
                if (adds(i, column)) {
                    const bool wide = i.op == Op::kMac;
                    term(board, wide ? wide_limb(i.f2, column) : wide_limb(i.f0, column - 3), 0);
                }
            }
            now_ = ends;
            if (column >= first_column(i)) write(board, i, column);
        }
        for (int n = 0; n < written_; ++n) memory_[std::size_t(writes_[n].place)] = writes_[n].limb;
        written_ = 0;
        now_ += 4;
    }

    template <class Board>
    void term(Board& board, int a, int b) {
        sum_ += std::int64_t(read(board, a)) * read(board, b);
        ++now_;
    }

    /// Writes the limb of a column whose last term was a clock ago.
    template <class Board>
    void write(Board& board, const Instruction& i, int column) {
        const int limb = column - first_column(i);
        const std::uint64_t clock = now_ - 1 + 4;
        const int sign = is_product(i.op) ? kLimbBits - 1 : kLimbBits;
        const bool last = column == last_column(i);
        Thread& thread = threads_[running_];
        int value = int(sum_ & 0x7fff) - (last && (sum_ >> sign & 1) != 0 ? 0x8000 : 0);
        bool negative = is_product(i.op) ? value < 0 : sum_ < 0;
        if (i.op == Op::kIn) {
            const int port = i.f0 & 31;
            value = board.in(port, limb, clock - 1);
            if (port == kPortLink) value = thread.link;
            negative = value < 0;
        }
        thread.negative = negative;
        thread.zero = value == 0 && (limb == 0 || thread.zero);
        const int place = wide_limb(i.f2, limb);
        if (place < kConstantWords * kWordLimbs) return;
        writes_[written_++] = {place, std::int16_t(value), clock};
        board.wrote(place, std::int16_t(value), clock);
    }

    template <class Board>
    std::int16_t read(Board& board, int place) {
        std::int16_t limb = memory_[std::size_t(place)];
        for (int n = 0; n < written_; ++n) {
            const Write& one = writes_[n];
            if (one.place != place || one.clock > now_) continue;
            hazard_ = true;
            if (one.clock < now_) limb = one.limb;
        }
        board.read(limb, now_);
        return limb;
    }

    int word(int field) const {
        return field < 128
                   ? field
                   : threads_[running_].page[field >> 5 & 1] * kPageWords + field % kPageWords;
    }
    int wide_limb(int field, int limb) const {
        return kWordLimbs * (word(field) | limb >> 2) + (limb & 3);
    }
    int second_limb(const Instruction& i, int limb) const {
        if (!is_power(i.f1)) return kWordLimbs * word(i.f1) + limb;
        return (i.f1 >> 4 & 3) == limb ? i.f1 & 15 : kZero;
    }

    std::vector<std::uint32_t> program_;
    std::vector<std::int16_t> memory_;
    int page_mask_ = 0;
    int place_mask_ = 0;
    Thread threads_[2] = {Thread(), Thread{1, 0, {0, 0}, false, false}};
    int running_ = 0;
    bool foreground_ = false;
    bool late_ = false;
    bool changed_ = false;
    bool hazard_ = false;
    std::uint64_t now_ = 4;   // clock of the next term
    std::uint64_t seen_ = 0;  // clocks whose due was looked at
    std::int64_t sum_ = 0;
    Write writes_[6] = {};  // of this instruction
    int written_ = 0;
};

}  // namespace engine
}  // namespace curvecore
