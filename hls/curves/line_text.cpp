// SPDX-License-Identifier: Apache-2.0
#include "hls/curves/line_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace curvecore {
namespace hls {

using ref::CurveRow;
using ref::RowOperand;
using ref::TableLine;
using ref::TableTerm;

namespace {

constexpr const char* kAxes[] = {"0", "1", "2"};
constexpr int kMostLift = 16;  // of a word beside products, beyond CoefBits

}  // namespace

std::string coef_bits(int more) {
    if (more == 0) return "C::kCoefBits";
    return fmt::format("C::kCoefBits {} {}", more < 0 ? '-' : '+', std::abs(more));
}

void LineText::refuse(const TableLine& line, const std::string& reason) const {
    ref::Place{table_.file, line.number}.refuse("a kernel of C++ " + reason);
}

std::vector<std::string> LineText::statements(const TableLine& line,
                                              const std::string& section) const {
    const CurveRow& row = table_.rows.at(line.row);
    const bool order = section == "order";
    std::string to = names_.of(line.row) + (row.of_axis ? "[axis]" : "");
    const std::string at = line.order ? std::to_string(*line.order) : order ? "i" : "0";
    if (names_.array(line.row)) to += "[" + at + "]";
    const auto kept = [&](const std::string& word) {
        return fmt::format("{} = keep(Row::{}, {}, {});\n", to, names_.of(line.row), at, word);
    };
    if (table_.guarded.count(line.row) != 0) {
        const std::string fine = names_.guarded(line.row);
        std::vector<std::string> made{fmt::format("{} = {};\n", fine, guarded(line))};
        if (row.start) made.push_back(kept(fmt::format("Steps::unguarded({})", fine)));
        return made;
    }
    if (!line.adds_axes) return {kept(value(line, section, "axis"))};
    std::string sum;
    for (const char* axis : kAxes) {
        sum += (sum.empty() ? "" : " + ") + value(line, section, axis);
    }
    return {kept(fmt::format("Coef({})", sum))};
}

/// A word with ParameterGuard fraction bits more: a sum of such, or a row `>> s`.
std::string LineText::guarded(const TableLine& line) const {
    if (line.down == 0) {
        std::string sum;
        for (const TableTerm& term : line.terms) {
            const char* sign = term.number < 0 ? (sum.empty() ? "-" : " - ")
                               : sum.empty()   ? ""
                                               : " + ";
            sum += sign + names_.guarded(term.a.row);
        }
        return fmt::format("typename C::FineParameter({})", sum);
    }
    const Part row = part(line.terms.front(), false, "axis");
    const int lift = line.fraction - row.fraction;
    if (row.number != 1 || lift < 0 || lift > kMostLift) {
        refuse(line, "takes a coarser row as it is, to `>> s` it into a guarded one");
    }
    const std::string down = line.down == 1 ? "down()" : fmt::format("{} * down()", line.down);
    return fmt::format(
        "Steps::template scaled_down<64, typename C::FineParameter>({}, {}C::kParameterGuard, {})",
        row.text, lift == 0 ? "" : fmt::format("{} + ", lift), down);
}

std::string LineText::value(const TableLine& line, const std::string& section,
                            const std::string& axis) const {
    const bool order = section == "order";
    using Function = TableLine::Function;
    if (line.function != Function::kTerms && line.function != Function::kSum) {
        return polynomial(line, axis);
    }
    std::vector<Part> parts;
    for (const TableTerm& term : line.terms) {
        if (term.all_axes) {
            for (const char* one : kAxes) parts.push_back(part(term, order, one));
        } else {
            parts.push_back(part(term, order, axis));
        }
    }
    const auto zero = [](const Part& one) { return one.text.empty(); };
    parts.erase(std::remove_if(parts.begin(), parts.end(), zero), parts.end());
    if (line.function == Function::kSum) {
        Part all;
        all.text = fmt::format("sum({}, {})", series(line.series, line, axis),
                               limits_.last(line.series.row, section));
        all.fraction = table_.rows.at(line.series.row).fraction;
        all.wide = true;
        parts.push_back(all);
    }
    return rounded(parts, line);
}

/// A series of which a function takes all orders.
std::string LineText::series(const RowOperand& of, const TableLine& line,
                             const std::string& axis) const {
    if (of.primes != 0 || table_.rows.at(of.row).same_as) {
        refuse(line, "takes the orders of a row as they are");
    }
    return names_.of(of.row) + (of.of_axis ? "[" + axis + "]" : "");
}

std::string LineText::polynomial(const TableLine& line, const std::string& axis) const {
    using Function = TableLine::Function;
    if (table_.rows.at(line.series.row).fraction != line.fraction) {
        refuse(line, "has one fraction for a polynomial and its series");
    }
    const std::string row = series(line.series, line, axis);
    const std::string noted = "Row::" + names_.of(line.series.row);
    if (line.function == Function::kHorner) {
        return fmt::format("Steps::in_tau({}, {}, tau)", noted, row);
    }
    const RowOperand x = ref::same_row(table_, {line.variable, false, 0, {}});
    if (x.primes != 0) refuse(line, "takes order 0 of a variable");
    return fmt::format("{}({}, {}, {}{}, {})", line.function == Function::kOdd ? "odd" : "even",
                       noted, row, names_.of(x.row), names_.array(x.row) ? "[0]" : "",
                       coef_bits(table_.rows.at(x.row).fraction));
}

/// An order of a row: i less its primes in `order`, else the one that is named; empty for 0.
std::string LineText::entry(const RowOperand& operand, bool order, const std::string& axis) const {
    const RowOperand of = ref::same_row(table_, operand);
    const std::string word =
        names_.of(of.row) + (table_.rows.at(of.row).of_axis ? "[" + axis + "]" : "");
    const bool by_order = order && !of.order;
    const int at = of.order.value_or(0) - of.primes;
    if (!names_.array(of.row)) {
        return table_.rows.at(of.row).series && !by_order && at < 0 ? "" : word;
    }
    if (by_order) {
        if (of.primes == 0) return word + "[i]";
        if (of.primes == 1) return word + "[i - 1]";
        return fmt::format("before({}, i - {})", word, of.primes);
    }
    if (at < 0) return "";
    const bool always = at <= ref::parameter_of(&ref::CoreParameters::order).low;
    return fmt::format(always ? "{}[{}]" : "named({}, {})", word, at);
}

/// A term; without text where it is 0.
LineText::Part LineText::part(const TableTerm& term, bool order, const std::string& axis) const {
    using Meeting = TableTerm::Meeting;
    Part made;
    made.number = term.number;
    made.fraction = term.halvings;
    if (term.meeting == Meeting::kConstant) {
        made.constant = true;
        made.text = "1";
        return made;
    }
    made.fraction += table_.rows.at(term.a.row).fraction;
    const std::string a = entry(term.a, order, axis);
    if (term.meeting == Meeting::kAlone) {
        made.text = a;
        return made;
    }
    made.product = made.wide = true;
    if (term.meeting == Meeting::kOverOrder) {
        made.text = a.empty() ? "" : fmt::format("over({}, i)", a);
        made.fraction -= 1;
        return made;
    }
    made.fraction += table_.rows.at(term.b.row).fraction;
    if (order && ref::meet_as_series(table_, term)) {
        made.text = meeting(term, axis);
        return made;
    }
    const std::string b = entry(term.b, order, axis);
    made.text = a.empty() || b.empty() ? "" : fmt::format("times({}, {})", a, b);
    return made;
}

/// Two series, with a rate as in a Stieltjes integrator or without.
std::string LineText::meeting(const TableTerm& term, const std::string& axis) const {
    const auto rate = [&](const RowOperand& of) { return table_.rows.at(of.row).rate(of.row); };
    const auto row = [&](const RowOperand& of) {
        return names_.of(of.row) + (table_.rows.at(of.row).of_axis ? "[" + axis + "]" : "");
    };
    const bool turned = rate(term.a) && !rate(term.b);
    const RowOperand u = ref::same_row(table_, turned ? term.b : term.a);
    const RowOperand ds = ref::same_row(table_, turned ? term.a : term.b);
    const int primes = u.primes + ds.primes;
    const bool integral = (rate(term.a) || rate(term.b)) && ds.primes == 0;
    return fmt::format("{}({}, {}, i{})", integral ? "stieltjes" : "series_times", row(u), row(ds),
                       primes == 0 ? "" : fmt::format(" - {}", primes));
}

/// The sum of parts, with CoefBits and `most` fraction bits, of products CoefBits more. A sum and
/// a multiple of words may be wider than they: they are products' words.
std::string LineText::sum_of(const std::vector<Part>& parts, bool products, int most) const {
    std::string sum;
    for (const Part& part : parts) {
        const int magnitude = std::abs(part.number);
        std::string text = part.text;
        if (part.constant) {
            text =
                fmt::format("lifted({}, {}{})", magnitude, products ? "2 * " : "", coef_bits(most));
        } else {
            if (products && !part.product) {
                text = fmt::format("lifted({}, {})", text, coef_bits(most - part.fraction));
            } else if (most != part.fraction) {
                text = fmt::format("lifted({}, {})", text, most - part.fraction);
            } else if (!part.wide && (parts.size() > 1 || part.number != 1)) {
                text = fmt::format("Product({})", text);
            }
            if (magnitude != 1) text = fmt::format("{} * {}", magnitude, text);
        }
        if (part.number < 0) {
            sum += sum.empty() ? "-" : " - ";
        } else if (!sum.empty()) {
            sum += " + ";
        }
        sum += text;
    }
    return sum;
}

/// The sum of parts, rounded once to the line's fraction.
std::string LineText::rounded(const std::vector<Part>& parts, const TableLine& line) const {
    if (parts.empty()) return "0";
    constexpr int kNone = -1000;
    int finest[2] = {kNone, kNone};
    for (const Part& part : parts) {
        if (!part.constant) finest[part.product] = std::max(finest[part.product], part.fraction);
    }
    const bool products = finest[1] != kNone;
    const int most = products ? finest[1] : finest[0] != kNone ? finest[0] : line.fraction;
    for (const Part& part : parts) {
        if (part.constant && part.fraction != 0) {
            refuse(line, "takes whole numbers as constants alone");
        }
        if (!part.constant && products && !part.product && part.fraction - most > kMostLift) {
            refuse(line, "has no word for terms of so different fractions");
        }
    }
    if (products && line.fraction - most > ref::parameter_of(&ref::CoreParameters::coef_bits).low) {
        refuse(line, "rounds products: these are coarser than their line");
    }
    const std::string sum = sum_of(parts, products, most);
    const int shift = most - line.fraction;  // and CoefBits, of products
    if (line.down > 0) {
        const std::string down = line.down == 1 ? "down()" : fmt::format("{} * down()", line.down);
        const std::string by = products    ? coef_bits(shift) + " + " + down
                               : shift > 0 ? fmt::format("{} + {}", shift, down)
                                           : down;
        const bool narrow = !products && shift <= 0 && -shift <= kMostLift;
        return fmt::format("Steps::template scaled_down<{}>({}, {}, {})", narrow ? 64 : 127, sum,
                           products ? 0 : std::max(0, -shift), by);
    }
    if (products) return fmt::format("rounded({}, {})", sum, coef_bits(shift));
    if (shift == 0) return fmt::format("Coef({})", sum);
    if (shift < 0) return fmt::format("Coef(lifted({}, {}))", sum, -shift);
    return fmt::format("rounded({}, {})", sum, shift);
}

}  // namespace hls
}  // namespace curvecore
