// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/word_places.hpp"

#include <algorithm>

namespace curvecore::assembler {
namespace {

/// Steps of a part that use a value, counted from 0.
struct Span {
    int first = -1;
    int last = -1;
    int first_block = -1;
    int last_block = -1;
    bool read_first = false;
};

class Places {
  public:
    Places(CurveCode& code, int first)
        : code_(code), kept_(code.values.size()), written_(code.values.size()) {
        places_.words.resize(code.values.size());
        places_.shared.kept = first;
    }

    WordPlaces made() {
        for (Part* part : code_.parts()) {
            spans_.push_back(spans(*part));
        }
        for (std::size_t value = 0; value < code_.values.size(); ++value) {
            const Value& of = code_.values[value];
            if (!of.constant && of.word.empty() && used(value) && !written_[value]) {
                throw AssemblyError(code_.name + ": nothing makes " + of.name);
            }
            if (of.constant || of.wide || !used(value)) {
                kept_[value] = true;
            } else if (!of.word.empty()) {
                kept_[value] = true;
                places_.words[value] = {of.word, -1, of.of_axis, of.auxiliary};
            } else if (read_first(value)) {
                kept_[value] = true;
                int& next = (of.of_axis ? places_.of_axis : places_.shared).kept;
                places_.words[value] = {"", next++, of.of_axis, false};
            }
        }
        for (SlotCount* const count : {&places_.shared, &places_.of_axis}) {
            count->all = count->of_sample = count->kept;
        }
        const auto parts = code_.parts();
        for (std::size_t part = 0; part < parts.size(); ++part) {
            share(*parts[part], spans_[part]);
        }
        return std::move(places_);
    }

  private:
    std::vector<Span> spans(const Part& part) {
        std::vector<Span> all(code_.values.size());
        int position = 0;
        for (int block = 0; block < static_cast<int>(part.blocks.size()); ++block) {
            for (const Step& step : part.blocks[static_cast<std::size_t>(block)].steps) {
                const auto touch = [&](int value, bool read) {
                    Span& span = all[static_cast<std::size_t>(value)];
                    if (span.first < 0) {
                        span.first = position;
                        span.first_block = block;
                        span.read_first = read;
                    }
                    span.last = position;
                    span.last_block = block;
                };
                for (const Use& use : {step.a, step.b}) {
                    if (use.is_value()) {
                        touch(use.value, true);
                    }
                }
                touch(step.to, step.reads_target());
                written_[static_cast<std::size_t>(step.to)] = true;
                ++position;
            }
        }
        return all;
    }

    bool used(std::size_t value) const {
        return std::any_of(spans_.begin(), spans_.end(),
                           [&](const auto& part) { return part[value].first >= 0; });
    }
    bool read_first(std::size_t value) const {
        return std::any_of(spans_.begin(), spans_.end(),
                           [&](const auto& part) { return part[value].read_first; });
    }

    /// Gives words to what one part alone uses.
    void share(const Part& part, const std::vector<Span>& spans) {
        std::vector<int> ends;  // of blocks
        for (const Block& block : part.blocks) {
            ends.push_back((ends.empty() ? 0 : ends.back()) + static_cast<int>(block.steps.size()));
        }
        struct Need {
            std::size_t value;
            int first, last;
            bool of_axis;
        };
        std::vector<Need> needs;
        for (std::size_t value = 0; value < spans.size(); ++value) {
            const Span& span = spans[value];
            if (kept_[value] || span.first < 0) {
                continue;
            }
            Need need{value, span.first, span.last, code_.values[value].of_axis};
            const auto first = static_cast<std::size_t>(span.first_block);
            const auto last = static_cast<std::size_t>(span.last_block);
            if (first == last) {
                need.of_axis = false;  // each axis has done with it before the next
            } else {
                if (part.blocks[last].of_axes) {
                    need.last = ends[last] - 1;
                }
                if (part.blocks[first].of_axes) {
                    need.first = first == 0 ? 0 : ends[first - 1];
                }
            }
            needs.push_back(need);
        }
        std::sort(needs.begin(), needs.end(),
                  [](const Need& a, const Need& b) { return a.first < b.first; });
        std::vector<int> free_from[2];  // by of_axis: the step from which a word is free
        for (const Need& need : needs) {
            std::vector<int>& words = free_from[need.of_axis ? 1 : 0];
            auto word = std::find_if(words.begin(), words.end(),
                                     [&](int from) { return from < need.first; });
            if (word == words.end()) {
                words.push_back(-1);
                word = words.end() - 1;
            }
            *word = need.last;
            SlotCount& count = need.of_axis ? places_.of_axis : places_.shared;
            const int slot = count.kept + static_cast<int>(word - words.begin());
            count.all = std::max(count.all, slot + 1);
            if (&part == &code_.sample) {
                count.of_sample = std::max(count.of_sample, slot + 1);
            }
            places_.words[need.value] = {"", slot, need.of_axis, false};
        }
    }

    CurveCode& code_;
    std::vector<std::vector<Span>> spans_;  // by part and value
    WordPlaces places_;
    std::vector<bool> kept_;
    std::vector<bool> written_;
};

}  // namespace

WordPlaces place_words(CurveCode& code, int first) { return Places(code, first).made(); }

}  // namespace curvecore::assembler
