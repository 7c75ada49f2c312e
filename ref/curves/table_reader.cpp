// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "ref/curves/declarations.hpp"
#include "ref/curves/line_reader.hpp"
#include "ref/curves/table_check.hpp"
#include "ref/text/text_file.hpp"

namespace curvecore::ref {
namespace {

const std::vector<std::string> kSections{"load", "anchor", "order", "next", "carry", "sample"};
constexpr int kMostOrder = 12;

class Reader {
  public:
    explicit Reader(CurveTable& table) : table_(table), declarations_(table) {
        row("tau").fraction = -1;
    }

    void line(const std::string& text, const Place& place) {
        std::istringstream words(text);
        std::string key;
        words >> key;
        const auto section = std::find(kSections.begin(), kSections.end(), key);
        if (section != kSections.end() && text == key) {
            if (!section_.empty() &&
                section < std::find(kSections.begin(), kSections.end(), section_)) {
                place.refuse("`" + key + "` stands before `" + section_ + "`");
            }
            section_ = key;
            table_.sections[key];
            return;
        }
        if (text.find(':') != std::string::npos && !section_.empty()) {
            add_line(read_table_line(text, place), place);
            return;
        }
        std::vector<std::string> items;
        for (std::string item; words >> item;) {
            items.push_back(item);
        }
        declarations_.line(key, items, place);
    }

    void end(const Place& place) {
        if (table_.name.empty()) {
            place.refuse("no line `curve NAME`");
        }
        if (!table_.network() && (table_.output.empty() || table_.rows.count(table_.output) == 0)) {
            place.refuse("no line `output NAME` of a row that a line makes");
        }
        for (const auto& [name, line] : declarations_.in_order()) {
            if (!row(name).series) Place{table_.file, line}.refuse(name + " has no orders");
        }
        table_.network() ? check_network(table_) : place_in_step(place);
        check_places(table_);
        check_carry(table_, place);
        check_guards(table_, place);
        check_orders(table_);
        int words = 0;  // further ones that have a row
        for (const auto& [field, row] : table_.bus) {
            if (bus_place(field).further()) words += table_.rows.at(row).of_axis ? 3 : 1;
        }
        if (words != table_.further_words()) {
            place.refuse("further words without a row before the last one");
        }
        for (const auto& [name, row] : table_.rows) {
            const bool given = row.word || (row.start && !row.value);
            if (given && !table_.network() && !on_bus(name)) {
                place.refuse(name + " comes from no word of the bus");
            }
        }
    }

  private:
    /// d[k], which samples need, is the output's polynomial where no line makes it.
    void place_in_step(const Place& place) {
        if (table_.section("sample").empty()) {
            CurveRow& made = row("d");
            made.fraction = row(table_.output).fraction;
            made.of_axis = true;
        } else if (table_.rows.count("d") == 0 || !row("d").of_axis) {
            place.refuse("`sample` makes no d[k], the place in the step");
        }
    }

    CurveRow& row(const std::string& name) { return declarations_.row(name); }
    CurveRow& known(const std::string& name, const Place& place) {
        return declarations_.known(name, place, section_ == "sample");
    }

    void reads(const RowOperand& read, const TableLine& line, const Place& place) {
        const CurveRow& of = known(read.row, place);
        if (of.of_axis != read.of_axis) {
            place.refuse(read.row + (of.of_axis ? " is a row of each axis: " + read.row + "[k]"
                                                : " is no row of an axis"));
        }
        if (read.of_axis && !line.of_axis && !line.adds_axes) {
            place.refuse(line.row + " is no row of an axis, " + read.row + "[k] is");
        }
        if (read.order.value_or(0) > kMostOrder) {
            place.refuse("an order above " + std::to_string(kMostOrder));
        }
        if (read.primes != 0 || read.order) {
            declarations_.reads_orders(read.row, place.line);
        }
        if (section_ == "load" && (of.start || of.series)) {
            place.refuse(read.row + " is no word of the segment: `load` is made once");
        }
    }

    void add_line(TableLine line, const Place& place) {
        for (const TableTerm& term : line.terms) {
            if (term.meeting == TableTerm::Meeting::kConstant) {
                continue;
            }
            TableLine sum = line;
            sum.adds_axes |= term.all_axes;
            reads(term.a, sum, place);
            if (!term.b.row.empty()) {
                reads(term.b, sum, place);
            }
            if (term.meeting == TableTerm::Meeting::kOverOrder && section_ != "order") {
                place.refuse("/i has a meaning in `order` alone");
            }
        }
        if (line.function != TableLine::Function::kTerms) {
            if (section_ != "next" && section_ != "carry" && section_ != "sample") {
                place.refuse("the orders are whole in `next`, `carry` and `sample` alone");
            }
            if (line.series.primes > 0 || line.series.order) {
                place.refuse("a function takes all orders of its row");
            }
            reads(line.series, line, place);
            if (!known(line.series.row, place).series) {
                place.refuse(line.series.row + " is no series");
            }
            if (line.function == TableLine::Function::kHorner && section_ != "sample") {
                place.refuse("horner(..) is a polynomial in tau, in `sample` alone");
            }
            if (!line.variable.empty()) {
                known(line.variable, place);
            }
        }
        if (line.function != TableLine::Function::kTerms &&
            line.function != TableLine::Function::kSum && !line.terms.empty()) {
            place.refuse("a polynomial takes no other term");
        }
        if (line.adds_axes && line.of_axis) {
            place.refuse("+= adds the axes to a row that has none");
        }
        if (line.order && section_ != "anchor") {
            place.refuse("an order is named in `anchor` alone");
        }
        for (const TableLine& other : table_.section("order")) {
            if (section_ == "order" && other.row == line.row) {
                place.refuse("line " + std::to_string(other.number) + " makes the orders of " +
                             line.row + " already");
            }
        }
        if (line.order.value_or(0) > kMostOrder) {
            place.refuse("an order above " + std::to_string(kMostOrder));
        }
        if (line.down != 0 && (line.terms.size() != 1 || !line.terms[0].b.row.empty())) {
            place.refuse(">> s takes one row");
        }
        const bool first = table_.rows.count(line.row) == 0;
        CurveRow& made = row(line.row);
        if (first) {
            made.fraction = line.fraction;
            made.of_axis = line.of_axis;
            made.line = place.line;
        } else if (section_ == "next" && !made.start && made_before(line.row)) {
            place.refuse(line.row + " is made in each step, and carried: it needs `start`");
        }
        if (made.word || made.same_as || (made.value && !made.start)) {
            place.refuse(line.row + " is fixed: no line makes it");
        }
        if (section_ != "load" && makes(table_, "load", line.row)) {
            place.refuse(line.row + " is made in `load`, once for its segment");
        }
        if (made.fraction != line.fraction) {
            place.refuse(line.row + " has a fraction of " + std::to_string(made.fraction) +
                         " already");
        }
        if (made.of_axis != line.of_axis) {
            place.refuse(line.row +
                         (made.of_axis ? " is a row of each axis" : " is no row of an axis"));
        }
        made.series |= section_ == "order" || line.order.has_value();
        table_.sections[section_].push_back(std::move(line));
    }

    /// Returns whether a section before `next` makes a row.
    bool made_before(const std::string& row) const {
        return makes(table_, "load", row) || makes(table_, "anchor", row) ||
               makes(table_, "order", row);
    }
    bool on_bus(const std::string& name) const {
        for (const auto& [field, of] : table_.bus) {
            if (of == name) {
                return true;
            }
        }
        return false;
    }

    CurveTable& table_;
    Declarations declarations_;
    std::string section_;
};

}  // namespace

CurveTable read_curve_text(const std::string& file, const std::string& text) {
    CurveTable table = read_network_text(file, text);
    if (table.network()) Place{file, 1}.refuse("a network alone: it has no `output` to draw");
    return table;
}

CurveTable read_network_text(const std::string& file, const std::string& text) {
    CurveTable table;
    table.file = file;
    Reader reader(table);
    std::istringstream stream(text);
    TextLines lines(stream);
    while (const auto next = lines.next()) {
        std::string line(next->substr(0, next->find('#')));
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == std::string::npos) {
            continue;
        }
        line = line.substr(first, line.find_last_not_of(" \t") + 1 - first);
        for (char& c : line) {
            c = c == '\t' ? ' ' : c;
        }
        table.text += line + "\n";
        reader.line(line, {table.file, lines.number()});
    }
    reader.end({table.file, lines.number()});
    return table;
}

CurveTable read_curve_table(const std::string& file) {
    return read_curve_text(file, read_text_file(file));
}

}  // namespace curvecore::ref
