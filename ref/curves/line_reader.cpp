// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/line_reader.hpp"

#include <cctype>

namespace curvecore::ref {
namespace {

using Function = TableLine::Function;
using Meeting = TableTerm::Meeting;

/// Text, read from left to right.
class Scanner {
  public:
    Scanner(const std::string& text, const Place& place) : text_(&text), place_(&place) {}

    bool at_end() {
        skip();
        return at_ == text_->size();
    }
    bool take(const std::string& token) {
        skip();
        if (text_->compare(at_, token.size(), token) != 0) {
            return false;
        }
        at_ += token.size();
        return true;
    }
    void expect(const std::string& token, const std::string& what) {
        if (!take(token)) {
            refuse("expected " + what);
        }
    }
    bool at_digit() {
        skip();
        return at_ < text_->size() && std::isdigit(static_cast<unsigned char>((*text_)[at_])) != 0;
    }
    int number() {
        if (!at_digit()) {
            refuse("expected a number");
        }
        int value = 0;
        while (at_ < text_->size() &&
               std::isdigit(static_cast<unsigned char>((*text_)[at_])) != 0) {
            value = 10 * value + ((*text_)[at_++] - '0');
            if (value > 1 << 20) {
                refuse("a number above 2^20");
            }
        }
        return value;
    }
    std::string name() {
        skip();
        const std::size_t first = at_;
        while (at_ < text_->size() &&
               (std::isalnum(static_cast<unsigned char>((*text_)[at_])) != 0 ||
                (*text_)[at_] == '_')) {
            ++at_;
        }
        if (first == at_ || std::isdigit(static_cast<unsigned char>((*text_)[first])) != 0) {
            refuse("expected the name of a row");
        }
        return text_->substr(first, at_ - first);
    }
    [[noreturn]] void refuse(const std::string& reason) {
        skip();
        place_->refuse(reason + (at_ == text_->size() ? ", not the end of the line"
                                                      : ", not '" + text_->substr(at_) + "'"));
    }

  private:
    void skip() {
        while (at_ < text_->size() && (*text_)[at_] == ' ') {
            ++at_;
        }
    }

    const std::string* text_;
    const Place* place_;
    std::size_t at_ = 0;
};

RowOperand operand(Scanner& scan, bool* all_axes = nullptr) {
    RowOperand row;
    row.row = scan.name();
    if (scan.take("[k]")) {
        row.of_axis = true;
    } else if (all_axes != nullptr && scan.take("[*]")) {
        row.of_axis = *all_axes = true;
    }
    while (scan.take("'")) {
        ++row.primes;
    }
    if (scan.take(".")) {
        row.order = scan.number();
    }
    return row;
}

/// Reads `3` or `1/2` before a term, or the whole of a constant one.
void factor(Scanner& scan, TableTerm& term) {
    if (!scan.at_digit()) {
        return;
    }
    const int number = scan.number();
    term.number *= number;
    if (scan.take("/")) {
        const int below = scan.number();
        if (below == 0 || (below & (below - 1)) != 0) {
            scan.refuse("a factor is a number over a power of two");
        }
        for (int n = below; n > 1; n /= 2) {
            ++term.halvings;
        }
    }
    Scanner ahead = scan;
    if (ahead.at_end() || ahead.take("+") || ahead.take("-")) {
        term.meeting = Meeting::kConstant;
    } else if (number == 0) {
        scan.refuse("a factor is not 0");
    }
}

/// Reads sum(a), horner(a), odd(a, x) or even(a, x); false if it is none of them.
bool function(Scanner& scan, TableLine& line) {
    const std::pair<const char*, Function> kinds[] = {{"sum(", Function::kSum},
                                                      {"horner(", Function::kHorner},
                                                      {"odd(", Function::kOdd},
                                                      {"even(", Function::kEven}};
    for (const auto& [name, kind] : kinds) {
        if (!scan.take(name)) {
            continue;
        }
        if (line.function != Function::kTerms) {
            scan.refuse("a line has one function");
        }
        line.function = kind;
        line.series = operand(scan);
        if (kind == Function::kOdd || kind == Function::kEven) {
            scan.expect(",", "',' and a variable");
            line.variable = scan.name();
        }
        scan.expect(")", "')'");
        return true;
    }
    return false;
}

void row_term(Scanner& scan, TableTerm& term) {
    term.a = operand(scan, &term.all_axes);
    if (scan.take("/i")) {
        term.meeting = Meeting::kOverOrder;
    } else if (scan.take("*")) {
        term.meeting = Meeting::kProduct;
        term.b = operand(scan, &term.all_axes);
    } else if (scan.take("@")) {
        term.meeting = Meeting::kOrderByOrder;
        term.b = operand(scan);
    }
}

void terms(Scanner& scan, TableLine& line) {
    for (bool minus = scan.take("-");; minus = scan.take("-")) {
        if (!minus && (!line.terms.empty() || line.function != Function::kTerms)) {
            scan.expect("+", "+ or -");
        }
        if (minus || !function(scan, line)) {
            TableTerm term;
            term.number = minus ? -1 : 1;
            factor(scan, term);
            if (term.meeting != Meeting::kConstant) {
                row_term(scan, term);
            }
            line.terms.push_back(term);
        }
        if (scan.take(">>")) {
            line.down = scan.at_digit() ? scan.number() : 1;
            scan.expect("s", "s, the exponent of the steps of a segment");
        }
        if (scan.at_end()) {
            return;
        }
    }
}

}  // namespace

RowOperand read_row_operand(const std::string& text, const Place& place) {
    Scanner scan(text, place);
    RowOperand row = operand(scan);
    if (!scan.at_end()) {
        scan.refuse("expected a row");
    }
    return row;
}

TableLine read_table_line(const std::string& text, const Place& place) {
    Scanner scan(text, place);
    TableLine line;
    line.text = text;
    line.number = place.line;
    const RowOperand head = operand(scan);
    if (head.primes != 0) {
        scan.refuse("a line makes an order of its own");
    }
    line.row = head.row;
    line.of_axis = head.of_axis;
    line.order = head.order;
    scan.expect(":", "':' and the fraction bits of the row");
    const bool minus = scan.take("-");
    if (!minus) {
        scan.take("+");
    }
    line.fraction = scan.number() * (minus ? -1 : 1);
    line.adds_axes = scan.take("+=");
    if (!line.adds_axes) {
        scan.expect("=", "'='");
    }
    terms(scan, line);
    return line;
}

}  // namespace curvecore::ref
