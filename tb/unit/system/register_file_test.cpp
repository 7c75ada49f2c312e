// SPDX-License-Identifier: Apache-2.0
// rtl/bus/register_file.sv against the description of each register in registers.json.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <set>
#include <string>

#include "Vregister_file.h"
#include "hls/words.hpp"
#include "sysc/cores/clocked_dut.hpp"

namespace curvecore::tb {
namespace {
using nlohmann::json;

constexpr int kWords = 128;
constexpr int kAnswer = 2;            // clocks
constexpr int kFirstAnswer = 1 << 7;  // more, after a reset
constexpr int kMostReads = 3;         // clocks in which programs read, one behind the other
constexpr int kChange = 4;            // clocks in which path and rate change

/// A word as registers.json describes it, with the value that a host expects.
struct Word {
    std::string name;
    bool axis = false;
    bool read = false;
    bool write = false;
    bool setting = false;
    uint32_t value = 0;
};

std::map<int, Word> read_words() {
    std::ifstream file(REGISTERS_JSON);
    const json description = json::parse(file);
    std::map<int, Word> words;
    for (const json& one : description.at("registers")) {
        Word word;
        word.name = one.at("name");
        word.axis = one.at("axis");
        word.read = one.at("read");
        word.write = one.at("write");
        word.setting = word.read && word.write;
        for (const json& field : one.at("fields")) {
            if (field.at("clears").get<bool>()) word.setting = false;
            word.value |= field.at("reset").get<uint32_t>() << field.at("low").get<int>();
        }
        const int first = one.at("address").get<int>() / 4;
        const int stride = description.at("axes").at("stride").get<int>() / 4;
        for (int axis = 0; axis < (word.axis ? CFG_Axes : 1); ++axis) {
            words[first + axis * stride] = word;
        }
    }
    return words;
}

bool noted(const Word& word) {
    const auto begins = [&word](const char* text) { return word.name.rfind(text, 0) == 0; };
    return !word.write &&
           (begins("SWITCHES") || begins("CAUGHT") || begins("ENCODER") || begins("FOLLOWING"));
}

class RegisterFile : public testing::Test {
  protected:
    RegisterFile() {
        for (const auto& [address, word] : read_words()) {
            if (noted(word)) noted_words_.push_back(address);
        }
        dut_.limit_cycles(UINT64_MAX);
        dut_->valid_i = 0;
        dut_->read_next_i = 0;
        live();
        dut_.reset();
    }

    /// Gives the motion's inputs random values.
    void live() {
        dut_->state_i = any();
        dut_->axes_i = any();
        dut_->room_i = any();
        dut_->samples_i = any();
        dut_->outputs_i = any();
        path_ = uint64_t{any()} << 32 | any();
        rate_ = any() % (1 << 17);
        show_path();
        dut_->off_i = any() % 2;
        dut_->segment_ready_i = any() % 2;
        dut_->profile_ready_i = any() % 2;
        dut_->sample_ready_i = any() % 2;
        dut_->control_ready_i = any() % 2;
        dut_->reference_ready_i = any() % 2;
    }

    /// Has programs read settings from now on, at random; these are their values.
    void let_programs_read(const std::map<int, Word>& words) {
        for (const auto& [address, word] : words) {
            if (word.setting) settings_[address] = word.value;
        }
    }

    /// Begins to read a setting, if none was read in the clock before.
    void read_settings() {
        reads_ = dut_->read_next_i != 0;
        constexpr int kRead[] = {9, 11, 12, 13, 14, 19};  // OVERRIDE .. STOP_TICKS, DIGEST
        if (reads_left_ > 0) {
            --reads_left_;
            pause_ = 4;
        } else if (pause_ > 0) {
            --pause_;
        } else if (!settings_.empty() && change_ < -2 && any() % 4 == 0) {
            reads_left_ = 1 + static_cast<int>(any() % kMostReads);
            dut_->read_word_i = static_cast<unsigned>(kRead[any() % 6]);
            read_.reset();
        }
        dut_->read_next_i = reads_left_ > 0;
    }
    /// Compares what programs read: it is as it was, or as it is being written, and stays.
    void check_read() {
        const int address = dut_->read_word_i;
        const auto said = [address](uint32_t value) {
            const bool slope = address == 13;
            const bool stop_ticks = address == 14;
            return uint64_t{slope && value == 0} << 32 | (stop_ticks ? value & 0x1fffffff : value);
        };
        const uint64_t read = dut_->setting_o & (address == 13 ? ~uint64_t{0} : 0xffffffff);
        const bool written = dut_->write_i && dut_->word_i == dut_->read_word_i;
        if (!written || read != said(dut_->data_i)) {
            EXPECT_EQ(read, said(settings_[address])) << address;
        }
        if (read_) {
            EXPECT_EQ(read, *read_) << "a write came in between";
        }
        read_ = read;
    }

    /// Path and rate as they are, or in clocks 1 to 3 of a change parts of others.
    void show_path() {
        const bool whole = change_ <= 0 || change_ == kChange;
        dut_->path_i = whole ? path_ : uint64_t{any()} << 32 | any();
        dut_->rate_i = whole ? rate_ : any() % (1 << 17);
        dut_->path_changes_i = change_ > 0;
    }
    /// They change at random, not soon again, nor where programs read.
    void change_path() {
        const bool reads = reads_left_ > 0 || pause_ > 0 || dut_->read_next_i != 0;
        if (change_ > -kChange) {
            --change_;
        } else if (!settings_.empty() && !reads && any() % 8 == 0) {
            change_ = kChange;
        }
        show_path();
    }

    /// Advances by one clock; pushes, writes and commands are counted. A word may be noted, and
    /// programs may read one.
    void clock() {
        read_settings();
        change_path();
        dut_->note_word_i = noted_words_[any() % noted_words_.size()];
        dut_->note_data_i = any();
        const int kept = noted_words_[any() % noted_words_.size()];
        dut_->kept_word_i = kept;
        dut_.settle();
        const bool notes = dut_->note_ready_o;
        const uint32_t kept_value = noted_[kept];
        if (notes) note();
        dut_->steps_i = 1000U + dut_->steps_axis_o;
        dut_.settle();
        if (dut_->segment_valid_o && dut_->segment_ready_i) happened("SEGMENT_HI");
        if (dut_->profile_valid_o && dut_->profile_ready_i) happened("PROFILE_HI");
        if (dut_->sample_valid_o && dut_->sample_ready_i) happened("SAMPLE");
        if (dut_->scale_write_o) happened("SCALE_HI");
        if (dut_->control_write_o) happened("CONTROL");
        if (dut_->state_write_o) happened("STATE");
        if (dut_->reference_write_o) happened("REFERENCE");
        if (dut_->probe_write_o) happened("PROBE");
        if (dut_->homed_write_o) happened("HOMED");
        if (dut_->shaper_write_o) happened("SHAPER");
        dut_.tick();
        if (reads_) {
            check_read();
        } else if (notes && kept != dut_->note_word_i) {  // one that is noted now is not read
            EXPECT_EQ(dut_->kept_o, kept_value);
        }
    }
    void note() {
        noted_[dut_->note_word_i] = dut_->note_data_i;
        if (dut_->valid_i && dut_->note_word_i == dut_->word_i)
            noted_now_.insert(dut_->note_data_i);
    }
    void happened(const std::string& name) {
        happened_[name] += 1;
        motion_word_ = dut_->motion_word_o;
        scale_ = dut_->scale_o;
        scale_axis_ = dut_->scale_axis_o;
        command_ = dut_->command_o;
    }

    struct Answer {
        bool error;
        uint32_t data;
        int clocks;
        int others;  // clocks of these in which programs read or the path changes
    };
    Answer ask(bool write, int word, uint32_t data) {
        happened_.clear();
        noted_now_.clear();
        dut_->valid_i = 1;
        dut_->write_i = write;
        dut_->word_i = static_cast<unsigned>(word);
        dut_->data_i = data;
        int clocks = 0;
        int others = 0;
        while (!dut_->done_o && clocks < 1000) {
            clock();
            ++clocks;
            others += reads_ || change_ > 0 ? 1 : 0;
        }
        const Answer answer{dut_->error_o != 0, dut_->data_o, clocks, others};
        clock();
        dut_->valid_i = 0;
        if (write && !answer.error && settings_.count(word) > 0) settings_[word] = data;
        return answer;
    }

    uint32_t any() { return random_(); }

    /// Returns true if a write of `data` to a word of that name is taken now.
    bool ready(const Word& word, uint32_t data) {
        if (word.name == "SEGMENT_HI") return dut_->segment_ready_i;
        if (word.name == "PROFILE_HI") return dut_->profile_ready_i;
        if (word.name == "SAMPLE") return dut_->sample_ready_i;
        if (word.name == "CONTROL") return dut_->control_ready_i;
        if (word.name == "REFERENCE") return dut_->reference_ready_i;
        if (word.name == "PINS") {
            constexpr uint32_t kPolarities = 0x201 * ((1U << CFG_Axes) - 1);
            return dut_->off_i || ((data ^ word.value) & kPolarities) == 0;
        }
        return (!word.axis && word.name != "SHAPER") || dut_->off_i;
    }

    uint32_t read_value(const Word& word, int address) {
        if (word.name == "VERSION") return word.value | hls::kWordsVersion << 8;
        if (word.name == "CAPABILITY") return CFG_Capability;
        if (word.name == "CORE") return CFG_Core;
        if (word.name == "WIDTHS") return CFG_Widths;
        if (word.name == "CLOCK") return CFG_ClockHertz;
        if (word.name == "STATE") return dut_->state_i;
        if (word.name == "AXES") return dut_->axes_i;
        if (word.name == "ROOM") return dut_->room_i;
        if (word.name == "SAMPLES") return dut_->samples_i;
        if (word.name == "OUTPUTS") return dut_->outputs_i;
        if (word.name == "PATH_LO") return static_cast<uint32_t>(path_);
        if (word.name == "PATH_HI") return path_high_;
        if (word.name == "RATE") return rate_kept_;
        if (word.name == "STEPS") return 1000U + static_cast<uint32_t>(address >> 2 & 15);
        if (noted(word)) return noted_[address];
        return word.value;
    }

    void check_settings(std::map<int, Word>& words) {
        std::map<std::string, uint32_t> value;
        for (const auto& [address, word] : words) value[word.name] = word.value;
        const auto field = [](uint32_t word, int low, int bits) {
            return word >> low & ((1U << bits) - 1);
        };
        EXPECT_EQ(dut_->override_o, field(value["OVERRIDE"], 0, 17));
        EXPECT_EQ(dut_->watchdog_o, field(value["WATCHDOG"], 0, 16));
        EXPECT_EQ(dut_->samples_per_tick_log2_o, field(value["TIMING"], 0, 4));
        EXPECT_EQ(dut_->hold_acceleration_o, value["HOLD_ACCELERATION"]);
        const uint32_t slope = value["HOLD_SLOPE"];
        EXPECT_EQ(dut_->hold_slope_o, slope == 0 ? uint64_t{1} << 32 : slope);
        EXPECT_EQ(dut_->digest_o, field(value["DIGEST"], 0, 16));
        EXPECT_EQ(dut_->stop_ticks_o, field(value["STOP_TICKS"], 0, 29));
        EXPECT_EQ(dut_->steplen_o, field(value["PULSE"], 0, CFG_TimeBits));
        EXPECT_EQ(dut_->stepspace_o, field(value["PULSE"], 16, CFG_TimeBits));
        EXPECT_EQ(dut_->dirsetup_o, field(value["DIRECTION"], 0, CFG_TimeBits));
        EXPECT_EQ(dut_->dirhold_o, field(value["DIRECTION"], 16, CFG_TimeBits));
        EXPECT_EQ(dut_->step_inverted_o, field(value["PINS"], 0, CFG_Axes));
        EXPECT_EQ(dut_->direction_inverted_o, field(value["PINS"], 9, CFG_Axes));
        EXPECT_EQ(dut_->limit_masked_o, field(value["PINS"], 18, CFG_Axes));
    }

    std::mt19937 random_{1};
    sysc::ClockedDut<Vregister_file> dut_;
    std::map<std::string, int> happened_;
    std::vector<int> noted_words_;
    std::map<int, uint32_t> noted_;
    std::set<uint32_t> noted_now_;      // of the word that is asked for
    std::map<int, uint32_t> settings_;  // that programs may read; none: they do not
    std::optional<uint64_t> read_;      // in the clocks before this one
    bool reads_ = false;                // they read
    int reads_left_ = 0;
    int pause_ = 0;
    uint64_t motion_word_ = 0;
    uint64_t scale_ = 0;
    int scale_axis_ = 0;
    uint32_t command_ = 0;
    uint32_t path_high_ = 0;
    uint32_t rate_kept_ = 0;
    uint64_t path_ = 0;
    uint32_t rate_ = 0;
    int change_ = 0;  // clocks of it that are left, below 0 since the last one
};

TEST_F(RegisterFile, HasItsResetValuesAndAnswersInTwoClocks) {
    auto words = read_words();
    int clocks = kAnswer + kFirstAnswer;
    for (int repeat = 0; repeat < 2; ++repeat) {
        for (const auto& [address, word] : words) {
            if (!word.read || word.name == "PATH_HI" || word.name == "RATE") continue;
            const uint32_t expected = read_value(word, address);
            const Answer answer = ask(false, address, any());
            EXPECT_FALSE(answer.error) << word.name;
            EXPECT_EQ(answer.data, expected) << word.name;
            EXPECT_LE(answer.clocks, clocks) << word.name;
            clocks = kAnswer;
        }
        check_settings(words);
        // A reset restores the words.
        for (const auto& [address, word] : words) {
            dut_->off_i = 1;
            if (word.setting) ask(true, address, any());
        }
        dut_.reset();
        noted_.clear();
        clocks = kAnswer + kFirstAnswer;
    }
}

TEST_F(RegisterFile, DoesWhatTheDescriptionSaysOfEachWord) {
    auto words = read_words();
    uint32_t low = 0;
    const auto keep_path = [this] {
        path_high_ = static_cast<uint32_t>(path_ >> 32);
        rate_kept_ = rate_;
    };
    ASSERT_EQ(words.at(24).name, "PATH_LO");
    ask(false, 24, 0);
    keep_path();
    ASSERT_EQ(words.at(20).name, "SEGMENT_LO");
    ask(true, 20, low);
    let_programs_read(words);
    int waits = 0;
    for (int n = 0; n < 40000 && !HasFailure(); ++n) {
        live();
        const bool write = any() % 2;
        const int address = static_cast<int>(any() % kWords);
        const uint32_t data = any() >> any() % 32;
        const auto found = words.find(address);
        const Word none{};
        const Word& word = found == words.end() ? none : found->second;
        SCOPED_TRACE((write ? "write " : "read ") + word.name + " " + std::to_string(address));
        const bool good = write ? word.write && ready(word, data) : word.read;
        const uint32_t expected = read_value(word, address);
        const Answer answer = ask(write, address, data);
        EXPECT_GE(answer.clocks, kAnswer);
        EXPECT_LE(answer.clocks, kAnswer + answer.others + (answer.others > 0 && write ? 1 : 0));
        EXPECT_LE(answer.clocks, kAnswer + std::max(kMostReads, kChange) + (write ? 1 : 0));
        waits += answer.clocks > kAnswer ? 1 : 0;
        EXPECT_EQ(answer.error, !good);
        if (!write && good && noted_now_.count(answer.data) == 0) {
            EXPECT_EQ(answer.data, expected);  // or one that is noted while programs read
        }
        if (!write && word.name == "PATH_LO") keep_path();
        // At most one action happens, once: the requested one.
        const std::map<std::string, int> pushes = {
            {"SEGMENT_HI", 1}, {"PROFILE_HI", 1}, {"SCALE_HI", 1}, {"CONTROL", 1}, {"STATE", 1},
            {"REFERENCE", 1},  {"SAMPLE", 1},     {"PROBE", 1},    {"HOMED", 1},   {"SHAPER", 1}};
        std::map<std::string, int> expected_pushes;
        if (write && good && pushes.count(word.name)) expected_pushes[word.name] = 1;
        EXPECT_EQ(happened_, expected_pushes);
        if (happened_.size() == 1) {
            if (word.name == "SEGMENT_HI" || word.name == "PROFILE_HI") {
                EXPECT_EQ(motion_word_, uint64_t{data & 0xffff} << 32 | low);
            }
            if (word.name == "SCALE_HI") {
                const uint64_t scale_low = words.at(address - 1).value;
                const uint64_t scale_bits = (uint64_t{1} << CFG_ScaleBits) - 1;
                EXPECT_EQ(scale_, (uint64_t{data} << 32 | scale_low) & scale_bits);
            }
            EXPECT_EQ(command_, data);
            EXPECT_EQ(scale_axis_, address >> 2 & 15);
        }
        if (write && good) {
            if (word.setting) found->second.value = data;
            if (word.name == "SEGMENT_LO" || word.name == "PROFILE_LO") low = data;
        }
        check_settings(words);
    }
    EXPECT_GT(waits, 4000);
}

}  // namespace
}  // namespace curvecore::tb
