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

/// Instructions of a curve's steps.
class Writer {
  public:
    Writer(CurveCode& code, Assembly& assembly)
        : code_(code), places_(place_words(code)), assembly_(assembly) {}

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

    std::map<std::string, std::string> words() const {
        std::map<std::string, std::string> words;
        for (std::size_t value = 0; value < places_.size(); ++value) {
            if (!places_[value].word.empty()) {
                words[code_.values[value].name] = places_[value].word;
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
            assembly_.put(step.op, field(step.to), field(step.a.value), second(step.b), step.flag);
        }
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
        if (place.word.empty() && !of.constant && !of.wide) {
            return {};
        }
        Field made = of.constant       ? assembly_.constant(*of.constant)
                     : of.wide         ? assembly_.wide(of.name)
                     : place.auxiliary ? assembly_.auxiliary_word(place.word)
                     : place.of_axis   ? assembly_.axis_word(place.word)
                                       : assembly_.word(place.word);
        made.name = of.name;
        return made;
    }

    CurveCode& code_;
    std::vector<WordPlace> places_;
    Assembly& assembly_;
};

bool reads(CurveCode& code, const char* word) {
    for (const Part* part : code.parts()) {
        for (const Block& block : part->blocks) {
            for (const Step& step : block.steps) {
                for (const Use& use : {step.a, step.b}) {
                    if (use.is_value() &&
                        code.values[static_cast<std::size_t>(use.value)].name == word) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

/// Powers of two of k and s, a step for each of them: at most 27 of both together.
class ScaleWords {
  public:
    ScaleWords(Assembly& assembly, CurveCode& code) : assembly_(assembly), code_(code) {}

    void make(const FineScale& scale) {
        const Field to_tau = assembly_.word(scale_word::kToTau);
        const Field to_fine = assembly_.word(scale_word::kToFine);
        start(to_tau, hls::kMaxStepExponent, "2^(27-k), halved k times");
        start(to_fine, scale.fine, "2^(fine+k), doubled k times");
        times("k", [&] {
            halve(to_tau, 1);
            assembly_.add(to_fine, to_fine, to_fine);
        });
        const bool down = reads(code_, scale_word::kDown) || reads(code_, scale_word::kDownTwice);
        const bool place = reads(code_, scale_word::kPlaceToFine);
        if (!down && !place) {
            return;
        }
        const Field once = assembly_.word(scale_word::kDown);
        const Field twice = assembly_.word(scale_word::kDownTwice);
        const Field lambda = assembly_.word(scale_word::kPlaceToFine);
        start(once, 44, "2^(44-s), halved s times");
        start(twice, 44, "2^(44-2s), quartered s times");
        from("2^(fine+lambda), doubled s times");
        assembly_.copy(lambda, to_fine);
        times("s", [&] {
            halve(once, 1);
            halve(twice, 2);
            assembly_.add(lambda, lambda, lambda);
        });
    }

  private:
    void from(const std::string& text) { assembly_.from({"", 0, text}); }

    void start(const Field& word, int exponent, const std::string& text) {
        constexpr int kMostOfProduct = 43;
        from(text);
        assembly_.put(Op::kMull, word, assembly_.constant(1),
                      assembly_.power(std::min(exponent, kMostOfProduct)));
        if (exponent > kMostOfProduct) {
            assembly_.add(word, word, word);
        }
    }

    void halve(const Field& word, int times) {
        assembly_.put(Op::kMulr, word, word, assembly_.power(45 - times), true);
    }

    /// Writes a body for as many times as a word says.
    template <class Body>
    void times(const std::string& name, Body&& body) {
        const Field count = assembly_.word("count");
        const std::string past = code_.name + " past " + name;
        from("count = " + name);
        assembly_.copy(count, assembly_.word(name));
        assembly_.loop();
        from("once less");
        assembly_.put(Op::kSub, count, count, assembly_.constant(1), false, 1);
        assembly_.branch(past, engine::kNegative);
        body();
        from("and again");
        assembly_.repeat(hls::kMaxStepExponent, engine::kNot | engine::kNever);
        assembly_.label(past);
    }

    Assembly& assembly_;
    CurveCode& code_;
};

}  // namespace

std::map<std::string, std::string> assemble_curve(const ref::CurveTable& table,
                                                  const ref::CoreParameters& core,
                                                  Assembly& assembly, const std::string& after_step,
                                                  const std::string& after_sample) {
    CurveCode code = lower(table, core);
    drop_unread(code);
    fuse_products(code);
    Writer writer(code, assembly);
    assembly.label(table.name + " load");
    ScaleWords(assembly, code).make(fine_scale(core));
    writer.write(code.load, table.name + " open");
    assembly.label(table.name + " step");
    writer.write_ahead(code.next, table.name + " open");
    assembly.label(table.name + " open");
    writer.write(code.open, after_step);
    assembly.label(table.name + " sample");
    writer.write(code.sample, after_sample);
    return writer.words();
}

}  // namespace curvecore::assembler
