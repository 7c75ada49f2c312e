// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/assembler/source.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include "ref/text/text_file.hpp"

namespace curvecore::assembler {
namespace {

using engine::Op;

/// Words of a line, and its signs one by one.
std::vector<std::string> tokens(const std::string& line) {
    const auto named = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    std::vector<std::string> all;
    for (std::size_t n = 0; n < line.size();) {
        std::size_t last = n + 1;
        if (named(line[n])) {
            while (last < line.size() && named(line[last])) {
                ++last;
            }
            last += line.compare(last, 3, "[k]") == 0 ? 3 : 0;
        } else if (line.compare(n, 2, ">>") == 0 || line.compare(n, 2, "+=") == 0) {
            last = n + 2;
        }
        if (line[n] != ' ' && line[n] != '\t') {
            all.push_back(line.substr(n, last - n));
        }
        n = last;
    }
    return all;
}

class SourceReader {
  public:
    SourceReader(std::string file, Assembly& assembly) : file_(std::move(file)), a_(assembly) {}

    void line(const std::string& text, int number) {
        a_.from({file_, number, text});
        tokens_ = tokens(text);
        at_ = 0;
        limbs_ = 3;
        if (tokens_.size() >= 3 && tokens_[tokens_.size() - 3] == "," &&
            tokens_.back().substr(0, 4) == "limb") {
            limbs_ = static_cast<int>(number_of(tokens_[tokens_.size() - 2]));
            if (limbs_ < 1 || limbs_ > 4) {
                a_.refuse("an instruction has 1 .. 4 limbs");
            }
            tokens_.resize(tokens_.size() - 3);
        }
        statement();
        if (at_ != tokens_.size()) {
            a_.refuse("expected the end of the line, not '" + tokens_[at_] + "'");
        }
    }

  private:
    bool take(const std::string& token) {
        const bool is = at_ < tokens_.size() && tokens_[at_] == token;
        at_ += is ? 1 : 0;
        return is;
    }
    bool take(std::initializer_list<const char*> row) {
        std::size_t n = at_;
        for (const char* token : row) {
            if (n == tokens_.size() || tokens_[n++] != token) {
                return false;
            }
        }
        at_ = n;
        return true;
    }
    void expect(std::initializer_list<const char*> row) {
        for (const char* token : row) {
            if (!take(token)) {
                a_.refuse(fmt::format("expected '{}'{}", token,
                                      at_ < tokens_.size() ? ", not '" + tokens_[at_] + "'" : ""));
            }
        }
    }
    std::string next(const char* what) {
        if (at_ == tokens_.size()) {
            a_.refuse(fmt::format("expected {}, not the end of the line", what));
        }
        return tokens_[at_++];
    }
    std::int64_t number_of(const std::string& text) const {
        if (text.empty() || text.size() > 15 ||
            text.find_first_not_of("0123456789") != std::string::npos) {
            a_.refuse("'" + text + "' is no number");
        }
        return std::stoll(text);
    }
    /// Reads a number, or a name that stands for one.
    std::int64_t value(const char* what) {
        const bool minus = take("-");
        const std::string text = next(what);
        const auto defined = a_.defined(text);
        const std::int64_t number = defined ? *defined : number_of(text);
        return minus ? -number : number;
    }
    int number(const char* what) { return static_cast<int>(value(what)); }

    void statement() {
        if (tokens_.size() == 2 && tokens_[1] == ":") {
            a_.label(tokens_[0]);
            at_ = 2;
        } else if (take("word") || take("wide") || take("local") || take("axis")) {
            const std::string name = next("a name");
            declare(name, tokens_[0]);
            const bool wide = tokens_[0] == "wide";
            if (wide ? take({"=", "0"}) : tokens_[0] == "word" && take("=")) {
                start(declared(name), wide ? 6 : limbs_);
            }
            while (at_ < tokens_.size()) {
                declare(next("a name"), tokens_[0]);
            }
        } else if (take("data")) {
            const std::string name = next("a name");
            if (words_.count(name) != 0) {
                a_.refuse(name + " is a word already");
            }
            expect({"="});
            a_.define(name, value("a number"));
        } else if (take("loop")) {
            a_.loop();
        } else if (take("repeat")) {
            a_.repeat(number("a number"), engine::kNot | engine::kNever);
            expect({"times"});
        } else if (take("test")) {
            sum(Assembly::zero());
        } else if (take("port")) {
            const Field to = port();
            expect({"="});
            a_.put(Op::kOut, {}, word(), to, false, limbs_);
        } else if (!branch()) {
            const Field to = declared(next("an instruction"));
            take("+=") ? wide_sum(to, false) : assignment(to);
        }
    }

    bool branch() {
        if (take("return")) {
            a_.give_back();
        } else if (take({"wait", "for", "the", "tick", ",", "go", "to"})) {
            a_.wait(next("a label"));
        } else if (take({"end", ",", "then"})) {
            a_.end(next("a label"));
        } else if (take("if")) {
            const int is_not = take("not") ? engine::kNot : 0;
            const int code = take("negative") ? int{engine::kNegative}
                             : take("zero")   ? int{engine::kIsZero}
                                              : port_condition();
            if (take("return")) {
                a_.give_back(is_not | code);
            } else {
                const int call = take("call") ? int{engine::kCall} : 0;
                if (call == 0) {
                    expect({"go", "to"});
                }
                a_.branch(next("a label"), call | is_not | code);
            }
        } else if (take({"go", "to"})) {
            a_.branch(next("a label"));
        } else if (take({"for", "each", "axis", "call"})) {
            a_.call_for_axes(next("a label"));
        } else if (take("call")) {
            a_.call(next("a label"));
        } else {
            return false;
        }
        return true;
    }
    int port_condition() {
        expect({"port"});
        const int code = number("a condition");
        if (code < engine::kBoard || code > 15) {
            a_.refuse("conditions of ports are 3 .. 15");
        }
        return code;
    }

    void assignment(const Field& to) {
        expect({"="});
        if (take("port")) {
            a_.put(Op::kIn, to, port(), {}, false, limbs_);
        } else if (take("wide")) {
            wide_sum(to, true);
        } else if (take({"floor", "("})) {
            const bool wide = take("wide");
            const Field a = wide ? wide_word(next("a wide word")) : word();
            expect({"*"});
            const Field b = second();
            expect({">>", "45", ")"});
            a_.put(wide ? Op::kShr : Op::kMulr, to, a, b, true, limbs_);
        } else {
            sum(to);
        }
    }

    /// Reads a, a + b, a - b, a * b, a * b >> 45 or c + (d * b >> 45).
    void sum(const Field& to) {
        if (number_alone(to)) {
            return;
        }
        const Field a = word();
        if (at_ == tokens_.size()) {
            a_.put(Op::kMull, to, a, a_.power(0), false, limbs_);
        } else if (take({"+", "("})) {
            const Field d = word();
            expect({"*"});
            const Field b = second();
            expect({">>", "45", ")"});
            if (d.code != to.code) {
                a_.refuse("in d = c + (d * b >> 45) both d are one word");
            }
            a_.put(Op::kMadr, to, a, b, false, limbs_);
        } else if (take("+")) {
            a_.put(Op::kAdd, to, a, addend(), false, limbs_);
        } else if (take("-")) {
            a_.put(Op::kSub, to, a, addend(), false, limbs_);
        } else {
            expect({"*"});
            const Field b = second();
            const bool high = take({">>", "45"});
            a_.put(high ? Op::kMulr : Op::kMull, to, a, b, false, limbs_);
        }
    }

    /// Reads a * b of a wide word, or of one that is shifted, behind `wide`.
    void wide_sum(const Field& to, bool first) {
        if (!first) {
            expect({"wide"});
        }
        const Field a = word();
        expect({"*"});
        const Field b = second();
        const bool shifted = first && take({">>", "45"});
        wide_word(shifted ? a.name : to.name);
        a_.put(shifted ? Op::kShr : Op::kMac, to, a, b, !shifted && first, limbs_);
    }

    Field wide_word(const std::string& name) const {
        if (wide_.count(name) == 0) {
            a_.refuse(name + " is no wide word");
        }
        return declared(name);
    }

    Field port() {
        const std::string name = at_ < tokens_.size() ? tokens_[at_] : "";
        return {number("a port"), name};
    }

    void declare(const std::string& name, const std::string& kind) {
        if (std::isalpha(static_cast<unsigned char>(name[0])) == 0) {
            a_.refuse("'" + name + "' is no name");
        }
        if (a_.defined(name)) {
            a_.refuse(name + " is a number already");
        }
        Field field = kind == "wide"    ? a_.wide(name)
                      : kind == "axis"  ? a_.axis_word(name)
                      : kind == "local" ? a_.scratch(locals_++)
                                        : a_.word(name);
        field.name = name;
        words_[name] = field;
        if (kind == "wide") {
            wide_.insert(name);
        }
    }
    Field declared(const std::string& name) const {
        const auto found = words_.find(name);
        if (found == words_.end()) {
            a_.refuse("no word " + name);
        }
        return found->second;
    }
    /// Reads what a word has at reset.
    void start(const Field& field, int limbs) {
        if (take({"place", "of"})) {
            a_.start(field, next("a label"), limbs);
        } else {
            a_.start(field, limbs > engine::kWordLimbs ? 0 : value("a number"), limbs);
        }
    }
    Field word() {
        if (take({"place", "of"})) {
            return a_.place_of(next("a label"));
        }
        const std::string name = next("a word");
        if (const auto number = a_.defined(name)) {
            Field field = a_.constant(*number);
            field.name = name;
            return field;
        }
        if (std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
            return a_.constant(number_of(name));
        }
        return declared(name);
    }
    /// Reads a word, or a power of two that needs none.
    Field addend() {
        const auto exponent = power_of_two();
        return exponent ? Field{a_.power(*exponent).code, tokens_[at_++]} : second();
    }
    /// n of the number 2^n that comes next, or of its name.
    std::optional<int> power_of_two() const {
        const std::string name = at_ < tokens_.size() ? tokens_[at_] : "";
        const bool raised = at_ + 1 < tokens_.size() && tokens_[at_ + 1] == "^";
        const bool digits = name.find_first_not_of("0123456789") == std::string::npos;
        const std::int64_t number =
            a_.defined(name).value_or(digits && !name.empty() && !raised ? number_of(name) : 0);
        for (int n = 0; n < 45; ++n) {
            if (number == std::int64_t{1} << n) {
                return n;
            }
        }
        return std::nullopt;
    }
    /// Reads the number 2^n, or this times 2^m: as an addend it needs no word.
    bool number_alone(const Field& to) {
        const std::size_t first = at_;
        const auto exponent = power_of_two();
        at_ += exponent ? 1 : 0;
        const int lift = exponent && take({"*", "2", "^"}) ? number("an exponent") : 0;
        if (!exponent || at_ != tokens_.size()) {
            at_ = first;
            return false;
        }
        a_.put(Op::kAdd, to, Assembly::zero(), a_.power(*exponent + lift), false, limbs_);
        return true;
    }
    Field second() {
        if (take({"2", "^"})) {
            return a_.power(number("an exponent"));
        }
        if (take({"-", "1"})) {
            return {engine::minus_power(0), "-1"};
        }
        return word();
    }

    std::string file_;
    Assembly& a_;
    std::map<std::string, Field> words_;
    std::set<std::string> wide_;
    int locals_ = 0;
    std::vector<std::string> tokens_;
    std::size_t at_ = 0;
    int limbs_ = 3;
};

}  // namespace

void assemble_text(const std::string& file, const std::string& text, Assembly& assembly) {
    SourceReader reader(file, assembly);
    std::istringstream stream(text);
    ref::TextLines lines(stream);
    while (const auto next = lines.next()) {
        std::string line(next->substr(0, next->find('#')));
        const std::size_t first = line.find_first_not_of(" \t");
        if (first != std::string::npos) {
            reader.line(line.substr(first, line.find_last_not_of(" \t") + 1 - first),
                        lines.number());
        }
    }
}

void assemble_source(const std::string& file, Assembly& assembly) {
    assemble_text(file, ref::read_text_file(file), assembly);
}

}  // namespace curvecore::assembler
