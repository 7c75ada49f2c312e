// SPDX-License-Identifier: Apache-2.0
// A program's parameters as RS274/NGC has them: #1 .. #5601, #<local> and #<_global>.
//
// Numbers that were never set are 0. #1 .. #30 are arguments: a call sets all of them, and its
// return brings the caller's back. Named ones exist once they are assigned to; names are in lower
// case, those that begin with '_' are the same everywhere, others belong to one call. Some of both
// kinds are computed, as the position of #5420 and #<_x>: who knows the value gives a function.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace curvecore::ref {

/// What is wrong with the use of a parameter; who reads a line adds the place.
class ParameterError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class ProgramParameters {
  public:
    static constexpr int kLast = 5601;
    static constexpr int kArguments = 30;
    static constexpr int kDeepestCall = 9;

    ProgramParameters();

    static bool exists(int number) { return number >= 1 && number <= kLast; }
    bool exists(const std::string& name) const;

    /// @throws ParameterError beyond 1 .. 5601
    double number(int number) const;
    /// @throws ParameterError where there is none
    double named(const std::string& name) const;

    /// For a program: @throws ParameterError of what it may only read
    void assign(int number, double value);
    void assign(const std::string& name, double value);
    /// Makes it exist, with the value 0 if it is new.
    void declare(const std::string& name);
    /// For what the program's codes do to parameters, as G28.1 does.
    void set(int number, double value) { numbered_.at(number) = value; }

    /// From here on these values are asked for, and cannot be assigned.
    void compute(int number, std::function<double()> value);
    void compute(const std::string& name, std::function<double()> value);

    /// A subroutine begins, with names of its own and, unless it shares its caller's #1 .. #30,
    /// with these arguments. @throws ParameterError beyond nine calls in each other
    void enter(const std::vector<double>& arguments);
    void enter_sharing();
    void leave();
    int calls() const { return static_cast<int>(calls_.size()) - 1; }

  private:
    using Names = std::unordered_map<std::string, double>;

    struct Call {
        std::vector<double> arguments;  // of the caller; empty: shared
        Names names;
    };

    const Names& names_of(const std::string& name) const;
    void push(Call call);

    std::vector<double> numbered_;
    Names global_;
    std::vector<Call> calls_;  // the program itself is the first
    std::map<int, std::function<double()>> computed_numbers_;
    std::map<std::string, std::function<double()>> computed_names_;
};

}  // namespace curvecore::ref
