// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/curve_assembler.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hls/configuration.hpp"
#include "rtl/engine/compiler/code_passes.hpp"
#include "rtl/engine/compiler/table_lowering.hpp"
#include "rtl/engine/compiler/word_places.hpp"

namespace curvecore::assembler {
namespace {

using engine::Op;

constexpr const char* kScaleWords[] = {"place_scale", "step_scale"};
constexpr int kScaleSlots = 2;

/// Returns whether a curve reads the words above: to others they are slots.
bool reads_scales(const CurveCode& code) {
    const auto reads = [&](const Step& step) {
        return std::any_of(std::begin(kScaleWords), std::end(kScaleWords), [&](const char* word) {
            const auto is = [&](const Use& use) {
                return use.is_value() &&
                       code.values[static_cast<std::size_t>(use.value)].word == word;
            };
            return is(step.a) || is(step.b);
        });
    };
    for (const Part* part : {&code.load, &code.next, &code.open, &code.sample}) {
        for (const Block& block : part->blocks) {
            if (std::any_of(block.steps.begin(), block.steps.end(), reads)) {
                return true;
            }
        }
    }
    return false;
}

/// Words of the slots of all curves: one segment is under way at a time. What is not kept stands in
/// words that other programs use, too; a sample's fine positions in a slot that is free then.
class SlotNames {
  public:
    explicit SlotNames(const std::vector<WordPlaces>& curves) {
        SlotCount of_axis;
        for (const WordPlaces& curve : curves) {
            kept_ = std::max(kept_, curve.shared.kept);
            of_axis.all = std::max(of_axis.all, curve.of_axis.all);
            of_axis.of_sample =
                std::max({of_axis.of_sample, curve.of_axis.kept, curve.of_axis.of_sample});
        }
        fine_ = std::max(of_axis.all - 1, of_axis.of_sample);
    }

    Field shared(int slot, Assembly& assembly) const {
        return slot >= kept_        ? assembly.scratch(slot - kept_)
               : slot < kScaleSlots ? assembly.word(kScaleWords[slot])
                                    : assembly.word(fmt::format("curve {}", slot));
    }
    Field of_axis(int slot, Assembly& assembly) const {
        return assembly.axis_word(slot == fine_ ? "fine[k]" : fmt::format("curve {}[k]", slot));
    }

  private:
    int kept_ = 0;
    int fine_ = 0;
};

/// Instructions of a curve's steps.
class Writer {
  public:
    Writer(CurveCode& code, const WordPlaces& places, const SlotNames& names, Assembly& assembly)
        : code_(code), places_(places.words), names_(names), assembly_(assembly) {}

    /// Writes a part, which goes on to a label; subroutines of its axes come behind it.
    void write(const Part& part, const std::string& next) {
        std::vector<std::pair<std::string, const Block*>> subroutines;
        for (const Block& block : part.blocks) {
            if (block.steps.empty()) {
                continue;
            }
            if (block.of_axes) {
                const std::string name =
                    fmt::format("{} {} {}", code_.name, part.name, subroutines.size() + 1);
                subroutines.emplace_back(name, &block);
                assembly_.from(block.steps.front().source);
                assembly_.call_for_axes(name);
            } else {
                write(block);
            }
        }
        assembly_.from({code_.name, 0, "to " + next});
        assembly_.branch(next);
        for (const auto& [name, block] : subroutines) {
            assembly_.label(name);
            write(*block);
            assembly_.give_back();
        }
    }

    /// The same of a part whose label comes next.
    void write_ahead(const Part& part, const std::string& next) {
        const bool falls =
            std::none_of(part.blocks.begin(), part.blocks.end(),
                         [](const Block& of) { return of.of_axes && !of.steps.empty(); });
        if (!falls) {
            write(part, next);
            return;
        }
        for (const Block& block : part.blocks) {
            write(block);
        }
    }

    CurveWords words() {
        CurveWords words;
        for (std::size_t value = 0; value < places_.size(); ++value) {
            if (!places_[value].word.empty() || places_[value].slot >= 0) {
                words[code_.values[value].name] = word(places_[value]).name;
            }
        }
        return words;
    }

  private:
    void write(const Block& block) {
        bool open = false;  // the page of auxiliary axes
        for (const Step& step : block.steps) {
            assembly_.from(step.source);
            if (!open && (auxiliary(step.to) || auxiliary(step.a.value) ||
                          (step.b.is_value() && auxiliary(step.b.value)))) {
                assembly_.open_auxiliary();
                open = true;
            }
            Use a = step.a;
            Use b = step.b;
            const bool commutes = step.op == Op::kAdd || step.op == Op::kMull ||
                                  step.op == Op::kMulr || step.op == Op::kMac;
            if (commutes && b.is_value() && exponent(a) >= 0) {
                std::swap(a, b);
            }
            const int power = exponent(b);
            assembly_.put(step.op, field(step.to), field(a.value),
                          power >= 0 ? assembly_.power(power) : second(b), step.flag);
        }
        if (open) {
            assembly_.close_axes();
        }
    }

    /// n of a constant 2^n, which needs no word as F1; else -1.
    int exponent(const Use& use) const {
        const auto constant = use.is_value()
                                  ? code_.values[static_cast<std::size_t>(use.value)].constant
                                  : std::nullopt;
        int n = 0;
        while (constant && *constant >> n > 1) {
            ++n;
        }
        return constant && *constant == std::int64_t{1} << n ? n : -1;
    }

    bool auxiliary(int value) const { return places_[static_cast<std::size_t>(value)].auxiliary; }

    Field second(const Use& use) {
        if (use.is_value()) {
            return field(use.value);
        }
        return use.power == Use::kMinusOne ? Field{engine::minus_power(0), "-1"}
                                           : assembly_.power(use.power);
    }

    Field field(int value) {
        const Value& of = code_.values[static_cast<std::size_t>(value)];
        const WordPlace& place = places_[static_cast<std::size_t>(value)];
        Field made = of.constant ? assembly_.constant(*of.constant)
                     : of.wide   ? assembly_.wide(of.name)
                                 : word(place);
        made.name = of.name.substr(0, of.name.find(" of the "));  // of a place: its word's
        return made;
    }

    Field word(const WordPlace& place) {
        if (place.slot >= 0) {
            return place.of_axis ? names_.of_axis(place.slot, assembly_)
                                 : names_.shared(place.slot, assembly_);
        }
        return place.auxiliary ? assembly_.auxiliary_word(place.word)
               : place.of_axis ? assembly_.axis_word(place.word)
                               : assembly_.word(place.word);
    }

    CurveCode& code_;
    const std::vector<WordPlace>& places_;
    const SlotNames& names_;
    Assembly& assembly_;
};

}  // namespace

std::vector<CurveWords> assemble_curves(const std::vector<ref::CurveTable>& tables,
                                        const ref::CoreParameters& core, Assembly& assembly,
                                        const std::string& after_step,
                                        const std::string& after_sample) {
    std::vector<CurveCode> codes;
    for (const ref::CurveTable& table : tables) {
        codes.push_back(lower(table, core));
        drop_unread(codes.back());
        fuse_products(codes.back());
        share_wides(codes.back());
    }
    share_constants(codes, core.coef_bits);
    std::vector<WordPlaces> places;
    places.reserve(codes.size());
    for (CurveCode& code : codes) {
        places.push_back(place_words(code, reads_scales(code) ? kScaleSlots : 0));
    }
    const SlotNames names(places);
    std::vector<CurveWords> words;
    for (std::size_t kind = codes.size(); kind-- > 0;) {
        const std::string& name = codes[kind].name;
        Writer writer(codes[kind], places[kind], names, assembly);
        const auto begin = [&](const char* what) {
            if (kind == 0) {
                assembly.label(std::string("curve_") + what);
                for (std::size_t other = codes.size(); --other > 0;) {
                    const bool table = core.table && other + 1 == codes.size();
                    assembly.from({"", 0, "test kind: " + codes[other].name});
                    assembly.put(table ? Op::kAdd : Op::kSub, Assembly::zero(),
                                 table ? assembly.word("kind") : Assembly::zero(),
                                 table ? Assembly::zero() : assembly.word("kind"), false, 1);
                    assembly.branch(codes[other].name + "_" + what, engine::kNegative);
                }
            }
            assembly.label(name + "_" + what);
        };
        begin("load");
        writer.write(codes[kind].load, name + "_open");
        begin("step");
        writer.write_ahead(codes[kind].next, name + "_open");
        assembly.label(name + "_open");
        writer.write(codes[kind].open, after_step);
        begin("sample");
        writer.write(codes[kind].sample, after_sample);
        words.insert(words.begin(), writer.words());
    }
    return words;
}

Assembly curve_program(const ref::CurveTable& table, const ref::CoreParameters& core) {
    Assembly assembly(StoreSize{4096, 512, 2});
    assembly.from({table.name, 0, ""});
    assembly.label("idle");
    assembly.branch("idle");
    assemble_curves({table}, core, assembly, "idle", "idle");
    assembly.finish();
    return assembly;
}

}  // namespace curvecore::assembler
