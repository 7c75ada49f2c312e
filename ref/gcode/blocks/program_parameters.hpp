// SPDX-License-Identifier: Apache-2.0
// A program's parameters in RS274/NGC: #1 .. #5601, #<local> and #<_global>.
//
// Numbered ones are 0 until they are set. #1 .. #30 are arguments: a call sets all of them, and its
// return restores the caller's. Named ones exist once they are assigned to; names are in lower
// case, those that begin with '_' are the same everywhere, others belong to one call. Some of both
// kinds are computed by a function of their owner, as the positions #5420 and #<_x>.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace curvecore::ref {

/// Error in the use of a parameter; the reader of the line adds the place.
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

    /// @throws ParameterError outside 1 .. 5601
    double number(int number) const;
    /// @throws ParameterError if there is none
    double named(const std::string& name) const;

    /// Assigns a value in a program. @throws ParameterError for a read-only parameter
    void assign(int number, double value);
    void assign(const std::string& name, double value);
    /// Declares a parameter, with the value 0 if it is new.
    void declare(const std::string& name);
    /// Sets a parameter on behalf of a code, as G28.1 does.
    void set(int number, double value) { numbered_.at(number) = value; }

    /// Computes this parameter from now on; it cannot be assigned.
    void compute(int number, std::function<double()> value);
    void compute(const std::string& name, std::function<double()> value);

    /// Begins a subroutine, with names of its own and, unless it shares its caller's #1 .. #30,
    /// with these arguments. @throws ParameterError beyond nine nested calls
    void enter(const std::vector<double>& arguments);
    void enter_sharing();
    void leave();
    int calls() const { return static_cast<int>(calls_.size()) - 1; }

  private:
    using Names = std::unordered_map<std::string, double>;

    struct Call {
        std::vector<double> arguments;  // those of the caller; empty: shared
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
