// SPDX-License-Identifier: Apache-2.0
#include "ref/curves/declarations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "ref/curves/line_reader.hpp"

namespace curvecore::ref {
namespace {

const std::set<std::string> kFields{"theta", "tangent", "normal", "advance"};

int whole(const std::string& text, const Place& place) {
    try {
        std::size_t used = 0;
        const int value = std::stoi(text, &used);
        if (used == text.size() && value >= -16 && value <= 16) {
            return value;
        }
    } catch (const std::logic_error&) {
    }
    place.refuse("'" + text + "' is no fraction: -16 .. 16 from CoefBits");
}
double real(const std::string& text, const Place& place) {
    try {
        std::size_t used = 0;
        const double value = std::stod(text, &used);
        if (used == text.size()) {
            return value;
        }
    } catch (const std::logic_error&) {
    }
    place.refuse("'" + text + "' is no number");
}

}  // namespace

void Declarations::line(const std::string& key, const std::vector<std::string>& items,
                        const Place& place) {
    const auto pairs = [&](std::size_t each) {
        if (items.empty() || items.size() % each != 0) {
            place.refuse(key + ": expected " + std::to_string(each) + " items each");
        }
    };
    if (key == "curve") {
        pairs(1);
        if (!table_.name.empty()) place.refuse("a table has one `curve`");
        table_.name = items[0];
        const bool named = std::isalpha(static_cast<unsigned char>(items[0][0])) != 0 &&
                           std::all_of(items[0].begin(), items[0].end(), [](unsigned char c) {
                               return std::isalnum(c) != 0 || c == '_';
                           });
        if (!named) place.refuse("the name of a curve is letters and digits");
        for (std::size_t n = 1; n < items.size(); ++n) {
            table_.title += (n > 1 ? " " : "") + items[n];
        }
    } else if (key == "word" || key == "start") {
        pairs(2);
        for (std::size_t n = 0; n < items.size(); n += 2) {
            declare(items[n], whole(items[n + 1], place), key == "start", place);
        }
    } else if (key == "const") {
        if (items.size() != 3) {
            place.refuse("const: expected a name, a fraction and a value");
        }
        CurveRow& constant = row(items[0]);
        if (constant.of_axis) place.refuse(items[0] + " is a row of each axis: no constant");
        if (!constant.start) {
            constant.fraction = whole(items[1], place);
        }
        constant.value = real(items[2], place);
    } else if (key == "bus") {
        pairs(2);
        for (std::size_t n = 0; n < items.size(); n += 2) {
            on_bus(items[n], items[n + 1], place);
        }
    } else if (key == "power") {
        pairs(2);
        for (std::size_t n = 0; n < items.size(); n += 2) {
            known(items[n], place);
            table_.said_powers[items[n]] = whole(items[n + 1], place);
        }
    } else if (key == "output") {
        pairs(1);
        if (!table_.output.empty()) place.refuse("a table has one `output`");
        table_.output = items[0];
    } else if (key == "polished") {
        pairs(1);
        for (const std::string& name : items) {
            known(name, place).polished = true;
        }
    } else if (key == "guard") {
        pairs(1);
        for (const std::string& name : items) {
            table_.guarded.insert(name);
        }
    } else if (key == "alias") {
        pairs(2);
        const RowOperand rate = read_row_operand(items[0], place);
        const RowOperand other = read_row_operand(items[1], place);
        CurveRow& made = row(rate.row);
        made = known(other.row, place);
        in_order_.emplace_back(other.row, place.line);
        made.word = made.start = false;
        made.value.reset();
        made.series = true;
        made.of_axis = other.of_axis;
        made.same_as = other;
    } else {
        place.refuse("'" + key + "' begins no line of a table" +
                     (table_.sections.empty() ? " before its first section" : ""));
    }
}

/// Lets a row come from a place of the bus, which no other row has.
void Declarations::on_bus(const std::string& field, const std::string& name, const Place& place) {
    const bool axes = known(name, place).of_axis;
    const bool further = field.rfind("further.", 0) == 0;
    if (further) {
        const std::string number = field.substr(std::string("further.").size());
        const bool digits = !number.empty() && number.size() < 3 &&
                            (number[0] != '0' || number.size() == 1) &&
                            number.find_first_not_of("0123456789") == std::string::npos;
        if (!digits || std::stoi(number) + (axes ? 3 : 1) > kMostFurther) {
            place.refuse(field + ": further words are 0 .. " + std::to_string(kMostFurther - 1));
        }
    } else if (kFields.count(field) == 0) {
        place.refuse("the bus has no field " + field);
    } else if (axes != (field != "theta")) {
        place.refuse(name + (axes ? " is a row of each axis: theta is one word"
                                  : " is no row of an axis: it comes from theta, or from "
                                    "further.0, further.1 .."));
    }
    for (const auto& [other, row] : table_.bus) {
        if (row == name) place.refuse(fmt::format("{} comes from {} already", name, other));
        const BusPlace of = bus_place(other);
        const int first = further ? bus_place(field).number : 0;
        const bool both = further && of.further() &&
                          first < of.number + (table_.rows.at(row).of_axis ? 3 : 1) &&
                          of.number < first + (axes ? 3 : 1);
        if (other == field || both) place.refuse(fmt::format("{} has {} already", field, row));
    }
    table_.bus[field] = name;
}

void Declarations::declare(std::string name, int fraction, bool start, const Place& place) {
    const bool three = name.size() > 3 && name.substr(name.size() - 3) == "[3]";
    if (three) {
        name.resize(name.size() - 3);
    }
    if (table_.rows.count(name) != 0) {
        place.refuse(name + " is there twice");
    }
    CurveRow& made = row(name);
    made.fraction = fraction;
    made.of_axis = three;
    made.word = !start;
    made.start = made.series = start;
    made.line = place.line;
}

CurveRow& Declarations::known(const std::string& name, const Place& place, bool in_sample) {
    const auto found = table_.rows.find(name);
    if (found == table_.rows.end()) {
        place.refuse("no line before makes " + name);
    }
    if (name == "tau" && !in_sample) {
        place.refuse("tau is a place in the step, in `sample` alone");
    }
    return found->second;
}

}  // namespace curvecore::ref
