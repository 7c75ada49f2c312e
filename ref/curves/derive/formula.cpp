// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/derive/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace curvecore::ref {
namespace {

constexpr double kLargestPower = 64;
constexpr int kMostNodes = 5000;
constexpr int kDeepest = 200;  // parentheses in each other

/// A recursive-descent reader of one formula.
class FormulaReader {
  public:
    FormulaReader(Formulas& formulas, const std::string& text,
                  const std::map<std::string, double>& constants)
        : formulas_(formulas), text_(text), constants_(constants) {}

    int whole() {
        const int made = terms();
        if (at_ < text_.size()) refuse("expected an operator");
        return made;
    }

  private:
    [[noreturn]] void refuse(const std::string& reason) const {
        const std::string rest = at_ < text_.size() ? "'" + text_.substr(at_) + "'" : "the end";
        throw FormulaError(fmt::format("'{}': {}, not {}", text_, reason, rest));
    }
    void skip() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    bool take(char c) {
        skip();
        if (at_ == text_.size() || text_[at_] != c) return false;
        ++at_;
        skip();
        return true;
    }

    int terms() {
        if (++depth_ > kDeepest) throw FormulaError(fmt::format("'{}': too deep", text_));
        int sum = factors();
        while (true) {
            if (take('+')) {
                sum = formulas_.sum(sum, factors());
            } else if (take('-')) {
                sum = formulas_.sum(sum, formulas_.product(formulas_.number(-1), factors()));
            } else {
                --depth_;
                return sum;
            }
        }
    }
    int factors() {
        int product = signed_power();
        while (true) {
            if (take('*')) {
                product = formulas_.product(product, signed_power());
            } else if (take('/')) {
                product = formulas_.product(product, formulas_.power(signed_power(), -1));
            } else {
                return product;
            }
        }
    }
    int signed_power() {
        bool minus = false;
        while (take('-')) minus = !minus;
        const int made = power();
        return minus ? formulas_.product(formulas_.number(-1), made) : made;
    }
    int power() {
        if (++depth_ > kDeepest) throw FormulaError(fmt::format("'{}': too deep", text_));
        const int made = raised();
        --depth_;
        return made;
    }
    int raised() {
        const int base = atom();
        if (!take('^')) return base;
        const int exponent = signed_power();
        if (formulas_.is_number(exponent)) {
            return formulas_.power(base, formulas_.at(exponent).number);
        }
        return formulas_.of(
            Formulas::Kind::kExponential,
            formulas_.product(exponent, formulas_.of(Formulas::Kind::kLogarithm, base)));
    }
    int atom() {
        skip();
        if (take('(')) {
            const int inside = terms();
            if (!take(')')) refuse("expected ')'");
            return inside;
        }
        if (at_ < text_.size() && (std::isdigit(byte()) != 0 || text_[at_] == '.')) {
            std::size_t used = 0;
            double value = 0;
            try {
                value = std::stod(text_.substr(at_), &used);
            } catch (const std::logic_error&) {
                refuse("expected a number");
            }
            at_ += used;
            skip();
            return formulas_.number(value);
        }
        const std::size_t first = at_;
        while (at_ < text_.size() && (std::isalnum(byte()) != 0 || text_[at_] == '_')) ++at_;
        const std::string name = text_.substr(first, at_ - first);
        if (name.empty()) refuse("expected a number, a name or '('");
        if (take('(')) return function(name);
        skip();
        if (name == "t") return formulas_.parameter();
        if (name == "pi") return formulas_.number(M_PI);
        const auto constant = constants_.find(name);
        if (constant == constants_.end()) {
            throw FormulaError(
                fmt::format("'{}': {} has no value: --let {}=..", text_, name, name));
        }
        return formulas_.number(constant->second);
    }
    int function(const std::string& name) {
        const int a = terms();
        if (!take(')')) refuse("expected ')'");
        const auto e = [&](double sign) {
            return formulas_.of(FormulaNode::Kind::kExponential,
                                formulas_.product(formulas_.number(sign), a));
        };
        const auto halves = [&](double sign) {
            return formulas_.sum(formulas_.product(formulas_.number(0.5), e(1)),
                                 formulas_.product(formulas_.number(0.5 * sign), e(-1)));
        };
        const auto over = [&](int up, int down) {
            return formulas_.product(up, formulas_.power(down, -1));
        };
        if (name == "sin") return formulas_.of(FormulaNode::Kind::kSine, a);
        if (name == "cos") return formulas_.of(FormulaNode::Kind::kCosine, a);
        if (name == "tan")
            return over(formulas_.of(FormulaNode::Kind::kSine, a),
                        formulas_.of(FormulaNode::Kind::kCosine, a));
        if (name == "sinh") return halves(-1);
        if (name == "cosh") return halves(1);
        if (name == "tanh") return over(halves(-1), halves(1));
        if (name == "exp") return e(1);
        if (name == "log") return formulas_.of(FormulaNode::Kind::kLogarithm, a);
        if (name == "sqrt") return formulas_.power(a, 0.5);
        if (name == "atan") return formulas_.of(FormulaNode::Kind::kArcTangent, a);
        throw FormulaError(fmt::format("'{}': there is no function {}", text_, name));
    }
    unsigned char byte() const { return static_cast<unsigned char>(text_[at_]); }

    Formulas& formulas_;
    const std::string& text_;
    const std::map<std::string, double>& constants_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

double applied(FormulaNode::Kind kind, double a) {
    switch (kind) {
        case FormulaNode::Kind::kSine:
            return std::sin(a);
        case FormulaNode::Kind::kCosine:
            return std::cos(a);
        case FormulaNode::Kind::kExponential:
            return std::exp(a);
        case FormulaNode::Kind::kLogarithm:
            return std::log(a);
        case FormulaNode::Kind::kInverse:
            return 1 / a;
        case FormulaNode::Kind::kInverseRoot:
            return 1 / std::sqrt(a);
        default:
            return std::atan(a);
    }
}

}  // namespace

const char* name_of(FormulaNode::Kind kind) {
    constexpr const char* kNames[] = {"number", "t",   "sum",     "product", "sin", "cos",
                                      "exp",    "log", "inverse", "root",    "atan"};
    return kNames[static_cast<int>(kind)];
}

std::vector<std::pair<int, int>> Formulas::parts(int of_node) const {
    const FormulaNode& node = at(of_node);
    if (node.kind == Kind::kProduct && is_number(node.a)) return {{node.a, node.b}};
    if (node.kind != Kind::kSum) return {{-1, of_node}};
    std::vector<std::pair<int, int>> all = parts(node.a);
    for (const auto& part : parts(node.b)) all.push_back(part);
    return all;
}

int Formulas::read(const std::string& text, const std::map<std::string, double>& constants) {
    return FormulaReader(*this, text, constants).whole();
}

int Formulas::node(const FormulaNode& of) {
    const auto [known, fresh] = known_.try_emplace({of.kind, of.number, of.a, of.b}, size());
    if (fresh) nodes_.push_back(of);
    if (size() > kMostNodes) throw FormulaError("a formula of too many parts");
    return known->second;
}

int Formulas::number(double value) {
    if (!std::isfinite(value)) throw FormulaError("a number of it is not finite");
    return node({Kind::kNumber, value == 0 ? 0.0 : value, -1, -1});
}

int Formulas::sum(int a, int b) {
    if (is_number(a)) std::swap(a, b);
    if (is_number(a)) return number(at(a).number + at(b).number);
    if (is_number(b) && at(b).number == 0) return a;
    if (a > b && !is_number(b)) std::swap(a, b);
    return node({Kind::kSum, 0, a, b});
}

int Formulas::product(int a, int b) {
    if (is_number(b)) std::swap(a, b);
    if (is_number(a)) {
        const double factor = at(a).number;
        if (is_number(b)) return number(factor * at(b).number);
        if (factor == 0) return number(0);
        if (factor == 1) return b;
        if (at(b).kind == Kind::kProduct && is_number(at(b).a)) {
            return product(number(factor * at(at(b).a).number), at(b).b);
        }
        if (at(b).kind == Kind::kSum) {
            const FormulaNode of = at(b);
            return sum(product(a, of.a), product(a, of.b));
        }
        return node({Kind::kProduct, 0, a, b});
    }
    // A number in front of a product goes to its front.
    for (const int of : {a, b}) {
        if (at(of).kind != Kind::kProduct || !is_number(at(of).a)) continue;
        return product(at(of).a, product(at(of).b, of == a ? b : a));
    }
    if (a > b) std::swap(a, b);
    return node({Kind::kProduct, 0, a, b});
}

int Formulas::of(Kind function, int a) {
    if (is_number(a)) return number(applied(function, at(a).number));
    return node({function, 0, a, -1});
}

int Formulas::power(int a, double exponent) {
    if (is_number(a)) return number(std::pow(at(a).number, exponent));
    if (exponent == 0.5) return product(a, of(Kind::kInverseRoot, a));
    if (exponent == -0.5) return of(Kind::kInverseRoot, a);
    const double whole = std::abs(exponent);
    if (whole != std::floor(whole)) {
        return of(Kind::kExponential, product(number(exponent), of(Kind::kLogarithm, a)));
    }
    if (whole > kLargestPower) throw FormulaError(fmt::format("a power above {}", kLargestPower));
    const int base = exponent < 0 ? of(Kind::kInverse, a) : a;
    int made = number(1);
    for (int n = 0; n < static_cast<int>(whole); ++n) made = product(made, base);
    return made;
}

int Formulas::derivative(int of_node) {
    const auto known = derivatives_.find(of_node);
    if (known != derivatives_.end()) return known->second;
    const FormulaNode node = at(of_node);
    int made = 0;
    if (node.kind == Kind::kNumber || node.kind == Kind::kParameter) {
        made = number(node.kind == Kind::kParameter ? 1 : 0);
    } else if (node.kind == Kind::kSum) {
        made = sum(derivative(node.a), derivative(node.b));
    } else if (node.kind == Kind::kProduct) {
        made = sum(product(derivative(node.a), node.b), product(node.a, derivative(node.b)));
    } else {
        int outer = of_node;  // of the exponential
        if (node.kind == Kind::kSine) outer = of(Kind::kCosine, node.a);
        if (node.kind == Kind::kCosine) outer = product(number(-1), of(Kind::kSine, node.a));
        if (node.kind == Kind::kLogarithm) outer = of(Kind::kInverse, node.a);
        if (node.kind == Kind::kInverse) outer = product(number(-1), product(of_node, of_node));
        if (node.kind == Kind::kInverseRoot) {
            outer = product(number(-0.5), product(of_node, product(of_node, of_node)));
        }
        if (node.kind == Kind::kArcTangent) {
            outer = of(Kind::kInverse, sum(number(1), product(node.a, node.a)));
        }
        made = product(outer, derivative(node.a));
    }
    derivatives_[of_node] = made;
    return made;
}

std::vector<double> Formulas::values(double t) const {
    std::vector<double> values;
    values.reserve(nodes_.size());
    for (const FormulaNode& node : nodes_) {
        const auto operand = [&](int n) { return values[static_cast<std::size_t>(n)]; };
        values.push_back(node.kind == Kind::kNumber      ? node.number
                         : node.kind == Kind::kParameter ? t
                         : node.kind == Kind::kSum       ? operand(node.a) + operand(node.b)
                         : node.kind == Kind::kProduct   ? operand(node.a) * operand(node.b)
                                                         : applied(node.kind, operand(node.a)));
    }
    return values;
}

double Formulas::value(int of, double t) const { return values(t)[static_cast<std::size_t>(of)]; }

}  // namespace curvecore::ref
