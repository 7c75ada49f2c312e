// SPDX-License-Identifier: Apache-2.0
// Formulas of a parameter t: read from text, differentiated, evaluated. Parts that are the same
// are one node.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace curvecore::ref {

/// A node; operands stand before it.
struct FormulaNode {
    enum class Kind {
        kNumber,
        kParameter,
        kSum,
        kProduct,
        kSine,
        kCosine,
        kExponential,
        kLogarithm,
        kInverse,      // 1 / a
        kInverseRoot,  // 1 / sqrt(a)
        kArcTangent
    };

    Kind kind = Kind::kNumber;
    double number = 0;
    int a = -1;
    int b = -1;
};

/// A word for a kind, as rows are called.
const char* name_of(FormulaNode::Kind kind);

/// Reason why a text is no formula.
struct FormulaError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

class Formulas {
  public:
    using Kind = FormulaNode::Kind;

    /// Reads numbers, t, pi, the constants, + - * / ^, ( ), sin cos tan sinh cosh tanh exp log sqrt
    /// atan; log is the natural one. Returns its node. @throws FormulaError
    int read(const std::string& text, const std::map<std::string, double>& constants);

    int number(double value);
    int parameter() { return node({Kind::kParameter, 0, -1, -1}); }
    int sum(int a, int b);
    int product(int a, int b);
    int of(Kind function, int a);
    int power(int a, double exponent);
    /// Returns the node of the derivative by t.
    int derivative(int of);

    /// A sum's nodes, each with the number before it, or -1; of another node itself.
    std::vector<std::pair<int, int>> parts(int of) const;

    double value(int of, double t) const;
    /// Values of all nodes.
    std::vector<double> values(double t) const;
    const FormulaNode& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
    int size() const { return static_cast<int>(nodes_.size()); }
    bool is_number(int node) const { return at(node).kind == Kind::kNumber; }

  private:
    int node(const FormulaNode& of);

    std::vector<FormulaNode> nodes_;
    std::map<std::tuple<Kind, double, int, int>, int> known_;
    std::map<int, int> derivatives_;
};

}  // namespace curvecore::ref
