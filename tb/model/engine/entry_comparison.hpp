// SPDX-License-Identifier: Apache-2.0
// Words of two streams and the guard of time, as microcode (rtl/engine/programs/words.asm and
// ledger.asm) beside the rule: hls/word_entry.hpp, hls/word_ledger.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "rtl/engine/assembler/source.hpp"
#include "rtl/engine/compiler/motion_program.hpp"
#include "rtl/engine/compiler/word_numbers.hpp"
#include "tb/support/microcode/microcode_machine.hpp"
#include "tb/support/segments/random_streams.hpp"
#include "tb/support/segments/word_rule.hpp"

namespace curvecore::tb {

/// Programs, as MicrocodeMachine::run has them.
constexpr int kEntryReset = 0;
constexpr int kEnter = 1;  // + 1: of a profile word
constexpr int kGuard = 3;

struct EntryCase {
    sysc::CoreParameters core;
    std::array<int, 2> queues{{64, 16}};    // words: segments, pieces
    int most_time = hls::kMaxTimeExponent;  // pieces have 2^most_time ticks at most
};

inline assembler::Assembly words_microcode(const EntryCase& of) {
    assembler::Assembly assembly;
    MicrocodeMachine::dispatch(assembly,
                               {"reset", "enter_segment_word", "enter_piece_word", "guard"});
    define_words(of.core, of.queues[0], of.queues[1], assembly);
    for (const char* source : {"ports", "words", "segment_words", "piece_words", "ledger"}) {
        assemble_source(std::string(RTL_DIR) + "/engine/programs/" + source + ".asm", assembly);
    }
    assemble_table_words(std::string(RTL_DIR) + "/engine/programs", of.core, assembly);
    assembly.from({"reset", 0, ""});
    assembly.label("reset");
    assembly.put_starts();
    assembly.give_back();
    assembly.finish();
    return assembly;
}

/// The ports of the streams: rtl/engine/programs/ports.asm.
class StreamPorts {
  public:
    StreamPorts(MicrocodePorts& ports, std::uint16_t digest) {
        ports.give = [this, digest](int port, int limb) {
            if (port == 4) return limb_of(words[stream()], limb);
            if (port == 5) return static_cast<std::int16_t>(after());
            return static_cast<std::int16_t>(port == 19 ? digest : 0);
        };
        ports.take = [this](int port, int, std::int16_t value) {
            if (port == 5) ++taken[stream()];
            if (port == 6) before_ = static_cast<std::uint16_t>(value);
            if (port == 7) select_ = static_cast<unsigned>(value);
            if (port == 12) reported |= static_cast<unsigned>(value);
            if (port == 10) reported |= 32;
            if (port == 9) reported |= 256;
        };
        ports.condition = [this](int code) {
            if (code == 6) {
                const unsigned check = after();
                return get(hls::kCheckField, words[stream()]) == ((check >> 8 ^ check) & 0xff);
            }
            return code == 9 && get(hls::kTagField, words[stream()]) == (select_ >> 2 & 15);
        };
    }

    std::uint64_t words[2] = {};  // that wait
    int taken[2] = {};
    unsigned reported = 0;

    static std::int16_t limb_of(std::uint64_t word, int limb) {
        return static_cast<std::int16_t>(limb < 2 ? word >> 15 * limb & 0x7fff : word >> 30);
    }

  private:
    std::size_t stream() const { return select_ & 1; }
    /// The check after the word, as RTL has it.
    unsigned after() const {
        std::uint64_t word = words[stream()] & hls::mask({0, 44});
        if ((select_ & 2) != 0) word &= hls::mask({0, 36});
        const unsigned top = before_ >> 8;
        return (before_ << 8 ^ top << 3 ^ top ^
                static_cast<unsigned>(word ^ word >> 16 ^ word >> 32)) &
               0xffff;
    }

    unsigned before_ = 0;
    unsigned select_ = 0;
};

/// The entry's twins and the microcode, word by word.
class EntryComparison {
  public:
    EntryComparison(const EntryCase& of, const assembler::Assembly& assembly,
                    MicrocodeMachine& machine, std::uint64_t seed)
        : of_(of),
          machine_(machine),
          random_(seed),
          digest_(static_cast<std::uint16_t>(random_())),
          ports_(machine.ports(), digest_),
          memory_(static_cast<std::size_t>(*assembly.defined("stop_begin"))) {
        begin_[kSegments] = static_cast<std::size_t>(*assembly.defined("segment_begin"));
        begin_[kPieces] = static_cast<std::size_t>(*assembly.defined("profile_begin"));
        runs_ = static_cast<int>(random_() % RandomStreams::kChanges);
        of_.queues[kSegments] = static_cast<int>(*assembly.defined("segment_queue_words"));
    }

    /// Lets in random programs from a reset on; returns the number of words that differ.
    int programs(int count, bool whole = false) {
        RandomStreams maker(of_.core, digest_, random_(), of_.most_time);
        Streams streams;
        for (int n = 0; n < count; ++n) maker.program(streams, !whole && random_() % 16 == 0);
        if (!whole && random_() % 4 != 0) maker.change(streams, runs_++ % RandomStreams::kChanges);
        if (!whole && random_() % 4 == 0) maker.damage(streams);
        std::array<std::deque<std::uint64_t>, 2> words = streams.words();
        reset(whole ? 1 : 1 + static_cast<std::int64_t>(random_() >> (35 + random_() % 29)));
        int differ = 0;
        for (int still = 0; differ == 0 && still < 200; ++still) {
            const Stream stream = random_() % 2 == 0 ? kSegments : kPieces;
            if (!words[stream].empty() && offer(stream, words[stream].front(), differ)) {
                words[stream].pop_front();
                still = 0;
            }
            if (random_() % 16 == 0) take_segment();
            if (random_() % 8 == 0) tick(differ);
        }
        return differ + (machine_.ports().memory != memory_ ? 1 : 0);
    }

    std::int64_t words() const { return words_; }
    const int (&faults() const)[5] { return faults_; }
    int stays() const { return stays_; }
    int most_clocks() const { return most_clocks_; }
    int holds() const { return holds_; }
    int begins() const { return begins_; }
    int short_queues() const { return short_queues_; }
    int most_guard_clocks() const { return most_guard_clocks_; }
    double mean_clocks() const {
        return static_cast<double>(clocks_) / static_cast<double>(words_);
    }

  private:
    void reset(std::int64_t stop_ticks) {
        rule_.emplace(of_.core, of_.queues, digest_);
        put_ = {};
        ports_.reported = 0;
        guard_ = hls::UnderrunGuard();
        next_.reset();
        active_ = false;
        stop_ticks_ = stop_ticks;
        std::fill(memory_.begin(), memory_.end(), std::int16_t{0});
        write_powers(memory_);
        machine_.ports().memory = memory_;
        machine_.reset(kEntryReset);
        machine_.set("stop_ticks", stop_ticks_);
        machine_.set("twice_stop", 2 * stop_ticks_);
        machine_.set("queued_ticks", 0);
        machine_.set("finals", 0);
    }

    /// Runs a program among others, which leave anything in the words that all share.
    int run(int program) {
        machine_.spoil_locals(random_);
        return machine_.run(program);
    }

    /// Offers a word to both; returns whether they have taken it.
    bool offer(Stream stream, std::uint64_t word, int& differ) {
        const int taken = ports_.taken[stream];
        const int other = ports_.taken[1 - stream];
        ports_.words[stream] = word;
        ports_.words[1 - stream] = ~word;
        const bool cut = rule_->fault() != 0;
        const WordRule::Fate fate = rule_->offer(stream, word);
        const bool takes = fate != WordRule::Fate::kStays;
        if (fate == WordRule::Fate::kPassed) put(stream, word);
        for (int n = 0; n < 5 && !cut; ++n) faults_[n] += rule_->fault() >> n & 1;

        const int clocks = run(kEnter + static_cast<int>(stream));
        differ += ports_.taken[stream] != taken + (takes ? 1 : 0) ? 1 : 0;
        differ += ports_.taken[1 - stream] != other ? 1 : 0;
        differ += machine_.get("word_faults") != rule_->fault() ? 1 : 0;
        differ += ports_.reported != report() ? 1 : 0;
        differ += machine_.get("segment_words") != rule_->held(kSegments) ? 1 : 0;
        differ += machine_.get("profile_words") != rule_->held(kPieces) ? 1 : 0;
        differ += machine_.get("segments") != rule_->frames(kSegments) ? 1 : 0;
        differ += machine_.get("pieces") != rule_->frames(kPieces) ? 1 : 0;
        if (takes) {
            ++words_;
            clocks_ += clocks;
            most_clocks_ = std::max(most_clocks_, clocks);
        } else {
            ++stays_;
        }
        return takes;
    }

    /// Puts a word into the ring of its queue.
    void put(Stream stream, std::uint64_t word) {
        const bool wraps = stream == kSegments || may_wrap(word);
        const std::size_t end = 3 * static_cast<std::size_t>(of_.queues[stream]);
        if (wraps && put_[stream] >= end) put_[stream] = 0;
        for (int limb = 0; limb < 3; ++limb) {
            memory_[begin_[stream] + put_[stream]++] = StreamPorts::limb_of(
                stream == kPieces ? static_cast<std::uint64_t>(queued(word)) : word, limb);
        }
    }

    /// Takes a whole frame out of a queue.
    WordRule::Frame take_frame(Stream stream) {
        const WordRule::Frame frame = rule_->take(stream);
        const bool of_segments = stream == kSegments;
        machine_.set(of_segments ? "segment_words" : "profile_words", rule_->held(stream));
        machine_.set(of_segments ? "segments" : "pieces", rule_->frames(stream));
        return frame;
    }
    void take_segment() {
        if (rule_->frames(kSegments) > 0) take_frame(kSegments);
    }

    unsigned report() const {
        return static_cast<unsigned>(rule_->fault()) | (guard_.short_queue() ? 32U : 0U) |
               (guard_.underrun() ? 256U : 0U);
    }

    /// Ticks: the guard looks, then the present piece goes on, and the next one comes.
    void tick(int& differ) {
        const std::int64_t rest = active_ ? end() - time_ : 0;
        guard_.tick(rule_->ledger(), {active_, active_ && present_.final, rest}, rule_->full(),
                    stop_ticks_);
        show_path();
        most_guard_clocks_ = std::max(most_guard_clocks_, run(kGuard));
        differ += machine_.get("underrun_hold") != (guard_.hold() ? 1 : 0) ? 1 : 0;
        differ += !active_ && machine_.get("may_begin") != (guard_.may_begin() ? 1 : 0) ? 1 : 0;
        differ += ports_.reported != report() ? 1 : 0;
        holds_ += guard_.hold() ? 1 : 0;
        begins_ += guard_.may_begin() ? 1 : 0;
        short_queues_ += guard_.short_queue() ? 1 : 0;

        if (active_) {
            time_ += static_cast<std::int64_t>(random_() >> (27 + random_() % 37));
            if (time_ >= end()) {
                active_ = !present_.final;
                time_ = active_ && next_ ? random_() & 0xffff : end();
                if (active_ && next_) begin();
            }
        } else if (next_ && guard_.may_begin() && random_() % 2 == 0) {
            time_ = 0;
            begin();
        }
        if (!next_ && rule_->frames(kPieces) > 0) next_ = WordRule::piece_of(take_frame(kPieces));
        differ += machine_.get("queued_ticks") != rule_->ledger().queued_ticks() ? 1 : 0;
    }

    std::int64_t end() const { return std::int64_t{present_.ticks} << hls::kRateFrac; }

    void begin() {
        active_ = true;
        present_ = *next_;
        next_.reset();
        rule_->ledger().take(present_.ticks, present_.final);
        machine_.set("queued_ticks", machine_.get("queued_ticks") - present_.ticks);
        machine_.set("finals", machine_.get("finals") - (present_.final ? 1 : 0));
        time_ = std::min(time_, end() - 1);
    }

    /// Puts the piece into the words of path.asm; those of none are anything.
    void show_path() {
        const auto any = [&] { return static_cast<std::int64_t>(random_() >> 28); };
        machine_.set("active", active_ ? 1 : 0);
        machine_.set("end", active_ ? end() : any());
        machine_.set("time", active_ ? time_ : any());
        machine_.set("final", active_ ? present_.final : random_() & 1);
    }

    EntryCase of_;
    MicrocodeMachine& machine_;
    std::mt19937_64 random_;
    std::uint16_t digest_;
    StreamPorts ports_;
    std::vector<std::int16_t> memory_;
    std::size_t begin_[2] = {};
    std::array<std::size_t, 2> put_{};
    std::optional<WordRule> rule_;
    hls::UnderrunGuard guard_;
    std::int64_t stop_ticks_ = 1;
    bool active_ = false;
    hls::ProfileWords present_;
    std::int64_t time_ = 0;
    std::optional<hls::ProfileWords> next_;
    std::int64_t words_ = 0;
    std::int64_t clocks_ = 0;
    int faults_[5] = {};
    int stays_ = 0;
    int most_clocks_ = 0;
    int runs_ = 0;
    int holds_ = 0;
    int begins_ = 0;
    int short_queues_ = 0;
    int most_guard_clocks_ = 0;
};

}  // namespace curvecore::tb
