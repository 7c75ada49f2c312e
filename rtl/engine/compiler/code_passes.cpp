// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/code_passes.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace curvecore::assembler {

using engine::Op;

namespace {

/// Counts of steps that read and write each value, over all parts.
struct Counts {
    explicit Counts(CurveCode& code) : reads(code.values.size()), writes(code.values.size()) {
        for (const Part* part : code.parts()) {
            for (const Block& block : part->blocks) {
                for (const Step& step : block.steps) {
                    count(step);
                }
            }
        }
    }
    void count(const Step& step) {
        ++writes[static_cast<std::size_t>(step.to)];
        for (const Use& use : {step.a, step.b}) {
            if (use.is_value()) {
                ++reads[static_cast<std::size_t>(use.value)];
            }
        }
    }
    std::vector<int> reads;
    std::vector<int> writes;
};

std::int64_t constant_of(const CurveCode& code, const Use& use) {
    return use.is_value() ? code.values[static_cast<std::size_t>(use.value)].constant.value_or(0)
                          : 0;
}
bool is_power(std::int64_t number) { return number > 0 && (number & (number - 1)) == 0; }

/// Constants of two factors: an odd number and a power of two.
std::pair<std::int64_t, int> odd_and_exponent(std::int64_t number) {
    int exponent = 0;
    for (; number % 2 == 0; number /= 2) {
        ++exponent;
    }
    return {number, exponent};
}

/// Returns whether a step is a product of a value by a constant that needs a word.
bool by_constant(const CurveCode& code, const Step& step) {
    const std::int64_t constant = constant_of(code, step.b);
    return step.op == Op::kMulr && constant != 0 && !is_power(constant);
}

class Fusion {
  public:
    explicit Fusion(CurveCode& code) : code_(code) {}

    /// Fuses steps n and n + 1 of a block, if that can be.
    bool fuse(Block& block, std::size_t n) {
        std::vector<Step>& steps = block.steps;
        const Step product = steps[n];
        const Step sum = steps[n + 1];
        const Counts counts(code_);
        const auto once = [&](const std::vector<int>& of, int value) {
            return of[static_cast<std::size_t>(value)] == 1;
        };
        const bool first = sum.a.value == product.to;
        if (product.op != Op::kMulr || product.flag || sum.op != Op::kAdd ||
            first == (sum.b.value == product.to) || !once(counts.reads, product.to) ||
            !once(counts.writes, product.to) || !once(counts.writes, sum.to)) {
            return false;
        }
        const Use added = first ? sum.b : sum.a;
        if (is_power(constant_of(code_, added))) {
            return false;  // it needs no word in a sum
        }
        for (const bool left : {true, false}) {
            const Use factor = left ? product.a : product.b;
            const Use other = left ? product.b : product.a;
            if (factor.is_value() && factor.value != other.value && factor.value != added.value &&
                gives_way(block, n, factor.value, sum.to)) {
                for (std::size_t m = 0; m < n; ++m) {
                    rename(steps[m], factor.value, sum.to);
                }
                steps[n] = {Op::kMadr, sum.to, added, other, false, sum.source};
                steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(n) + 1);
                return true;
            }
        }
        return false;
    }

  private:
    /// Returns whether a factor is written and read in this block up to step n alone, and `to`
    /// could stand in its word.
    bool gives_way(const Block& block, std::size_t n, int factor, int to) {
        const Value& value = code_.values[static_cast<std::size_t>(factor)];
        if (value.constant || !value.word.empty() || value.wide ||
            value.of_axis != code_.values[static_cast<std::size_t>(to)].of_axis) {
            return false;
        }
        std::size_t first = n;
        for (std::size_t m = n; m-- > 0;) {
            first = block.steps[m].to == factor ? m : first;
        }
        const auto touches = [&](const Step& step) {
            return step.to == factor || step.reads(factor);
        };
        for (const Part* part : code_.parts()) {
            for (const Block& other : part->blocks) {
                for (std::size_t m = 0; m < other.steps.size(); ++m) {
                    const bool inside = &other == &block && m >= first && m <= n;
                    if (!inside && touches(other.steps[m])) {
                        return false;
                    }
                    if (inside && other.steps[m].reads(to)) {
                        return false;
                    }
                }
            }
        }
        return first < n && !block.steps[n + 1].reads(to) && !block.steps[first].reads(factor);
    }

    static void rename(Step& step, int from, int to) {
        for (int* value : {&step.to, &step.a.value, &step.b.value}) {
            *value = *value == from ? to : *value;
        }
    }

    CurveCode& code_;
};

}  // namespace

void drop_unread(CurveCode& code) {
    for (bool dropped = true; dropped;) {
        dropped = false;
        const Counts counts(code);
        for (Part* part : code.parts()) {
            for (Block& block : part->blocks) {
                const auto unread = [&](const Step& step) {
                    const auto to = static_cast<std::size_t>(step.to);
                    return counts.reads[to] == 0 && code.values[to].word.empty();
                };
                const auto from = std::remove_if(block.steps.begin(), block.steps.end(), unread);
                dropped |= from != block.steps.end();
                block.steps.erase(from, block.steps.end());
            }
        }
    }
}

void fuse_products(CurveCode& code) {
    Fusion fusion(code);
    for (Part* part : code.parts()) {
        for (Block& block : part->blocks) {
            for (std::size_t n = 0; n + 1 < block.steps.size(); ++n) {
                fusion.fuse(block, n);
            }
        }
    }
}

void share_wides(CurveCode& code) {
    std::vector<int> wides;
    for (std::size_t value = 0; value < code.values.size(); ++value) {
        if (code.values[value].wide) {
            wides.push_back(static_cast<int>(value));
        }
    }
    const auto touches = [](const Step& step, int value) {
        return step.to == value || step.reads(value);
    };
    // Blocks between the first step of `one` and its last, and those of axes with them, are free of
    // `other`.
    const auto apart = [&](const Part& part, int one, int other) {
        std::vector<const Step*> steps;
        std::size_t first = 0;
        std::size_t last = 0;
        for (const Block& block : part.blocks) {
            const std::size_t begin = steps.size();
            for (const Step& step : block.steps) {
                steps.push_back(&step);
                if (touches(step, one)) {
                    first = last == 0 ? (block.of_axes ? begin : steps.size() - 1) : first;
                    last = block.of_axes ? begin + block.steps.size() : steps.size();
                }
            }
        }
        return std::none_of(
            steps.begin() + static_cast<std::ptrdiff_t>(first),
            steps.begin() + static_cast<std::ptrdiff_t>(std::min(last, steps.size())),
            [&](const Step* step) { return touches(*step, other); });
    };
    if (wides.size() != 2) {
        return;
    }
    for (const auto& [one, other] : {std::pair(wides[0], wides[1]), {wides[1], wides[0]}}) {
        const auto parts = code.parts();
        if (!std::all_of(parts.begin(), parts.end(),
                         [one = one, other = other, &apart](const Part* part) {
                             return apart(*part, one, other);
                         })) {
            continue;
        }
        for (Part* part : parts) {
            for (Block& block : part->blocks) {
                for (Step& step : block.steps) {
                    for (int* value : {&step.to, &step.a.value, &step.b.value}) {
                        *value = *value == one ? other : *value;
                    }
                }
            }
        }
        return;
    }
}

void share_constants(std::vector<CurveCode>& codes, int coef_bits) {
    constexpr int kProductBits = 45;
    std::map<std::int64_t, int> least;  // exponents by odd number
    const auto each = [&](auto&& visit) {
        for (CurveCode& code : codes) {
            for (Part* part : code.parts()) {
                for (Block& block : part->blocks) {
                    for (std::size_t n = 0; n < block.steps.size(); ++n) {
                        if (by_constant(code, block.steps[n])) {
                            n += visit(code, block, n);
                        }
                    }
                }
            }
        }
    };
    each([&](CurveCode& code, Block& block, std::size_t n) {
        const auto [odd, exponent] = odd_and_exponent(constant_of(code, block.steps[n].b));
        const auto found = least.emplace(odd, exponent).first;
        found->second = std::min(found->second, exponent);
        return std::size_t{0};
    });
    each([&](CurveCode& code, Block& block, std::size_t n) {
        Step& step = block.steps[n];
        const auto [odd, exponent] = odd_and_exponent(constant_of(code, step.b));
        const int lift = exponent - least.at(odd);
        const Value factor = code.values[static_cast<std::size_t>(step.a.value)];
        if (lift == 0 || coef_bits + lift > kProductBits || factor.auxiliary) {
            return std::size_t{0};
        }
        const auto add = [&](Value value) {
            code.values.push_back(std::move(value));
            return Use{static_cast<int>(code.values.size()) - 1, 0};
        };
        Value copy;
        copy.name = factor.name + "<<" + std::to_string(lift);
        copy.of_axis = factor.of_axis;
        const Use lifted = add(copy);
        Value number = code.values[static_cast<std::size_t>(step.b.value)];
        number.constant = odd * (std::int64_t{1} << least.at(odd));
        const Use constant = add(number);
        const Step lifting{Op::kMull, lifted.value, step.a, {-1, lift}, false, step.source};
        step.a = lifted;
        step.b = constant;
        block.steps.insert(block.steps.begin() + static_cast<std::ptrdiff_t>(n), lifting);
        return std::size_t{1};
    });
}

}  // namespace curvecore::assembler
