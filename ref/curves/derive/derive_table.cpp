// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/derive/derive_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <set>

#include "ref/curves/derive/table_text.hpp"
#include "ref/curves/table_machine.hpp"
#include "ref/curves/table_reader.hpp"

namespace curvecore::ref {
namespace {

using Kind = FormulaNode::Kind;

constexpr int kPlaces = 1000;         // at which a curve is looked at
constexpr double kLeastSpeed = 0.02;  // of the largest: V keeps its digits
constexpr int kSteps = 64;            // of the whole curve, at least: ranges are theirs
constexpr double kRoom = 1.5;         // of ranges
constexpr int kOrders = 8;            // in which ranges are looked for
constexpr double kConverged = 1e-6;
constexpr int kMostHalvings = 12;
constexpr int kRateBits = 8;
constexpr double kLeastFraction = -16;
constexpr double kMostFraction = 8;

class Deriver {
  public:
    explicit Deriver(const CurveFormula& formula) : asked_(formula) {
        for (const std::string& text : formula.coordinates) {
            places_.push_back(formulas_.read(text, formula.constants));
        }
    }

    DerivedTable run() {
        look_at_speed();
        write();
        DerivedTable made;
        made.length = length();
        const std::vector<double> at = formulas_.values(asked_.from);
        for (std::size_t n = 0; n < places_.size(); ++n) {
            made.start[n] = at[static_cast<std::size_t>(places_[n])];
        }
        made.rows["mu"] = {1 / largest_, 0, 0};
        for (int n = 0; n < text_.frame; ++n) {
            auto& vector = made.rows[fmt::format("e{}", n + 1)];
            vector = {};
            vector[static_cast<std::size_t>(n)] = 1;
        }
        for (const auto& [row, node] : state_nodes_) {
            made.rows[row] = {at[static_cast<std::size_t>(node)], 0, 0};
        }
        for (const auto& [row, number] : numbers_) made.rows[row] = {number, 0, 0};
        made.rows["phi"] = {largest_ / speed(asked_.from), 0, 0};
        made.text = text_.text(fractions(made));
        return made;
    }

  private:
    double speed(double t) {
        const std::vector<double> at = formulas_.values(t);
        double sum = 0;
        for (const int slope : slopes_) {
            sum += at[static_cast<std::size_t>(slope)] * at[static_cast<std::size_t>(slope)];
        }
        return std::sqrt(sum);
    }

    /// The derivatives, the largest speed, and whether there is one everywhere.
    void look_at_speed() {
        for (const int place : places_) slopes_.push_back(formulas_.derivative(place));
        double least = 0;
        double at_least = 0;
        for (int i = 0; i <= kPlaces; ++i) {
            const double t = asked_.from + (asked_.to - asked_.from) * i / kPlaces;
            const double v = speed(t);
            if (!std::isfinite(v)) {
                throw FormulaError(fmt::format("at t = {:.6g} the curve has no slope", t));
            }
            largest_ = std::max(largest_, v);
            if (i == 0 || v < least) {
                least = v;
                at_least = t;
            }
        }
        if (!(least > kLeastSpeed * largest_)) {
            throw FormulaError(
                fmt::format("near t = {:.6g} the curve all but stands still: |dr/dt| is {:.3g} of "
                            "{:.3g}",
                            at_least, least, largest_));
        }
    }

    double length() {
        double sum = 0;
        for (int part = 0; part < kSteps; ++part) {
            const double step = (asked_.to - asked_.from) / kSteps;
            sum += boost::math::quadrature::gauss<double, 20>::integrate(
                [this](double t) { return speed(t); }, asked_.from + step * part,
                asked_.from + step * (part + 1));
        }
        return sum;
    }

    /// Marks what a node is made of: for its rate, and for its value unless only the rate is read.
    void need(int n, bool rate, bool value = true) {
        if (formulas_.is_number(n)) return;
        const bool known = (!value || values_.count(n) != 0) && (!rate || rates_.count(n) != 0);
        if (known) return;
        if (value) values_.insert(n);
        if (rate) rates_.insert(n);
        const FormulaNode node = formulas_.at(n);
        if (node.kind == Kind::kParameter) return;
        if (node.kind == Kind::kSum) {
            for (const auto& [factor, of] : formulas_.parts(n)) need(of, rate, value);
        } else if (node.kind == Kind::kProduct) {
            const bool linear = formulas_.is_number(node.a);
            need(node.a, rate, value || (rate && !linear));
            need(node.b, rate, value || (rate && !linear));
        } else {
            rates_.insert(n);
            values_.insert(n);  // its equation reads it, or the one beside it
            need(node.a, true, false);
            if (const int other = beside(n); other >= 0) need(other, true);
        }
    }

    /// A function that another's equation asks for; -1: none.
    int beside(int n) {
        const FormulaNode node = formulas_.at(n);
        if (node.kind == Kind::kSine) return formulas_.of(Kind::kCosine, node.a);
        if (node.kind == Kind::kCosine) return formulas_.of(Kind::kSine, node.a);
        if (node.kind == Kind::kLogarithm) return formulas_.of(Kind::kInverse, node.a);
        if (node.kind != Kind::kArcTangent) return -1;
        return formulas_.of(Kind::kInverse,
                            formulas_.sum(formulas_.number(1), formulas_.product(node.a, node.a)));
    }

    const std::string& name(int n) {
        std::string& name = names_[n];
        if (!name.empty()) return name;
        const FormulaNode& node = formulas_.at(n);
        if (node.kind == Kind::kParameter) return name = "t";
        name = fmt::format("{}{}", name_of(node.kind), ++counts_[node.kind]);
        if (node.kind == Kind::kNumber) {
            text_.number(name);
            numbers_[name] = node.number;
        }
        return name;
    }
    std::string rate(int n) { return "D" + name(n); }

    /// A number before a row: a sign, or a row of its own.
    std::string times(double number, const std::string& row, int n) {
        return number == -1 ? "- " + row : name(n) + "*" + row;
    }

    /// Writes the lines of a node behind those of its operands.
    void emit(int n) {
        if (formulas_.is_number(n) || !emitted_.insert(n).second) return;
        const FormulaNode node = formulas_.at(n);
        const std::string row = name(n);
        if (node.kind == Kind::kParameter) {
            if (values_.count(n) != 0) carry(n);
            return;
        }
        if (node.kind == Kind::kSum) {
            emit_sum(n);
            return;
        }
        emit(node.a);
        if (node.kind == Kind::kProduct) {
            emit(node.b);
            emit_product(n, node);
            return;
        }
        const std::string inner = rate(node.a);
        const int other = beside(n);
        const auto equation = [&](const std::string& factor) {
            text_.line("order", rate(n), fmt::format("{}*{}", factor, inner));
        };
        const auto multiple = [&](const std::string& what, const std::string& factors) {
            text_.line("anchor", row + what, factors);
            later_.emplace_back(row + what, factors);
        };
        if (node.kind == Kind::kCosine) {
            equation("- " + name(other));
        } else if (node.kind == Kind::kExponential) {
            equation(row);
        } else if (node.kind == Kind::kInverse) {
            multiple("_2", fmt::format("{0}*{0}", row));
            equation(fmt::format("- {}_2", row));
        } else if (node.kind == Kind::kInverseRoot) {
            multiple("_2", fmt::format("{0}*{0}", row));
            multiple("_3", fmt::format("{0}_2*{0}", row));
            equation(fmt::format("- 1/2 {}_3", row));
        } else {
            equation(name(other));
        }
        carry(n);
        for (const auto& [of, factors] : later_) text_.line("order", of, factors);
        later_.clear();
        if (other >= 0) emit(other);
    }

    /// A row that is carried from step to step, by its rate.
    void carry(int n) {
        const std::string row = name(n);
        text_.line("order", row, fmt::format("{}/i", rate(n)));
        text_.state(row);
        state_nodes_[row] = n;
    }

    void emit_sum(int n) {
        std::string rates, orders, value;
        const auto add = [](const std::string& term, std::string& sum) {
            const bool minus = term.rfind("- ", 0) == 0;
            sum += sum.empty() ? term : minus ? " " + term : " + " + term;
        };
        for (const auto& [factor, of] : formulas_.parts(n)) {
            emit(of);
            const double number = factor < 0 ? 1 : formulas_.at(factor).number;
            const auto term = [&, part = factor](const std::string& row) {
                return part < 0 ? row : times(number, row, part);
            };
            add(term(name(of)), value);
            if (formulas_.is_number(of)) continue;
            add(term(name(of)), orders);
            add(term(rate(of)), rates);
        }
        emit_made(n, value, orders, rates);
    }

    void emit_product(int n, const FormulaNode& node) {
        if (formulas_.is_number(node.a)) {
            const double number = formulas_.at(node.a).number;
            const std::string value = times(number, name(node.b), node.a);
            emit_made(n, value, value, times(number, rate(node.b), node.a));
            return;
        }
        const std::string value = fmt::format("{}*{}", name(node.a), name(node.b));
        emit_made(
            n, value, value,
            fmt::format("{}*{} + {}*{}", name(node.a), rate(node.b), name(node.b), rate(node.a)));
    }

    void emit_made(int n, const std::string& value, const std::string& orders,
                   const std::string& rates) {
        const bool read = values_.count(n) != 0;
        if (read) text_.line("anchor", name(n), value);
        if (rates_.count(n) == 0) {
            text_.line("order", name(n), orders);
            return;
        }
        text_.line("order", rate(n), rates);
        if (read) text_.line("order", name(n), fmt::format("{}/i", rate(n)));
    }

    void write() {
        const int scale = formulas_.number(1 / largest_);
        std::vector<int> v;  // coordinates of V that are not 0, and their vectors
        std::vector<int> of;
        for (std::size_t n = 0; n < slopes_.size(); ++n) {
            const int slope = formulas_.product(scale, slopes_[n]);
            if (formulas_.is_number(slope) && formulas_.at(slope).number == 0) continue;
            v.push_back(slope);
            of.push_back(static_cast<int>(n) + 1);
        }
        const bool bends =
            std::any_of(v.begin(), v.end(), [this](int n) { return !formulas_.is_number(n); });
        if (!bends) throw FormulaError("a straight line: it needs no table");
        text_.frame = static_cast<int>(slopes_.size());
        std::string title;
        for (std::size_t n = 0; n < slopes_.size(); ++n) {
            title += fmt::format("{}{} = {}", n == 0 ? "" : ", ", "xyz"[n], asked_.coordinates[n]);
        }
        text_.head(fmt::format("# {}", title));
        for (const auto& [name, value] : asked_.constants) {
            text_.head(fmt::format("# {} = {:.17g}", name, value));
        }
        text_.head(fmt::format("curve {} The curve of a formula, in any frame", asked_.name));
        text_.line("order", "Dt", "mu*phi'");
        for (const int slope : v) need(slope, true);
        for (const int slope : v) emit(slope);
        std::string half;  // of d|V|^2
        std::string tangent;
        for (std::size_t n = 0; n < v.size(); ++n) {
            if (!formulas_.is_number(v[n])) {
                half += fmt::format("{}{}*{}", half.empty() ? "" : " + ", name(v[n]), rate(v[n]));
            }
            tangent += fmt::format("{}e{}[k]*P{}", n == 0 ? "" : " + ", of[n], of[n]);
        }
        text_.state("phi");
        text_.line("order", "DG", half);
        text_.line("order", "Dphi", "Q*DG");
        text_.line("order", "phi", "Dphi/i");
        for (const char* section : {"anchor", "order"}) {
            text_.line(section, "S", "phi*phi");
            text_.line(section, "Q", "- S*phi");
            for (std::size_t n = 0; n < v.size(); ++n) {
                text_.line(section, fmt::format("P{}", of[n]), name(v[n]) + "*phi");
            }
            text_.line(section, "T[k]", tangent);
        }
        text_.line("order", "x[k]", "T[k]'/i");
        text_.line("next", "move[k]", "sum(x[k])");
        for (const std::string& row : text_.states()) {
            text_.line("next", row, fmt::format("{0} + sum({0})", row));
        }
        const std::size_t words = text_.states().size() + text_.numbers().size();
        if (words > static_cast<std::size_t>(kMostFurther)) {
            throw FormulaError(
                fmt::format("the formula has {} functions that are carried on and {} "
                            "numbers: a segment has words for {} in all",
                            text_.states().size(), text_.numbers().size(), kMostFurther));
        }
    }

    /// Fractions that hold what each row comes to along the curve.
    std::map<std::string, int> fractions(const DerivedTable& made) const {
        const CurveTable table = read_curve_text(asked_.name + ".net", text_.text({}));
        double h = made.length / kSteps;
        for (int halvings = 0;; ++halvings, h /= 2) {
            if (halvings > kMostHalvings) {
                throw FormulaError("its series do not converge, in however short steps");
            }
            TableMachine<double> machine(table, kOrders, false);
            for (const auto& [row, values] : made.rows) {
                const double scale = row == "mu" ? h : 1;
                const int axes = table.rows.at(row).of_axis ? 3 : 1;
                for (int axis = 0; axis < axes; ++axis) {
                    machine.set(row, scale * values[static_cast<std::size_t>(axis)], axis);
                }
            }
            machine.begin({}, 0, 0);
            bool converged = true;
            const auto steps = static_cast<int>(std::ceil(made.length / h));
            for (int step = 0; step < steps && converged; ++step) {
                if (step > 0) machine.leave();
                machine.open();
                for (int axis = 0; axis < 3; ++axis) {
                    const double last = std::abs(machine.value("x", kOrders, axis));
                    converged = converged && last < kConverged;  // also not a number
                }
            }
            if (!converged) continue;
            std::map<std::string, int> fractions;
            for (const auto& [name, row] : table.rows) {
                double largest = machine.largest(name);
                if (name == "mu") largest = h / largest_;
                if (largest == 0) continue;
                const double fits = std::floor(-1 - std::log2(kRoom * largest));
                if (fits < kLeastFraction) {
                    throw FormulaError(
                        fmt::format("{} of it comes to {:.3g}, more than a word "
                                    "holds: let t have another scale",
                                    name, largest));
                }
                fractions[name] = static_cast<int>(std::min(fits, kMostFraction));
            }
            for (auto& [name, fraction] : fractions) {
                // A rate over i is rounded at 2^45: it has no more than so many bits below its row.
                const auto row = fractions.find(name.substr(1));
                if (name[0] == 'D' && row != fractions.end()) {
                    fraction = std::min(fraction, row->second + kRateBits);
                }
            }
            return fractions;
        }
    }

    const CurveFormula& asked_;
    Formulas formulas_;
    std::vector<int> places_;
    std::vector<int> slopes_;
    double largest_ = 0;
    std::set<int> values_;  // nodes whose value is read
    std::set<int> rates_;   // nodes whose rate is
    std::set<int> emitted_;
    std::map<int, std::string> names_;
    std::map<Kind, int> counts_;
    std::map<std::string, int> state_nodes_;
    std::map<std::string, double> numbers_;
    std::vector<std::pair<std::string, std::string>> later_;
    TableText text_;
};

}  // namespace

DerivedTable derive_table(const CurveFormula& formula) {
    if (!(formula.from < formula.to)) throw FormulaError("t goes from less to more");
    return Deriver(formula).run();
}

}  // namespace curvecore::ref
