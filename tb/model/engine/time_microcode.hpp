// SPDX-License-Identifier: Apache-2.0
// The microcode of time (rate.asm, stops.asm, path.asm, pieces.asm), and its rates beside
// hls::TimeScaler.
#pragma once

#include "hls/path_kernel.hpp"
#include "hls/stop_schedule.hpp"
#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/assembler/worst_case.hpp"
#include "tb/support/microcode/microcode_machine.hpp"

namespace curvecore::tb {

/// The board's memory, in entries of 16 bits.
constexpr int kQueueWords = 320;
constexpr int kProfileBegin = 270;
constexpr int kProfileEnd = kProfileBegin + 3 * kQueueWords;
constexpr int kStopBegin = 32768 - 300;  // its second bank has a limb more
constexpr int kBankEntries = 3 * hls::kStopSteps;
constexpr int kMemoryEntries = kStopBegin + 2 * kBankEntries;

enum TimeProgram { kReset, kFetch, kRate, kTick, kTimeBegins };

/// The programs, and the most clocks of each.
struct TimeMicrocode {
    assembler::Assembly assembly;
    std::vector<int> bounds;
};

inline TimeMicrocode time_microcode() {
    TimeMicrocode code;
    assembler::Assembly& assembly = code.assembly;
    const std::vector<std::string> names{"reset", "fetch_piece", "rate_tick", "tick",
                                         "time_begins"};
    assembly.define("profile_begin", kProfileBegin);
    assembly.define("profile_end", kProfileEnd);
    assembly.define("stop_begin", kStopBegin);
    assembly.define("stop_middle", kStopBegin + kBankEntries);
    MicrocodeMachine::dispatch(assembly, names);
    for (const char* file : {"ports", "path", "stops", "rate", "pieces"}) {
        assemble_source(std::string(RTL_DIR) + "/engine/programs/" + file + ".asm", assembly);
    }
    assembly.label("reset");
    assembly.put_starts();
    assembly.give_back();
    assembly.finish();
    for (const std::string& name : names) code.bounds.push_back(worst_case(assembly, name));
    return code;
}

/// Writes a profile's word into the memory.
inline void write_word(std::vector<std::int16_t>& memory, int place, std::uint64_t word) {
    const auto at = static_cast<std::size_t>(place);
    const std::int64_t value = queued(word);
    memory.at(at) = static_cast<std::int16_t>(value & 0x7fff);
    memory.at(at + 1) = static_cast<std::int16_t>(value >> 15 & 0x7fff);
    memory.at(at + 2) = static_cast<std::int16_t>(value >> 30);
}

struct TimeBounds {
    std::int64_t acceleration = 1 << 20;
    std::int64_t slope = 1 << 26;
};

/// Any bounds that fit, of any size.
inline TimeBounds any_bounds(std::mt19937_64& random, std::int64_t least = 8) {
    const auto any = [&](int bits) {
        return static_cast<std::int64_t>(random() >> (64 - bits) >> random() % bits);
    };
    TimeBounds bounds;
    do {
        bounds.acceleration = random() % 3 == 0 ? any(32) : (1 << 30) + any(30);
        const int kind = static_cast<int>(random() % 3);
        bounds.slope = kind == 0   ? any(33)
                       : kind == 1 ? (1 + any(8)) * bounds.acceleration
                                   : bounds.acceleration + any(4);
    } while (bounds.acceleration < least ||
             !hls::TimeScaler::fits(bounds.acceleration, bounds.slope));
    return bounds;
}

inline std::int32_t any_target(std::mt19937_64& random) {
    if (random() % 4 == 0) return ref::kFineRate - 2 + static_cast<std::int32_t>(random() % 5);
    if (random() % 8 == 0) return 65532 + static_cast<std::int32_t>(random() % 5);
    const std::uint64_t kind = random() % 4;
    return kind == 0 ? 0 : kind < 3 ? 65536 : static_cast<std::int32_t>(random() % 65537);
}

/// A rate at which a stop takes a branch, or about the least of these.
inline std::int32_t any_running(std::mt19937_64& random) {
    if (random() % 3 == 0) return 65536;
    const auto more = static_cast<std::int32_t>(random() % (random() % 4 == 0 ? 5 : 28675));
    return ref::kBranchRate - 2 + more;
}

/// Steps that need not match each other.
inline hls::StopStep any_step(std::mt19937_64& random, bool last) {
    hls::StopStep step;
    step.ticks = static_cast<std::int32_t>(random() % 20 == 0  ? 1 + random() % 2047
                                           : random() % 2 == 0 ? 1 + random() % 3
                                                               : 1 + random() % 12);
    step.change = static_cast<std::int32_t>(static_cast<std::uint32_t>(random()));
    step.change >>= random() % 32;
    step.last = last;
    return step;
}

/// A comparison of the twin with the kernels.
class TimeComparison {
  public:
    TimeComparison(const TimeMicrocode& code, MicrocodeMachine& machine)
        : machine_(machine), bounds_(code.bounds), most_(code.bounds.size()) {
        machine_.ports().memory.resize(kMemoryEntries);
        write_powers(machine_.ports().memory);
        std::vector<std::int16_t>& memory = machine_.ports().memory;
        std::fill(memory.begin() + kProfileEnd, memory.begin() + kStopBegin, std::int16_t{-1});
        machine_.reset(kReset);
        same(machine_.starts_hold(), true);
        machine_.set("pieces", 0);
        machine_.set("may_begin", 1);
        machine_.set("profile_words", 0);
    }

    int differ() const { return differ_; }
    std::int64_t words() const { return words_; }
    std::int64_t ticks() const { return ticks_made_; }
    std::int64_t stop_ticks() const { return stop_ticks_; }
    const std::vector<int>& most() const { return most_; }
    const std::vector<int>& bounds() const { return bounds_; }

  protected:
    void run(TimeProgram program) {
        const auto n = static_cast<std::size_t>(program);
        machine_.spoil_locals(random_);
        most_[n] = std::max(most_[n], machine_.run(program));
        differ_ += most_[n] > bounds_[n] ? 1 : 0;
    }
    void same(std::int64_t a, std::int64_t b) {
        ++words_;
        differ_ += a != b ? 1 : 0;
    }
    void expect(const char* word, std::int64_t value) { same(machine_.get(word), value); }
    /// Checks `standing` after a tick: between programs, and at a rate of 0 that stays, soon.
    void standing(std::int32_t target, std::int32_t rate, bool active) {
        ++ticks_made_;
        stop_ticks_ += scaler_.stopping() ? 1 : 0;
        for (const char* truth : {"standing", "resting", "settling", "stopping", "unsettled"}) {
            same(machine_.get(truth) >> 1, 0);
        }
        const bool stands = machine_.get("standing") != 0;
        if (target != 0 || !active) {
            same(stands, target == 0);
            stood_ = false;
            zeros_ = 0;
            return;
        }
        zeros_ = rate == 0 && !scaler_.stopping() ? zeros_ + 1 : 0;
        same(stands && zeros_ == 0, 0);
        same(stood_ && !stands, 0);
        same(stands || zeros_ <= soon_, 1);
        stood_ = stands;
    }
    void set_bounds(const TimeBounds& bounds) {
        // Ticks from a rate below 2^-16 to rest, at most.
        soon_ = bounds.acceleration >> 17 != 0 ? 4 : 400 + (1 << 16) / bounds.slope;
        machine_.set("hold_acceleration", bounds.acceleration);
        machine_.set("hold_slope", bounds.slope);
        scaler_ = hls::TimeScaler(bounds.acceleration, bounds.slope);
        run(kTimeBegins);
        expect("unsettled", 1);
        expect("wait", hls::kStopLead - 1);
    }

    MicrocodeMachine& machine_;
    hls::TimeScaler scaler_{1, 1};
    int differ_ = 0;

  private:
    std::vector<int> bounds_;
    std::vector<int> most_;
    std::mt19937_64 random_{1};
    bool stood_ = false;      // at rest, with a program under way
    std::int64_t zeros_ = 0;  // ticks of the rate 0
    std::int64_t soon_ = 0;
    std::int64_t words_ = 0;
    std::int64_t ticks_made_ = 0;
    std::int64_t stop_ticks_ = 0;
};

/// The rate alone: any events, whether nothing is under way, and steps.
class RateComparison : public TimeComparison {
  public:
    using TimeComparison::TimeComparison;

    /// Makes ticks with targets, branches, and ticks before which nothing is under way, each in one
    /// of a random number of ticks.
    void ticks(std::mt19937_64& random, int count) {
        set_bounds(any_bounds(random));
        const auto any_of = [&](std::uint64_t often, std::uint64_t rarely) {
            const std::uint64_t most[] = {often, 12, 60, rarely};
            return 1 + random() % most[random() % 4];
        };
        const std::uint64_t target_every = any_of(2, 2);
        const std::uint64_t due_every = any_of(1000, 1000);
        const std::uint64_t idle_every = any_of(1000, 1000);
        const std::uint64_t kind = random() % 3;
        const std::int32_t running = any_running(random);
        const auto next_target = [&] {
            const std::uint64_t one_of = random() % 4;
            return kind == 0     ? any_target(random)
                   : one_of == 0 ? 0
                   : one_of == 1 ? running - static_cast<std::int32_t>(kind * (random() % 5))
                                 : running;
        };
        std::int32_t target = next_target();
        std::uint64_t taken = random() % 2 == 0 ? 250 : 255;  // of 256
        const auto steps = [&](std::uint64_t index) {
            std::mt19937_64 of_index(index + seed_);
            hls::StopStep step = any_step(of_index, index % 5 == 4);
            if (index % 5 < 2 && index % 3 != 0) {  // to 0 before the last step, for one
                step.ticks = 1;
                step.change = index % 5 == 0 ? INT32_MIN : 0;
            }
            return step;
        };
        ++seed_;
        bool fresh = true;
        for (int n = 0; n < count && differ_ == 0; ++n) {
            if (random() % target_every == 0) {
                target = next_target();
            }
            const bool idle = fresh || random() % idle_every == 0;
            fresh = fresh && target == 0;
            hls::StopDue due;
            if (random() % due_every == 0) {
                due = hls::StopDue(1 + static_cast<std::int32_t>(random() % 60), random() % 2 == 0);
            }
            if (due.wait > 0) machine_.set("near", 0);
            machine_.set("next_wait", due.wait);
            machine_.set("begins", due.begins ? 1 : 0);
            machine_.set("reading", kStopBegin);
            machine_.set("read", 3 * static_cast<int>(taken % hls::kStopSteps));
            write_word(machine_.ports().memory,
                       kStopBegin + 3 * static_cast<int>(taken % hls::kStopSteps),
                       hls::pack(steps(taken)));
            machine_.set("idle", idle ? hls::kIdleTicks : static_cast<int>(random() % 16));
            const bool active = random() % 16 != 0;
            machine_.set("active", active ? 1 : 0);
            machine_.set("target", target);
            const std::int64_t wait = machine_.get("wait");
            const std::int32_t rate =
                scaler_.tick(target, idle, due, [&] { return steps(taken++); });
            run(kRate);
            expect("rate", rate);
            expect("wait", counted(wait, target, due.wait));
            expect("steady", scaler_.steady() ? 1 : 0);
            if (!scaler_.stopping()) {
                expect("unsettled", scaler_.lands(target, true) ? 1 : 0);
                expect("stop_slope", 0);
            }
            standing(target, rate, active);
            expect("near", -1);
            expect("read", 3 * static_cast<int>(taken % hls::kStopSteps));
        }
    }

  private:
    /// Ticks until a branch is due, at most, after a tick: TimeScaler::count.
    std::int64_t counted(std::int64_t wait, std::int32_t target, std::int32_t told) const {
        if (told > 0) return told;
        if (scaler_.steady() && (target == 0 || wait >= hls::kStopLead)) {
            return wait - (scaler_.passed() ? 1 : 0);
        }
        return std::max<std::int64_t>(wait, hls::kStopLead - 1);
    }

    std::uint64_t seed_ = 0;
};

}  // namespace curvecore::tb
