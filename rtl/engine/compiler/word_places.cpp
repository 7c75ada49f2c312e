// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/word_places.hpp"

#include <algorithm>
#include <array>

namespace curvecore::assembler {
namespace {

enum PartOfCode { kLoad, kNext, kOpen, kSample, kParts };

/// Steps of a part that use a value, counted from 1, and their blocks.
struct Span {
    int first = 0;
    int last = 0;
    std::size_t first_block = 0;
    std::size_t last_block = 0;
    bool read_first = false;

    bool any() const { return first != 0; }
};

/// Steps of a part between which a value must stay where it is: 0 is its begin.
struct Stay {
    int first = 0;
    int last = -1;

    bool meets(const Stay& other) const { return first <= other.last && other.first <= last; }
};
using Stays = std::array<Stay, kParts>;

/// Words of one kind, each with the stays of the values in it.
class Slots {
  public:
    /// Returns the first slot where a value meets no other.
    int place(const Stays& stays) {
        int slot = 0;
        for (; slot < count(); ++slot) {
            if (std::none_of(slots_[index(slot)].begin(), slots_[index(slot)].end(),
                             [&](const Stays& other) { return meet(stays, other); })) {
                break;
            }
        }
        if (slot == count()) {
            slots_.emplace_back();
        }
        slots_[index(slot)].push_back(stays);
        return slot;
    }
    int count() const { return static_cast<int>(slots_.size()); }

  private:
    static std::size_t index(int slot) { return static_cast<std::size_t>(slot); }
    static bool meet(const Stays& a, const Stays& b) {
        for (std::size_t part = 0; part < kParts; ++part) {
            if (a[part].meets(b[part])) {
                return true;
            }
        }
        return false;
    }

    std::vector<std::vector<Stays>> slots_;
};

class Places {
  public:
    Places(CurveCode& code, int first)
        : code_(code), parts_{&code.load, &code.next, &code.open, &code.sample} {
        places_.words.resize(code.values.size());
        places_.shared.kept = first;
        for (std::size_t part = 0; part < kParts; ++part) {
            look(part);
        }
        follow_lives();
        for (int slot = 0; slot < first; ++slot) {
            Stays always;
            always.fill({0, last_step_});
            shared_.place(always);
        }
    }

    WordPlaces made() {
        std::vector<std::size_t> others;
        for (std::size_t value = 0; value < code_.values.size(); ++value) {
            const Value& of = code_.values[value];
            if (of.constant || of.wide || !used(value)) {
                continue;
            }
            if (!of.word.empty()) {
                places_.words[value] = {of.word, -1, of.of_axis, of.auxiliary};
                continue;
            }
            if (!written_[value]) {
                throw AssemblyError(code_.name + ": nothing makes " + of.name);
            }
            if (lives_[kSample][value].in || lives_[kNext][value].in) {
                place(value, true);
            } else {
                others.push_back(value);
            }
        }
        std::stable_sort(others.begin(), others.end(),
                         [&](std::size_t a, std::size_t b) { return first_use(a) < first_use(b); });
        for (const std::size_t value : others) {
            place(value, false);
        }
        places_.shared.all = shared_.count();
        places_.of_axis.all = of_axis_.count();
        return std::move(places_);
    }

  private:
    /// Needs of a value: it is there when a part begins, and read behind it.
    struct Life {
        bool in = false;
        bool out = false;
    };

    void look(std::size_t part) {
        std::vector<Span>& all = spans_[part];
        all.resize(code_.values.size());
        lives_[part].resize(code_.values.size());
        written_.resize(code_.values.size());
        int step_number = 0;
        for (std::size_t block = 0; block < parts_[part]->blocks.size(); ++block) {
            for (const Step& step : parts_[part]->blocks[block].steps) {
                ++step_number;
                const auto touch = [&](int value, bool read) {
                    Span& span = all[static_cast<std::size_t>(value)];
                    if (!span.any()) {
                        span = {step_number, step_number, block, block, read};
                    }
                    span.last = step_number;
                    span.last_block = block;
                };
                for (const Use& use : {step.a, step.b}) {
                    if (use.is_value()) {
                        touch(use.value, true);
                    }
                }
                touch(step.to, step.reads_target());
                written_[static_cast<std::size_t>(step.to)] = true;
            }
            ends_[part].push_back(step_number);
        }
        last_step_ = std::max(last_step_, step_number + 1);
    }

    /// Finds out where values live: open follows on load and next; samples and next on open.
    void follow_lives() {
        const std::array<std::vector<std::size_t>, kParts> behind{
            std::vector<std::size_t>{kOpen}, {kOpen}, {kSample, kNext}, {kSample, kNext}};
        for (std::size_t round = 0; round < kParts; ++round) {
            for (std::size_t part = 0; part < kParts; ++part) {
                for (std::size_t value = 0; value < code_.values.size(); ++value) {
                    Life& life = lives_[part][value];
                    const Span& span = spans_[part][value];
                    for (const std::size_t next : behind[part]) {
                        life.out |= lives_[next][value].in;
                    }
                    life.in = span.any() ? span.read_first : life.out;
                }
            }
        }
    }

    bool used(std::size_t value) const {
        return std::any_of(spans_.begin(), spans_.end(),
                           [&](const auto& part) { return part[value].any(); });
    }
    std::pair<std::size_t, int> first_use(std::size_t value) const {
        std::size_t part = 0;
        while (!spans_[part][value].any()) {
            ++part;
        }
        return {part, spans_[part][value].first};
    }

    void place(std::size_t value, bool kept) {
        const bool of_axis = code_.values[value].of_axis && !in_one_block(value);
        const Stays stays = stays_of(value, of_axis);
        const int slot = (of_axis ? of_axis_ : shared_).place(stays);
        SlotCount& count = of_axis ? places_.of_axis : places_.shared;
        count.kept = std::max(count.kept, kept ? slot + 1 : 0);
        if (stays[kSample].last >= 0) {
            count.of_sample = std::max(count.of_sample, slot + 1);
        }
        places_.words[value] = {"", slot, of_axis, false};
    }

    /// Returns whether a value of an axis is done with before the next axis' turn.
    bool in_one_block(std::size_t value) const {
        for (std::size_t part = 0; part < kParts; ++part) {
            const Span& span = spans_[part][value];
            const Life& life = lives_[part][value];
            if (life.in || life.out || span.first_block != span.last_block) {
                return false;
            }
        }
        return true;
    }

    Stays stays_of(std::size_t value, bool of_axis) const {
        Stays stays;
        for (std::size_t part = 0; part < kParts; ++part) {
            const Span& span = spans_[part][value];
            const Life& life = lives_[part][value];
            if (!span.any() && !life.in) {
                continue;
            }
            Stay stay{span.first, span.last};
            const auto& blocks = parts_[part]->blocks;
            const bool one_turn = of_axis || in_one_block(value) || !span.any();
            if (!one_turn && blocks[span.first_block].of_axes) {
                stay.first = span.first_block == 0 ? 0 : ends_[part][span.first_block - 1] + 1;
            }
            if (!one_turn && blocks[span.last_block].of_axes) {
                stay.last = ends_[part][span.last_block];
            }
            stays[part] = {life.in ? 0 : stay.first, life.out ? last_step_ : stay.last};
        }
        return stays;
    }

    CurveCode& code_;
    std::array<const Part*, kParts> parts_;
    std::array<std::vector<Span>, kParts> spans_;  // by value
    std::array<std::vector<Life>, kParts> lives_;
    std::array<std::vector<int>, kParts> ends_;  // last step of each block
    std::vector<bool> written_;
    int last_step_ = 0;
    WordPlaces places_;
    Slots shared_;
    Slots of_axis_;
};

}  // namespace

WordPlaces place_words(CurveCode& code, int first) { return Places(code, first).made(); }

}  // namespace curvecore::assembler
