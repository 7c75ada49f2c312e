// SPDX-License-Identifier: Apache-2.0
#include "ref/gcode/blocks/value_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ref/numeric/angles.hpp"

namespace curvecore::ref {
namespace {

constexpr double kEqual = 1e-6;    // tolerance of EQ NE GE LE
constexpr int kMostFigures = 100;  // no number this short leaves a double's range
constexpr int kDeepest = 100;      // nested brackets and signs

bool is_digit(char c) { return c >= '0' && c <= '9'; }
double truth(bool value) { return value ? 1 : 0; }

struct Operator {
    std::string_view name;
    int binding;
    double (*apply)(double left, double right);
};

/// Operators, longer names before those that they begin with.
constexpr Operator kOperators[] = {
    {"**", 5, [](double a, double b) { return std::pow(a, b); }},
    {"*", 4, [](double a, double b) { return a * b; }},
    {"/", 4, [](double a, double b) { return a / b; }},
    {"MOD", 4,
     [](double a, double b) {
         const double rest = std::fmod(a, b);
         return rest < 0 ? rest + std::abs(b) : rest;
     }},
    {"+", 3, [](double a, double b) { return a + b; }},
    {"-", 3, [](double a, double b) { return a - b; }},
    {"EQ", 2, [](double a, double b) { return truth(std::abs(a - b) < kEqual); }},
    {"NE", 2, [](double a, double b) { return truth(std::abs(a - b) >= kEqual); }},
    {"GT", 2, [](double a, double b) { return truth(a > b); }},
    {"GE", 2, [](double a, double b) { return truth(a >= b || std::abs(a - b) < kEqual); }},
    {"LT", 2, [](double a, double b) { return truth(a < b); }},
    {"LE", 2, [](double a, double b) { return truth(a <= b || std::abs(a - b) < kEqual); }},
    {"AND", 1, [](double a, double b) { return truth(a != 0 && b != 0); }},
    {"OR", 1, [](double a, double b) { return truth(a != 0 || b != 0); }},
    {"XOR", 1, [](double a, double b) { return truth((a != 0) != (b != 0)); }},
};

struct Function {
    std::string_view name;
    double (*apply)(double);
};

constexpr Function kFunctions[] = {
    {"ABS", [](double x) { return std::abs(x); }},
    {"ACOS", [](double x) { return std::acos(x) / kRadiansPerDegree; }},
    {"ASIN", [](double x) { return std::asin(x) / kRadiansPerDegree; }},
    {"COS", [](double x) { return std::cos(x * kRadiansPerDegree); }},
    {"EXP", [](double x) { return std::exp(x); }},
    {"FIX", [](double x) { return std::floor(x); }},
    {"FUP", [](double x) { return std::ceil(x); }},
    {"LN", [](double x) { return std::log(x); }},
    {"ROUND", [](double x) { return std::trunc(x + std::copysign(0.5, x)); }},
    {"SIN", [](double x) { return std::sin(x * kRadiansPerDegree); }},
    {"SQRT", [](double x) { return std::sqrt(x); }},
    {"TAN", [](double x) { return std::tan(x * kRadiansPerDegree); }},
};

}  // namespace

std::optional<int> near_whole(double value, double tolerance) {
    const double whole = std::round(value);
    if (!(std::abs(value - whole) <= tolerance) || !(std::abs(whole) <= 1e9)) return std::nullopt;
    return static_cast<int>(whole);
}

bool ValueReader::take(std::string_view text) {
    if (words_.compare(at_, text.size(), text) != 0) return false;
    at_ += text.size();
    return true;
}

double ValueReader::finite(double value) const {
    if (!std::isfinite(value)) refuse("the expression's value is beyond any number");
    return value;
}

double ValueReader::value(const std::string& what) {
    if (++depth_ > kDeepest) {
        refuse(
            fmt::format("the expression nests deeper than {}: split it by parameters", kDeepest));
    }
    const double value = finite(unchecked_value(what));
    --depth_;
    return value;
}

double ValueReader::unchecked_value(const std::string& what) {
    const char c = peek();
    if (c == '[') return bracketed(what);
    if (c == '#') return parameter();
    const char next = at_ + 1 < words_.size() ? words_[at_ + 1] : '\0';
    if ((c == '+' || c == '-') &&
        (next == '[' || next == '#' || next == '+' || next == '-' || is_letter(next))) {
        // A letter may begin the next word: then this one lacks its number.
        skip();
        return c == '-' ? -value(what) : value(what);
    }
    if (is_letter(c)) return function(what);
    return plain_number(what);
}

double ValueReader::plain_number(const std::string& what) {
    const std::size_t begin = at_;
    const bool negative = peek() == '-';
    if (peek() == '+' || negative) ++at_;
    const std::size_t digits = at_;
    int points = 0;
    int figures = 0;
    for (; is_digit(peek()) || peek() == '.'; ++at_) {
        (peek() == '.' ? points : figures) += 1;
    }
    if (points > 1) {
        refuse(fmt::format("{}{} is not a number", what, words_.substr(begin, at_ - begin)));
    }
    if (figures == 0) refuse(fmt::format("{} without a number", what));
    double number = 0;
    std::from_chars(words_.data() + digits, words_.data() + at_, number, std::chars_format::fixed);
    if (figures > kMostFigures) refuse(fmt::format("the number of {} is out of range", what));
    return negative ? -number : number;
}

int ValueReader::whole_value(const std::string& what) {
    const double given = value(what);
    const std::optional<int> whole = near_whole(given);
    if (!whole) refuse(fmt::format("{} wants a whole number, not {:.10g}", what, given));
    return *whole;
}

std::string ValueReader::name() {
    const std::size_t end = words_.find('>', at_);
    if (end == std::string::npos) refuse("a name without its closing >");
    std::string name = words_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    if (name.empty()) refuse("<> without a name");
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return is_letter(c) ? static_cast<char>(c - 'A' + 'a') : c; });
    return name;
}

double ValueReader::parameter() {
    skip();
    try {
        if (peek() == '<') return parameters_.named(name());
        return parameters_.number(whole_value("#"));
    } catch (const ParameterError& error) {
        refuse(error.what());
    }
}

double ValueReader::exists() {
    if (!take("[#")) refuse("EXISTS wants a parameter in brackets, as in EXISTS[#<name>]");
    const bool there =
        peek() == '<' ? parameters_.exists(name()) : ProgramParameters::exists(whole_value("#"));
    if (!take("]")) refuse("EXISTS wants nothing but a parameter in its brackets");
    return truth(there);
}

double ValueReader::function(const std::string& what) {
    const std::size_t begin = at_;
    while (is_letter(peek())) ++at_;
    const std::string name = words_.substr(begin, at_ - begin);
    if (peek() != '[') {
        at_ = begin;
        refuse(fmt::format("{} without a number", what));
    }
    if (name == "EXISTS") return exists();
    const auto* const found =
        std::find_if(std::begin(kFunctions), std::end(kFunctions),
                     [&name](const Function& function) { return function.name == name; });
    if (found == std::end(kFunctions) && name != "ATAN") {
        refuse(
            fmt::format("there is no function {} (ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN "
                        "ROUND SIN SQRT TAN)",
                        name));
    }
    const double argument = bracketed(name);
    if (name == "ATAN") {
        if (!take("/") || peek() != '[') refuse("ATAN wants two values, as in ATAN[y]/[x]");
        return std::atan2(argument, bracketed(name)) / kRadiansPerDegree;
    }
    const double value = found->apply(argument);
    if (!std::isfinite(value)) refuse(fmt::format("{}[{:.10g}] has no value", name, argument));
    return value;
}

double ValueReader::bracketed(const std::string& what) {
    skip();
    if (at_end() || peek() == ']') refuse(fmt::format("{} with empty brackets", what));
    const double value = operation(1);
    if (!take("]")) {
        refuse(at_end() ? "an expression without its closing ]"
                        : fmt::format("'{}' where an operator or ] should be", peek()));
    }
    return value;
}

/// Reads values joined by operators that bind at least as strongly.
double ValueReader::operation(int least_binding) {
    double left = value("an expression");
    while (true) {
        const std::size_t begin = at_;
        const auto* const found =
            std::find_if(std::begin(kOperators), std::end(kOperators),
                         [this](const Operator& candidate) { return take(candidate.name); });
        if (found == std::end(kOperators) || found->binding < least_binding) {
            at_ = begin;
            return left;
        }
        const double right = operation(found->binding + 1);
        const bool divides = found->name == "/" || found->name == "MOD";
        if (divides && right == 0)
            refuse(fmt::format("{:.10g}{}0 has no value", left, found->name));
        const double value = found->apply(left, right);
        if (!std::isfinite(value)) {
            refuse(fmt::format("{:.10g}{}{:.10g} has no value", left, found->name, right));
        }
        left = value;
    }
}

}  // namespace curvecore::ref
