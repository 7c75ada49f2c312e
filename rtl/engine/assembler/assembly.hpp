// SPDX-License-Identifier: Apache-2.0
// The assembler of the engine's programs (hls/instruction.hpp): named words, labels, loops with a
// bound, calls for each axis. What cannot be assembled throws AssemblyError.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hls/instruction.hpp"

namespace curvecore::assembler {

/// Error whose what() is "FILE:LINE: error: reason" of the line of source at hand.
using AssemblyError = std::runtime_error;

/// A field of an instruction as it is coded, and as the source names it.
struct Field {
    int code = 0;
    std::string name;
    bool in_x = false;  // a word beyond, in page X or Y: call_for_axes() takes it away meanwhile
    bool in_y = false;
};

/// A line of source that instructions come from.
struct Source {
    std::string file;
    int line = 0;
    std::string text;
};

/// An instruction where it stands in the program.
struct Placed {
    engine::Instruction instruction;
    std::string f0, f1, f2;  // names
    std::string target;      // label of a branch
    Source source;
    bool beyond = false;  // it reads or writes a word beyond, in a page that axes take away
};

/// A loop: its first instruction, its branch back, and how often that is taken at most.
struct Loop {
    std::size_t first;
    std::size_t back;
    int bound;
};

/// Sizes of a store, in words.
struct StoreSize {
    int program = 2048;
    int data = 256;
    int axis_pages = 1;  // pages of each of X Y Z: 1 or 2
};

/// A named word of data: where its first limb stands, in words, and its value at first.
struct Datum {
    std::string name;
    std::int64_t value = 0;
    int words = 1;
};

/// A word that a reset gives a value, or the place of a label's instruction.
struct Start {
    Field field;
    std::int64_t value;
    std::string label;
    int limbs;
    Source source;
};

constexpr int kAxes = 3;                  // axes that have pages: X Y Z
constexpr char kBeyondInX[] = "X again";  // F1 of what opens page X of words beyond

class Assembly {
  public:
    explicit Assembly(const StoreSize& size = StoreSize());

    // Data. A name has one word; constants of one value share it.
    Field word(const std::string& name);
    /// A word of each of X Y Z, read in what call_for_axes() calls.
    Field axis_word(const std::string& name);
    /// A word of the auxiliary axes together, read behind open_auxiliary() of page 0 or 1.
    Field auxiliary_word(const std::string& name, int page = 0);
    /// The n-th of the words that live in one call of one program alone: all programs share them.
    Field scratch(int n) { return word("scratch " + std::to_string(n)); }
    Field constant(std::int64_t value);
    /// A wide word, six limbs.
    Field wide(const std::string& name);
    static Field zero() { return {engine::kZero / engine::kWordLimbs, "0"}; }
    /// 2^n as F1.
    Field power(int n) const;
    /// Constant that is the place of a label's instruction, for OUT to the link.
    Field place_of(const std::string& label);
    /// Gives a word its value at reset; a wide one has 6 limbs, and 0.
    void start(const Field& field, std::int64_t value, int limbs = 3);
    /// Gives it the place of a label's instruction.
    void start(const Field& field, const std::string& label, int limbs = 3);
    /// Writes all these values, behind all labels: a reset leaves the data as they are. None of
    /// them needs a constant.
    void put_starts();
    /// Gives a number a name, for all sources.
    void define(const std::string& name, std::int64_t value);
    std::optional<std::int64_t> defined(const std::string& name) const;

    // Program. What follows comes from a line of source.
    void from(const Source& source) { source_ = source; }
    void label(const std::string& name);
    /// Gives a label that is placed a second name.
    void label(const std::string& name, const std::string& as);
    void put(engine::Op op, const Field& f2, const Field& f0, const Field& f1, bool flag = false,
             int limbs = 3);
    void add(const Field& to, const Field& a, const Field& b) { put(engine::Op::kAdd, to, a, b); }
    void copy(const Field& to, const Field& from) { put(engine::Op::kMull, to, from, power(0)); }
    void branch(const std::string& to, int condition = engine::kNot | engine::kNever);
    void call_for_axes(const std::string& subroutine);
    /// Puts what `put_one` puts three times, with the words of an axis: for subroutines, whose link
    /// a call would take.
    void for_axes(const std::function<void()>& put_one);
    /// Makes page X that of the auxiliary axes.
    void open_auxiliary(int page = 0);
    /// Opens the words for which those without a page did not suffice: page Y, and with more than
    /// 256 words X, but for axes.
    void open_further();
    /// Makes page X that of these words again, behind open_auxiliary().
    void close_axes();
    /// Nothing, for a subroutine that was left out.
    void call(const std::string& subroutine);
    /// Says that a subroutine has nothing to do, and does not come.
    void leave_out(const std::string& subroutine) { left_out_.insert(subroutine); }
    void give_back(int condition = engine::kNot | engine::kNever);
    /// Waits for the tick, then goes on at a label.
    void wait(const std::string& next);
    /// Ends the foreground; it begins again at a label.
    void end(const std::string& next);
    /// Opens a loop; its end branches back if the condition holds, `bound` times at most.
    void loop();
    void repeat(int bound, int condition);

    /// Gives branches their targets. @throws AssemblyError
    void finish();

    const std::vector<Placed>& placed() const { return placed_; }
    const std::vector<Loop>& loops() const { return loops_; }
    const std::map<std::string, std::size_t>& labels() const { return labels_; }
    const std::map<int, Datum>& data() const { return data_; }  // by place, X's for axes
    const std::vector<Start>& starts() const { return starts_; }
    const StoreSize& size() const { return size_; }
    /// Returns the field of a word by its name.
    const Field& field(const std::string& name) const { return names_.at(name); }
    /// Place of a word in the data memory, of an axis' word that of axis 0, 1, 2.
    int place(const std::string& name, int axis = 0) const;
    int data_words() const;
    std::vector<std::uint32_t> program() const;
    /// Limbs of the data memory, constants in it.
    std::vector<std::int16_t> memory() const;

    [[noreturn]] void refuse(const std::string& reason) const;

  private:
    Field named(const std::string& name, int words);
    int place_of_constant(const Field& field) const;
    void set_page(int port, int page, const char* name);
    int auxiliary_page() const;
    int further_page(bool x) const;
    bool further_in_x() const;
    void keep_pages();
    void jump(const std::string& to, int f0, bool flag = false);

    StoreSize size_;
    std::map<std::string, Field> names_;
    std::map<int, Datum> data_;
    std::vector<Placed> placed_;
    std::map<std::string, std::size_t> labels_;
    std::vector<std::size_t> open_loops_;
    std::vector<Loop> loops_;
    Source source_;
    int shared_words_ = engine::kConstantWords;
    std::optional<int> gap_;  // in front of a wide word
    int axis_words_ = 0;
    int auxiliary_words_[2] = {0, 0};
    int further_words_ = 0;
    std::vector<Start> starts_;
    std::set<std::string> of_axes_;  // what call_for_axes() calls
    std::set<std::string> left_out_;
    std::map<std::string, std::int64_t> definitions_;
    std::map<std::string, int> places_of_;  // places of words, by the labels that they are of
};

}  // namespace curvecore::assembler
