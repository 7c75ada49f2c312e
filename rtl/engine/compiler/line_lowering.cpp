// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/line_lowering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hls/fixed_word.hpp"
#include "ref/curves/order_demand.hpp"
#include "rtl/engine/compiler/table_lowering.hpp"

namespace curvecore::assembler {

using engine::Op;
using ref::RowOperand;
using ref::TableLine;
using ref::TableTerm;
using Meeting = TableTerm::Meeting;
using Function = TableLine::Function;

namespace {

constexpr int kProductShift = 45;  // of MULR, MADR, SHR
constexpr int kWordBits = 46;      // of a factor

}  // namespace

LineLowering::LineLowering(const ref::CurveTable& table, const ref::CoreParameters& core,
                           const std::map<std::string, int>& demand, StepWriter& writer)
    : table_(table), core_(core), demand_(demand), writer_(writer) {
    for (const auto& [name, lines] : table.sections) {
        if (name == "carry") continue;  // the engine anchors
        for (const TableLine& line : lines) {
            ++reads_[line.series.row];
            ++reads_[line.variable];
            for (const TableTerm& term : line.terms) {
                ++reads_[term.a.row];
                ++reads_[term.b.row];
            }
        }
    }
}

int LineLowering::state(const std::string& row, const std::string& word) {
    const ref::CurveRow& of = table_.rows.at(row);
    const std::string name = row + (of.of_axis ? "[k]" : "") + (of.series ? ".0" : "");
    const int made = writer_.value(name, of.of_axis, word);
    row_of_[made] = row;
    return made;
}

int LineLowering::constant(double value, int fraction) {
    const double scaled = std::ldexp(value, core_.coef_bits + fraction);
    if (scaled != std::floor(scaled) || std::abs(scaled) >= std::ldexp(1.0, kWordBits - 1)) {
        writer_.refuse(fmt::format("{} is no word of three limbs with {} fraction bits", value,
                                   core_.coef_bits + fraction));
    }
    return writer_.constant(static_cast<std::int64_t>(scaled));
}

int LineLowering::entry_of(const std::string& row, int i) {
    const ref::CurveRow& of = table_.rows.at(row);
    const std::string name =
        row + (of.of_axis ? "[k]" : "") + (of.series ? fmt::format(".{}", i) : "");
    const int made = writer_.value(name, of.of_axis);
    row_of_[made] = row;
    const auto same = same_.find(made);
    return same == same_.end() ? made : same->second;
}

int LineLowering::entry(const RowOperand& operand, int i) {
    const RowOperand of = same_row(table_, operand);
    const ref::CurveRow& row = table_.rows.at(of.row);
    if (row.value && !row.start) {
        return constant(*row.value, row.fraction);
    }
    if (!row.series) {
        return entry_of(of.row, 0);
    }
    const int order = of.order.value_or(i) - of.primes;
    const auto needed = demand_.find(of.row);
    bool made = order >= 1 && needed != demand_.end() && order <= needed->second;
    made |= order == 0 && row.start;
    for (const TableLine& line : table_.section("anchor")) {
        made |= line.row == of.row && line.order.value_or(0) == order;
    }
    return made ? entry_of(of.row, order) : writer_.constant(0);
}

LineLowering::Addend LineLowering::meet(const TableLine& line, const TableTerm& term, int a,
                                        int b) const {
    Addend one;
    one.a = a;
    one.b = b;
    one.number = term.number;
    one.all_axes = term.all_axes;
    one.shift = fraction(term.a) - line.fraction + term.halvings;
    if (b >= 0) {
        one.shift += core_.coef_bits + fraction(term.b);
    }
    return one;
}

void LineLowering::addends(const TableLine& line, const TableTerm& term, int i,
                           std::vector<Addend>& all) {
    const int zero = writer_.constant(0);
    const auto add = [&](Addend one) {
        for (; one.number % 2 == 0; one.number /= 2) {
            --one.shift;
        }
        if (one.a != zero && one.b != zero) {
            all.push_back(one);
        }
    };
    if (term.meeting == Meeting::kConstant) {
        const double value = std::ldexp(static_cast<double>(term.number), -term.halvings);
        if (value != 0) {
            all.push_back({constant(value, line.fraction), -1, 1, 0, false, 0});
        }
    } else if (term.meeting == Meeting::kAlone) {
        add(meet(line, term, entry(term.a, i), -1));
    } else if (term.meeting == Meeting::kOverOrder) {
        Addend one = meet(line, term, entry(term.a, i), -1);
        if (i > 1) {
            one.over = i;
            one.number *= hls::reciprocal(i, core_.coef_bits - 1);
            one.shift += core_.coef_bits - 1;
        }
        add(one);
    } else if (i > 0 && meet_as_series(table_, term)) {
        TableTerm ordered = term;
        const auto rate = [&](const RowOperand& of) { return table_.rows.at(of.row).rate(of.row); };
        if (rate(term.a) && !rate(term.b)) {
            std::swap(ordered.a, ordered.b);
        }
        const int last = rate(ordered.b) ? i - 1 : i;
        for (int j = 0; j <= last; ++j) {
            add(meet(line, ordered, entry(ordered.a, j), entry(ordered.b, i - j)));
        }
    } else {
        add(meet(line, term, entry(term.a, i), entry(term.b, i)));
    }
}

int LineLowering::lower(const TableLine& line, int i) {
    writer_.from({table_.file, line.number,
                  i == 0 ? line.text : fmt::format("{:<32} i = {}", line.text, i)});
    const int to = entry_of(line.row, line.order.value_or(i));
    if (line.down != 0) {
        scaled_down(line, to);
        return to;
    }
    if (line.function == Function::kSum) {
        return sum(line, line.of_axis, to);
    }
    if (line.function != Function::kTerms) {
        return polynomial(line, line.of_axis, to);
    }
    std::vector<Addend> all;
    for (const TableTerm& term : line.terms) {
        addends(line, term, i, all);
    }
    std::vector<Addend> exact;
    std::vector<Addend> rounded;
    for (const Addend& one : all) {
        (one.exact() ? exact : rounded).push_back(one);
    }
    if (rounded.empty() && exact.size() == 1 && exact[0].number == 1 && exact[0].shift == 0 &&
        i > 0 && line.terms[0].a.order.value_or(i) - line.terms[0].a.primes > 0) {
        same_[to] = exact[0].a;
        return exact[0].a;
    }
    if (line.order && rounded.empty() && exact.size() <= 1) {
        const int only = exact.empty() ? writer_.constant(0) : exact[0].a;
        if (writer_.at(only).constant && (exact.empty() || exact[0].number == 1)) {
            same_[to] = only;
            return only;
        }
    }
    const bool of_axis = line.of_axis || line.adds_axes;
    if (line.adds_axes) {
        writer_.share_before(Op::kMull, to, {writer_.constant(0)}, {-1, 0});
    }
    const bool alone = exact.empty() && !line.adds_axes;
    int made = -1;
    if (!rounded.empty()) {
        made = alone ? to : writer_.temporary(of_axis);
        if (rounded.size() == 1 && !rounded[0].all_axes) {
            single(rounded[0], of_axis, made);
        } else {
            chain(rounded, of_axis, made);
        }
    }
    if (line.adds_axes) {
        if (!exact.empty()) {
            writer_.refuse("+= adds a sum of products");
        }
        writer_.each(Op::kAdd, to, {to}, {made});
    } else if (!alone || rounded.empty()) {
        total(to, of_axis, exact, made);
    }
    return to;
}

void LineLowering::lower_anew(const TableLine& line, int i) {
    writer_.rename(entry_of(line.row, i), "early ");
    lower(line, i);
}

int LineLowering::single(const Addend& one, bool of_axis, int to) {
    if (one.b < 0) {
        writer_.put(of_axis, Op::kMulr, to, {one.a},
                    writer_.multiplier(one.number, kProductShift - one.shift,
                                       one.over > 0 ? fmt::format("1/{}", one.over) : ""));
    } else if (one.number == 1) {
        product(to, one.a, one.b, one.shift, of_axis);
    } else if (writer_.fixed(one.b) && !writer_.at(one.b).constant) {
        product(to, one.a, writer_.lifted(one.b, static_cast<int>(one.number), 0), one.shift,
                of_axis);
    } else {
        product(to, writer_.lifted(one.a, static_cast<int>(one.number), 0), one.b, one.shift,
                of_axis);
    }
    return to;
}

void LineLowering::product(int to, int a, int b, int shift, bool of_axis) {
    const int lift = kProductShift - shift;
    const int most = kWordBits - core_.coef_bits;
    if (lift < 0 || lift > 2 * most) {
        writer_.refuse(fmt::format("a product over 2^{} fits no three limbs", shift));
    }
    const auto cost = [&](int value, int by) {
        const int steps = writer_.lift_cost(value, by);
        if (writer_.fixed(value)) {
            return steps * (writer_.at(value).of_axis ? 0.2 : 0.1);
        }
        const double passes = of_axis && !writer_.at(value).of_axis ? 3 : 1;
        const auto row = row_of_.find(value);
        return steps / passes / (row == row_of_.end() ? 1 : std::max(1, reads_[row->second]));
    };
    int of_a = -1;
    double least = 0;
    for (const int by : {std::min(lift, most), lift - std::min(lift, most)}) {
        const double sum = cost(a, by) + cost(b, lift - by);
        if (of_a < 0 || sum < least) {
            of_a = by;
            least = sum;
        }
    }
    const int left = writer_.lifted(a, 1, of_a);
    const int right = writer_.lifted(b, 1, lift - of_a);
    writer_.put(of_axis, Op::kMulr, to, {left}, {right});
}

int LineLowering::chain(const std::vector<Addend>& all, bool of_axis, int to) {
    int shift = 0;
    bool all_axes = false;
    for (const Addend& one : all) {
        shift = std::max(shift, one.shift);
        all_axes |= one.all_axes;
    }
    const int wide = writer_.wide(all_axes ? "sum of axes" : "sum");
    if (all_axes) {
        writer_.share_before(Op::kMac, wide, {writer_.constant(0)}, {-1, 0}, true);
    }
    bool first = !all_axes;
    for (const Addend& one : all) {
        const int number = static_cast<int>(one.number);
        if (one.b < 0) {
            writer_.put(of_axis || all_axes, Op::kMac, wide, {one.a},
                        writer_.multiplier(number, shift - one.shift), first);
        } else {
            const int a = writer_.lifted(one.a, number, shift - one.shift);
            writer_.put(of_axis || all_axes, Op::kMac, wide, {a}, {one.b}, first);
        }
        first = false;
    }
    writer_.put(of_axis, Op::kShr, to, {wide}, {-1, kProductShift - shift});
    return to;
}

int LineLowering::exactly(const Addend& one) {
    return writer_.lifted(one.a, static_cast<int>(std::abs(one.number)), -one.shift);
}

void LineLowering::total(int to, bool of_axis, const std::vector<Addend>& exact, int rounded) {
    std::vector<std::pair<int, bool>> items;  // value and minus
    items.reserve(exact.size() + 2);
    for (const Addend& one : exact) {
        items.emplace_back(exactly(one), one.number < 0);
    }
    if (rounded >= 0) {
        items.emplace_back(rounded, false);
    }
    std::stable_sort(items.begin(), items.end(),
                     [](const auto& a, const auto& b) { return a.second < b.second; });
    if (items.empty()) {
        items.emplace_back(writer_.constant(0), false);
    }
    if (items.size() == 1) {
        const int power = items[0].second ? Use::kMinusOne : 0;
        writer_.put(of_axis, Op::kMull, to, {items[0].first}, {-1, power});
        return;
    }
    if (items[0].second) {
        items.insert(items.begin(), {writer_.constant(0), false});
    }
    int sum = items[0].first;
    for (std::size_t n = 1; n < items.size(); ++n) {
        const int next = n + 1 == items.size() ? to : writer_.temporary(of_axis);
        writer_.put(of_axis, items[n].second ? Op::kSub : Op::kAdd, next, {sum}, {items[n].first});
        sum = next;
    }
}

void LineLowering::scaled_down(const TableLine& line, int to) {
    std::vector<Addend> all;
    addends(line, line.terms[0], 0, all);
    if (all.size() != 1 || all[0].b >= 0 || std::abs(all[0].number) != 1 || all[0].shift > 1 ||
        line.down > 2) {
        writer_.refuse(">> s and >> 2s take a row times a power of two");
    }
    const int lift = 1 - all[0].shift;
    const char* const scale = line.down == 1 ? scale_word::kDown : scale_word::kDownTwice;
    writer_.put(line.of_axis, Op::kMulr, to,
                {writer_.lifted(all[0].a, static_cast<int>(all[0].number), lift)},
                {writer_.value(scale, false)});
}

int LineLowering::sum(const TableLine& line, bool of_axis, int to) {
    std::vector<Addend> all;
    for (const TableTerm& term : line.terms) {
        addends(line, term, 0, all);
    }
    const RowOperand row = same_row(table_, line.series);
    const auto top = demand_.find(row.row);
    for (int i = 1; top != demand_.end() && i <= top->second; ++i) {
        all.push_back({entry(row, i), -1, 1, fraction(row) - line.fraction, false, 0});
    }
    for (const Addend& one : all) {
        if (!one.exact()) {
            writer_.refuse("sum(..) is exact: its row has no more fraction bits");
        }
    }
    total(to, of_axis, all, -1);
    return to;
}

int LineLowering::polynomial(const TableLine& line, bool of_axis, int to) {
    const bool horner = line.function == Function::kHorner;
    const std::string variable = horner ? "tau" : line.variable;
    const int x = state(variable);
    const int shift = core_.coef_bits + table_.rows.at(variable).fraction;
    if (!line.terms.empty() || fraction(line.series) != line.fraction) {
        writer_.refuse("a polynomial has the fraction of its series, and no other term");
    }
    const int by = horner ? 1 : 2;
    const int last = line.function == Function::kEven ? 2 : 1;
    const bool times = line.function != Function::kOdd;  // once more by the variable
    const int top = core_.order - (core_.order - last) % by;
    int sum = entry(line.series, top);
    for (int i = top - by; i >= last; i -= by) {
        const int rounded = writer_.temporary(of_axis);
        product(rounded, sum, x, shift, of_axis);
        sum = i == last && !times ? to : writer_.temporary(of_axis);
        writer_.put(of_axis, Op::kAdd, sum, {entry(line.series, i)}, {rounded});
    }
    if (times) {
        product(to, sum, x, shift, of_axis);
    } else if (top == last) {
        writer_.put(of_axis, Op::kMull, to, {sum}, {-1, 0});
    }
    return to;
}

void LineLowering::move(int to, int from, int displacement, const char* scale) {
    const bool of_axis = writer_.at(to).of_axis;
    const int lift = fine_scale(core_).lift;
    const int lifted = lift == 0 ? displacement : writer_.temporary(of_axis);
    if (lift != 0) {
        writer_.put(of_axis, Op::kMull, lifted, {displacement}, {-1, lift});
    }
    const int moved = writer_.temporary(of_axis);
    writer_.put(of_axis, Op::kMulr, moved, {lifted}, {writer_.value(scale, false)});
    writer_.put(of_axis, Op::kAdd, to, {from}, {moved});
}

}  // namespace curvecore::assembler
