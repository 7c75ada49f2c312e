// SPDX-License-Identifier: Apache-2.0
#include "ref/bound/table_bound.hpp"

#include <limits>
#include <set>

#include "ref/bound/error_tape.hpp"
#include "ref/curves/table_machine.hpp"
#include "ref/format/path_words.hpp"
#include "ref/numeric/angles.hpp"

namespace curvecore::ref {

Eigen::MatrixXd ErrorTape::sweep(const std::vector<int>& outputs) const {
    // By rows: a node's partials stand together.
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> partials =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(nodes_.size()),
                              static_cast<Eigen::Index>(outputs.size()));
    for (std::size_t n = 0; n < outputs.size(); ++n) {
        if (outputs[n] != kNone) partials(outputs[n], static_cast<Eigen::Index>(n)) = 1;
    }
    for (Eigen::Index n = partials.rows(); n-- > 0;) {
        const Node& node = nodes_[static_cast<std::size_t>(n)];
        if (node.a != kNone) partials.row(node.a) += node.by_a * partials.row(n);
        if (node.b != kNone) partials.row(node.b) += node.by_b * partials.row(n);
    }
    return partials;
}

double TableError::worst() const {
    double most = 0;
    for (const auto& step : errors) {
        for (const double error : step) most = error <= most ? most : error;  // not a number stays
    }
    return most;
}

namespace {

constexpr int kOrdersMore = 8;
constexpr int kHalfOfThem = 4;
constexpr int kPlacesPerDegree = 4;
constexpr double kNothing = 1e-15;  // of a series, of the size of a step

/// Degree of each row of `sample` as a polynomial in tau.
int degree_of_samples(const CurveTable& table, int order, bool by_lines) {
    if (!by_lines) return order;
    std::map<std::string, int> degrees{{"tau", 1}};
    using Function = TableLine::Function;
    for (const TableLine& line : table.section("sample")) {
        int most = 0;
        for (const TableTerm& term : line.terms) {
            most = std::max(most, degrees[term.a.row] + degrees[term.b.row]);
        }
        if (line.function == Function::kHorner) most = std::max(most, order);
        if (line.function == Function::kOdd || line.function == Function::kEven) {
            most = std::max(most, order / 2 * degrees[line.variable]);
        }
        degrees[line.row] = most;
    }
    return std::max(1, degrees["d"]);
}

/// Places of a step from which a polynomial of so many degrees is known everywhere in it: it is at
/// most `factor` times the largest of its values there.
///
/// Source: H. Ehlich, K. Zeller, Schwankung von Polynomen zwischen Gitterpunkten, Mathematische
/// Zeitschrift 86, 1964.
struct Places {
    explicit Places(int degree) {
        const int count = kPlacesPerDegree * degree;
        for (int n = 0; n < count; ++n)
            at.push_back((1 + std::cos((2 * n + 1) * kTurnRadians / (4 * count))) / 2);
        factor = 1 / std::cos(degree * kTurnRadians / (4 * count));
    }
    std::vector<double> at;
    double factor = 1;
};

/// A row's axis, or that of a position, which is carried from step to step.
struct Carried {
    enum class Kind { kRow, kStart, kOrigin };

    Kind kind = Kind::kRow;
    int axis = 0;
    std::string row;
};

class TableWalk {
  public:
    TableWalk(const CurveTable& table, const CoreParameters& core, const TableSegment& segment)
        : table_(table),
          core_(core),
          segment_(segment),
          by_lines_(table.samples_by_lines(core.polynomial())),
          places_(degree_of_samples(table, core.order, by_lines_)),
          places_of_rest_(degree_of_samples(table, core.order + kOrdersMore, by_lines_)),
          short_(table, core.order, core.polynomial()),
          half_(table, core.order + kHalfOfThem, core.polynomial()),
          whole_(table, core.order + kOrdersMore, core.polynomial()),
          words_(table, core.order, core.polynomial(), {core.coef_bits, core.guard_bits, &tape_}) {
        for (const auto& [name, row] : table.rows) {
            for (int axis = 0; row.start && axis < (row.of_axis ? 3 : 1); ++axis) {
                carried_.push_back({Carried::Kind::kRow, axis, name});
            }
        }
        for (const auto kind : {Carried::Kind::kStart, Carried::Kind::kOrigin}) {
            for (int axis = 0; axis < 3; ++axis) carried_.push_back({kind, axis, ""});
        }
        for (const auto& [row, values] : segment.values) {
            for (int axis = 0; axis < 3; ++axis) {
                whole_.set(row, values[axis], axis);
                half_.set(row, values[axis], axis);
                const double word = nearest_word(values[axis], bits(row));
                short_.set(row, word, axis);
                words_.set(row, {word}, axis);
            }
        }
        whole_.load({0, 0, 0}, segment.k, segment.lambda);
        half_.load({0, 0, 0}, segment.k, segment.lambda);
        short_.load({0, 0, 0}, segment.k, segment.lambda);
        words_.begin({}, segment.k, segment.lambda);
        // The start's position is a word, and the first step's.
        errors_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(carried_.size()), 3);
        const double half = std::ldexp(0.5, -core.guard_bits);
        errors_.bottomRows(3).diagonal().setConstant(half);
        errors_.middleRows(errors_.rows() - 6, 3).diagonal().setConstant(half);
    }

    TableError result() {
        for (int step = 0; step < segment_.steps; ++step) {
            if (step > 0) {
                whole_.step();
                half_.step();
                short_.step();
            }
            trace(step + 1 < segment_.steps ? 1 : segment_.last, step + 1 < segment_.steps);
            if (!shrinks()) result_.errors.back().fill(std::numeric_limits<double>::infinity());
        }
        for (const auto& [name, row] : table_.rows) {
            const double largest = words_.largest(name).value;
            result_.largest[name] = largest;
            if (largest >= row.range()) result_.beyond.push_back(name);
        }
        return std::move(result_);
    }

  private:
    int bits(const std::string& row) const {
        return core_.coef_bits + table_.rows.at(row).fraction;
    }

    const TracedNumber& carried(const Carried& of) const {
        if (of.kind == Carried::Kind::kRow) return words_.value(of.row, 0, of.axis);
        return of.kind == Carried::Kind::kStart ? words_.start()[of.axis]
                                                : words_.origin()[of.axis];
    }

    /// Draws a part of a step, its samples, and what it carries on.
    void trace(double part, bool goes_on) {
        begin_tape();
        words_.open();
        std::vector<int> to;
        const bool cuts = segment_.k + kPathFrac > core_.coef_bits - 1;
        const double tau_cut = cuts ? std::ldexp(1.0, 1 - core_.coef_bits) : 0;
        for (const double place : places_.at) {
            const int tau = tape_.add(tau_cut);
            for (const TracedNumber& at :
                 words_.sample({place * part, tau_cut, core_.coef_bits - 1, &tape_, tau})) {
                to.push_back(at.node);
            }
        }
        if (goes_on) words_.leave();
        for (const Carried& of : carried_) to.push_back(carried(of).node);

        const Eigen::MatrixXd partials = tape_.sweep(to);
        const auto inputs = static_cast<Eigen::Index>(carried_.size());
        const Eigen::MatrixXd before = partials.topRows(inputs).transpose() * errors_;
        Eigen::VectorXd sums = before.cwiseAbs().rowwise().sum();
        std::vector<Eigen::Index> going_on;  // nodes whose errors do
        for (Eigen::Index node = inputs; node < partials.rows(); ++node) {
            const double own = tape_.own(static_cast<std::size_t>(node));
            if (own == 0) continue;
            sums += own * partials.row(node).cwiseAbs().transpose();
            if (!partials.row(node).tail(inputs).isZero(0)) going_on.push_back(node);
        }
        bound(part, sums.head(sums.size() - inputs));
        if (!goes_on) return;
        errors_.resize(inputs, before.cols() + static_cast<Eigen::Index>(going_on.size()));
        errors_.leftCols(before.cols()) = before.bottomRows(inputs);
        Eigen::Index column = before.cols();
        for (const Eigen::Index node : going_on) {
            const double own = tape_.own(static_cast<std::size_t>(node));
            errors_.col(column++) = own * partials.row(node).tail(inputs).transpose();
        }
    }

    /// Adds a step's bound: of the roundings at the places, and of the series' rest.
    void bound(double part, const Eigen::VectorXd& errors) {
        std::array<double, 3> rounding{};
        for (Eigen::Index at = 0; at < errors.size(); ++at) {
            double& most = rounding[static_cast<std::size_t>(at % 3)];
            most = std::max(most, errors(at));
        }
        std::array<double, 3> rest{};
        for (const double place : places_of_rest_.at) {
            const auto drawn = short_.sample(place * part);
            const auto half = half_.sample(place * part);
            const auto whole = whole_.sample(place * part);
            for (int axis = 0; axis < 3; ++axis) {
                const double sum =
                    std::abs(drawn[axis] - whole[axis]) + std::abs(half[axis] - whole[axis]);
                rest[axis] = sum <= rest[axis] ? rest[axis] : sum;
            }
        }
        std::array<double, 3> sum{};
        for (int axis = 0; axis < 3; ++axis) {
            sum[axis] = rounding[axis] * places_.factor + rest[axis] * places_of_rest_.factor;
        }
        result_.errors.push_back(sum);
    }

    /// Returns whether the last four orders of every series that is summed are at most half of
    /// those before, or nothing that a word could show.
    bool shrinks() const {
        const int last = core_.order + kOrdersMore;
        std::set<std::string> summed{table_.output};
        for (const char* section : {"next", "sample"}) {
            for (const TableLine& line : table_.section(section)) {
                if (line.function != TableLine::Function::kTerms) summed.insert(line.series.row);
            }
        }
        for (const std::string& name : summed) {
            for (int axis = 0; axis < (table_.rows.at(name).of_axis ? 3 : 1); ++axis) {
                double before = 0;
                double behind = 0;
                for (int n = 1; n <= kHalfOfThem; ++n) {
                    before += std::abs(whole_.value(name, last - 2 * kHalfOfThem + n, axis));
                    behind += std::abs(whole_.value(name, last - kHalfOfThem + n, axis));
                }
                if (behind > before / 2 && behind > kNothing) return false;
            }
        }
        return true;
    }

    /// Begins the tape of a step with what is carried into it.
    void begin_tape() {
        tape_.clear();
        auto start = words_.start();
        auto origin = words_.origin();
        const Eigen::VectorXd errors = errors_.cwiseAbs().rowwise().sum();
        for (const Carried& of : carried_) {
            const int node = tape_.add(0);
            const double error = errors(node);
            const bool of_row = of.kind == Carried::Kind::kRow;
            const int fraction = of_row ? bits(of.row) : core_.guard_bits;
            const TracedNumber in{carried(of).value, error, fraction, &tape_, node};
            if (of_row) words_.set(of.row, in, of.axis);
            if (of.kind == Carried::Kind::kStart) start[of.axis] = in;
            if (of.kind == Carried::Kind::kOrigin) origin[of.axis] = in;
        }
        words_.set_positions(start, origin);
    }

    const CurveTable& table_;
    const CoreParameters& core_;
    const TableSegment& segment_;
    bool by_lines_;  // samples
    Places places_;
    Places places_of_rest_;
    ErrorTape tape_;
    TableMachine<double> short_;  // the core's orders, no rounding
    TableMachine<double> half_;   // more orders, from exact values
    TableMachine<double> whole_;  // and more
    TableMachine<TracedNumber, TracedWords> words_;
    std::vector<Carried> carried_;
    Eigen::MatrixXd errors_;  // of what is carried, by independent errors
    TableError result_;
};

}  // namespace

TableError table_error(const CurveTable& table, const CoreParameters& core,
                       const TableSegment& segment) {
    TableError beyond;
    for (const auto& [row, values] : segment.values) {
        double& largest = beyond.largest[row];
        for (const double value : values) largest = std::max(largest, std::abs(value));
        if (largest >= table.rows.at(row).range()) {
            beyond.beyond.push_back(row);
        }
    }
    return beyond.beyond.empty() ? TableWalk(table, core, segment).result() : beyond;
}

}  // namespace curvecore::ref
