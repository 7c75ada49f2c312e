// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/step_writer.hpp"

#include <fmt/format.h>

namespace curvecore::assembler {

using engine::Op;

namespace {

constexpr int kProductBits = 45;  // of a product of three limbs; a sum has one more

}  // namespace

void StepWriter::begin(Part& part) {
    part_ = &part;
    for (auto copy = copies_.begin(); copy != copies_.end();) {
        const bool negative = std::get<1>(copy->first) == -1 || negatives_.count(copy->second) != 0;
        if (fixed(std::get<0>(copy->first)) && (!negative || fixed(copy->second))) {
            ++copy;
            continue;
        }
        if (negative) {
            names_.erase(at(copy->second).name);
        }
        copy = copies_.erase(copy);
    }
}

void StepWriter::refuse(const std::string& reason) const {
    throw AssemblyError(fmt::format("{}:{}: error: {}", source_.file, source_.line, reason));
}

int StepWriter::value(const std::string& name, bool of_axis, const std::string& word) {
    const auto [found, added] = names_.emplace(name, static_cast<int>(code_.values.size()));
    if (added) {
        code_.values.push_back({name, of_axis, false, false, std::nullopt, word});
    }
    return found->second;
}

int StepWriter::auxiliary(const std::string& name) {
    const int made = value(name, false, name);
    code_.values[static_cast<std::size_t>(made)].auxiliary = true;
    return made;
}

void StepWriter::rename(int value, const std::string& prefix) {
    std::string& name = code_.values[static_cast<std::size_t>(value)].name;
    names_.erase(name);
    name = prefix + name;
    names_[name] = value;
}

int StepWriter::constant(std::int64_t number, const std::string& shown) {
    const int made = value(fmt::format("{}", number), false);
    Value& of = code_.values[static_cast<std::size_t>(made)];
    of.constant = number;
    of.name = shown.empty() ? of.name : shown;
    return made;
}

int StepWriter::temporary(bool of_axis) {
    return value(fmt::format("t{}", ++temporaries_), of_axis);
}

int StepWriter::wide(const std::string& name) {
    const int made = value(name, false);
    code_.values[static_cast<std::size_t>(made)].wide = true;
    return made;
}

Block& StepWriter::open(bool of_axes) {
    if (part_->blocks.empty() || part_->blocks.back().of_axes != of_axes) {
        part_->blocks.push_back({of_axes, {}});
        of_group_.clear();
    }
    return part_->blocks.back();
}

void StepWriter::changed(int value) {
    for (auto copy = copies_.lower_bound({value, -8, 0});
         copy != copies_.end() && std::get<0>(copy->first) == value;) {
        copy = copies_.erase(copy);
    }
}

void StepWriter::share(Op op, int to, Use a, Use b, bool flag) {
    open(false).steps.push_back({op, to, a, b, flag, source_});
    changed(to);
}

void StepWriter::share_before(Op op, int to, Use a, Use b, bool flag) {
    auto& blocks = part_->blocks;
    const bool own = of_group_.count(a.value) != 0 || of_group_.count(b.value) != 0;
    if (blocks.empty() || !blocks.back().of_axes || own) {
        share(op, to, a, b, flag);
        return;
    }
    if (blocks.size() == 1 || blocks[blocks.size() - 2].of_axes) {
        blocks.insert(blocks.end() - 1, Block{});
    }
    blocks[blocks.size() - 2].steps.push_back({op, to, a, b, flag, source_});
    changed(to);
}

void StepWriter::each(Op op, int to, Use a, Use b, bool flag) {
    open(true).steps.push_back({op, to, a, b, flag, source_});
    changed(to);
    if (!at(to).of_axis) {
        of_group_.insert(to);
    }
}

Use StepWriter::multiplier(std::int64_t number, int lift, const std::string& shown) {
    if (number == 1 && lift >= 0 && lift <= 59) {
        return {-1, lift};
    }
    if (number == -1 && lift == 0) {
        return {-1, Use::kMinusOne};
    }
    const std::int64_t most = (std::int64_t{1} << kProductBits) - 1;
    if (lift < 0 || lift > kProductBits || (number < 0 ? -number : number) > most >> lift) {
        refuse(fmt::format("{} 2^{} is no word of three limbs", number, lift));
    }
    return {constant(number * (std::int64_t{1} << lift), shown), 0};
}

int StepWriter::lift_cost(int value, int lift) const {
    if (lift == 0 || copies_.count({value, 1, lift}) != 0) {
        return 0;
    }
    return bits_ + lift > kProductBits ? 2 : 1;
}

int StepWriter::lifted(int value, int number, int lift) {
    if (number == 1 && lift == 0) {
        return value;
    }
    if (constant_of(value)) {
        return constant(number * *at(value).constant * (std::int64_t{1} << lift));
    }
    const auto found = copies_.find({value, number, lift});
    if (found != copies_.end()) {
        return found->second;
    }
    if (bits_ + lift > kProductBits + 1) {
        refuse(fmt::format("{} 2^{} needs more than three limbs", at(value).name, lift));
    }
    // A sum has a bit more than a product: twice a half, or 0 less the other.
    const auto negative = negatives_.find(value);
    const int other = number == -1                                  ? value
                      : number == 1 && negative != negatives_.end() ? negative->second
                                                                    : -1;
    const bool minus = copies_.count({other, 1, lift}) != 0;
    const bool sum = bits_ + lift > kProductBits && !minus;
    const int half = minus ? lifted(other, 1, lift) : sum ? lifted(value, number, lift - 1) : -1;
    const bool of_axis = at(value).of_axis;
    std::string name = number == 1    ? at(value).name
                       : number == -1 ? "-" + at(value).name
                                      : fmt::format("{} {}", number, at(value).name);
    name += lift != 0 ? fmt::format("<<{}", lift) : "";
    const int copy = this->value(name, of_axis);
    const Use by = half >= 0 ? Use{half, 0} : multiplier(number, lift);
    const Op op = minus ? Op::kSub : sum ? Op::kAdd : Op::kMull;
    const Use a{minus ? constant(0) : sum ? half : value, 0};
    const bool kept = fixed(value) && !(number == -1 && !of_axis);  // a sign costs a step
    if (kept && part_ != &code_.load) {
        Part* const here = part_;
        part_ = &code_.load;
        const std::set<int> group = std::exchange(of_group_, {});
        put(of_axis, op, copy, a, by);
        of_group_ = group;
        part_ = here;
    } else if (of_axis) {
        each(op, copy, a, by);
    } else {
        share_before(op, copy, a, by);
    }
    if (kept) {
        fix(copy);
    }
    if (number == -1 && lift == 0) {
        negatives_[copy] = value;
    }
    copies_[{value, number, lift}] = copy;
    return copy;
}

}  // namespace curvecore::assembler
