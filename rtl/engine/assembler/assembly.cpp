// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/assembler/assembly.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace curvecore::assembler {

using engine::Instruction;
using engine::Op;

namespace {

constexpr int kSharedWords = 128;  // without a page
constexpr int kFirstPage = kSharedWords / engine::kPageWords;
constexpr int kPageConstants = engine::kConstantWords - kAxes;  // words that nothing writes
constexpr int kMinusOneWord = engine::kMinusOne / engine::kWordLimbs;

/// Page of an axis: those of X first, so that few words need few pages.
int page_of(int axis, int place) {
    return kFirstPage + axis + (place >= engine::kPageWords ? kAxes : 0);
}

}  // namespace

Assembly::Assembly(const StoreSize& size) : size_(size) {
    for (int axis = 0; axis < kAxes; ++axis) {
        const int page = page_of(axis, 0);
        const std::string name = fmt::format("{}", page);
        names_[name] = {kPageConstants + axis, name};
        data_[kPageConstants + axis] = {name, page, 1};
    }
}

void Assembly::refuse(const std::string& reason) const {
    throw AssemblyError(source_.file + (source_.line > 0 ? fmt::format(":{}", source_.line) : "") +
                        ": error: " + reason);
}

Field Assembly::named(const std::string& name, int words) {
    const auto found = names_.find(name);
    if (found != names_.end()) {
        return found->second;
    }
    const int place = words == 1 && gap_ ? *gap_ : shared_words_ + shared_words_ % words;
    if (place + words > kSharedWords) {
        const int further = further_words_ + further_words_ % words;
        further_words_ = further + words;
        const int page = further / engine::kPageWords;
        const int in_page = further % engine::kPageWords;
        data_[engine::kPageWords * further_page(page != 0) + in_page] = {name, 0, words};
        return names_[name] = {(page == 0 ? engine::kY : engine::kX) + in_page, name, page != 0,
                               page == 0};
    }
    if (gap_ == place) {
        gap_.reset();
    } else {
        gap_ = place > shared_words_ ? std::optional<int>(shared_words_) : gap_;
        shared_words_ = place + words;
    }
    data_[place] = {name, 0, words};
    return names_[name] = {place, name};
}

Field Assembly::word(const std::string& name) { return named(name, 1); }
Field Assembly::wide(const std::string& name) { return named(name, 2); }

Field Assembly::constant(std::int64_t value) {
    if (value == 0) {
        return zero();
    }
    if (value < -(std::int64_t{1} << 45) || value >= std::int64_t{1} << 45) {
        refuse(fmt::format("the constant {} needs more than three limbs", value));
    }
    Field field = word(fmt::format("{}", value));
    data_[place_of_constant(field)].value = value;
    return field;
}

int Assembly::place_of_constant(const Field& field) const {
    return field.code < kSharedWords
               ? field.code
               : engine::kPageWords * further_page(field.in_x) + field.code % engine::kPageWords;
}

Field Assembly::place_of(const std::string& label) {
    Field field = word("place of " + label);
    places_of_[label] = place_of_constant(field);
    return field;
}

void Assembly::start(const Field& field, std::int64_t value, int limbs) {
    starts_.push_back({field, value, "", limbs, source_});
}

void Assembly::start(const Field& field, const std::string& label, int limbs) {
    starts_.push_back({field, 0, label, limbs, source_});
}

void Assembly::put_starts() {
    for (const Start& start : starts_) {
        const std::string& shown =
            start.label.empty() ? fmt::format("{}", start.value) : start.label;
        from({"", 0, fmt::format("{} = {}", start.field.name, shown)});
        if (start.limbs > engine::kWordLimbs) {
            put(Op::kMac, start.field, zero(), power(0), true);
            continue;
        }
        const auto label = labels_.find(start.label);
        if (!start.label.empty() && label == labels_.end()) {
            from(start.source);
            refuse("no label " + start.label);
        }
        const std::int64_t value =
            start.label.empty() ? start.value : static_cast<std::int64_t>(label->second);
        const Op op = value < 0 ? Op::kSub : Op::kAdd;
        bool first = true;
        for (int n = 0; n < engine::kLimbBits * start.limbs; ++n) {
            if (((value < 0 ? -value : value) >> n & 1) != 0) {
                const bool low = !first && value > 0;  // limbs above n's stay as they are
                put(op, start.field, first ? zero() : start.field, power(n), false,
                    low ? n / engine::kLimbBits + 1 : start.limbs);
                first = false;
            }
        }
        if (first) {
            put(Op::kMull, start.field, zero(), power(0), false, start.limbs);
        }
    }
}

void Assembly::define(const std::string& name, std::int64_t value) {
    if (definitions_.emplace(name, value).first->second != value) {
        refuse(name + " is there twice, with another number");
    }
}

std::optional<std::int64_t> Assembly::defined(const std::string& name) const {
    const auto found = definitions_.find(name);
    return found == definitions_.end() ? std::nullopt : std::optional(found->second);
}

Field Assembly::axis_word(const std::string& name) {
    const auto found = names_.find(name);
    if (found != names_.end()) {
        return found->second;
    }
    const int place = axis_words_;
    ++axis_words_;
    data_[engine::kPageWords * page_of(0, place) + place % engine::kPageWords] = {name, 0, 1};
    const int base = place < engine::kPageWords ? engine::kX : engine::kY;
    return names_[name] = {base + place % engine::kPageWords, name};
}

Field Assembly::auxiliary_word(const std::string& name, int page) {
    const auto found = names_.find(name);
    if (found != names_.end()) {
        return found->second;
    }
    const int place = auxiliary_words_[page]++;
    data_[engine::kPageWords * (auxiliary_page() + page) + place] = {name, 0, 1};
    return names_[name] = {engine::kX + place, name};
}

int Assembly::auxiliary_page() const { return kFirstPage + kAxes * size_.axis_pages; }
/// Page Y of words beyond, or X: the last one, which is opened most.
int Assembly::further_page(bool x) const {
    return size_.data / engine::kPageWords - (further_in_x() && !x ? 2 : 1);
}
bool Assembly::further_in_x() const { return size_.data > 256; }

Field Assembly::power(int n) const {
    if (n < 0 || n > 59) {
        refuse(fmt::format("2^{} is no power of an instruction: 0 .. 59", n));
    }
    return {engine::power(n), fmt::format("2^{}", n)};
}

void Assembly::label(const std::string& name) {
    if (!labels_.emplace(name, placed_.size()).second) {
        refuse("the label " + name + " is there twice");
    }
}

void Assembly::label(const std::string& name, const std::string& as) {
    const auto place = labels_.find(as);
    if (place == labels_.end()) refuse("no label " + as);
    if (!labels_.emplace(name, place->second).second) {
        refuse("the label " + name + " is there twice");
    }
}

void Assembly::put(Op op, const Field& f2, const Field& f0, const Field& f1, bool flag, int limbs) {
    Instruction i;
    i.op = op;
    i.limbs = limbs;
    i.flag = flag;
    i.f0 = f0.code;
    i.f1 = f1.code;
    i.f2 = f2.code;
    if (engine::overlaps(i)) {
        refuse(fmt::format("hazard: {} is read while it is written", f2.name));
    }
    const bool beyond =
        f0.in_x || f1.in_x || f2.in_x || (size_.axis_pages > 1 && (f0.in_y || f1.in_y || f2.in_y));
    placed_.push_back({i, f0.name, f1.name, f2.name, "", source_, beyond});
}

void Assembly::jump(const std::string& to, int f0, bool flag) {
    put(Op::kBr, {}, {f0, ""}, {}, flag, 1);
    placed_.back().target = to;
}

void Assembly::branch(const std::string& to, int condition) { jump(to, condition); }

void Assembly::call(const std::string& subroutine) {
    if (left_out_.count(subroutine) != 0) return;
    jump(subroutine, engine::kCall | engine::kNot);
}

void Assembly::give_back(int condition) {
    put(Op::kBr, {}, {engine::kReturn | condition, ""}, {}, false, 1);
}

void Assembly::wait(const std::string& next) { jump(next, engine::kNot, true); }

void Assembly::end(const std::string& next) { jump(next, engine::kEnd | engine::kNot); }

void Assembly::set_page(int port, int page, const char* name) {
    const bool last = page == size_.data / engine::kPageWords - 1;  // so is -1, a fourth limb
    put(Op::kOut, {}, last ? Field{kMinusOneWord, fmt::format("{}", page)} : constant(page),
        {port, name}, false, last ? engine::kWordLimbs : 1);
}

void Assembly::open_auxiliary(int page) { set_page(engine::kPortX, auxiliary_page() + page, "X"); }
void Assembly::open_further() {
    if (further_in_x() && size_.axis_pages == 1) {  // at reset alone: -2, the last page but one
        put(Op::kSub, scratch(0), zero(), power(1), false, 1);
        put(Op::kOut, {}, scratch(0), {engine::kPortY, "Y"}, false, 1);
    } else {
        set_page(engine::kPortY, further_page(false), "Y");
    }
    close_axes();
}
void Assembly::close_axes() {
    if (further_in_x()) {
        set_page(engine::kPortX, further_page(true), kBeyondInX);
    }
}

void Assembly::call_for_axes(const std::string& subroutine) {
    for_axes([&] { call(subroutine); });
    of_axes_.insert(subroutine);
}

void Assembly::for_axes(const std::function<void()>& put_one) {
    for (int axis = 0; axis < kAxes; ++axis) {
        for (int page = 0; page < size_.axis_pages; ++page) {
            set_page(page == 0 ? engine::kPortX : engine::kPortY,
                     page_of(axis, page * engine::kPageWords), page == 0 ? "X" : "Y");
        }
        put_one();
    }
    size_.axis_pages > 1 ? open_further() : close_axes();
}

void Assembly::loop() { open_loops_.push_back(placed_.size()); }

void Assembly::repeat(int bound, int condition) {
    if (open_loops_.empty()) {
        refuse("the end of a loop that was not opened");
    }
    if (bound < 1) {
        refuse(fmt::format("a loop without a bound: {}", bound));
    }
    const std::string name = fmt::format("loop {}", open_loops_.back());
    labels_.emplace(name, open_loops_.back());
    loops_.push_back({open_loops_.back(), placed_.size(), bound});
    jump(name, condition);
    open_loops_.pop_back();
}

void Assembly::keep_pages() {
    for (const std::string& label : of_axes_) {
        for (std::size_t at = labels_.at(label); at < placed_.size(); ++at) {
            source_ = placed_[at].source;
            if (placed_[at].beyond) {
                refuse(label + " is called for axes: their pages have none of the words beyond");
            }
            const Instruction& i = placed_[at].instruction;
            if (engine::is_branch(i.op) && (i.f0 & engine::kReturn) != 0) {
                break;
            }
        }
    }
}

void Assembly::finish() {
    for (Placed& placed : placed_) {
        if (placed.target.empty()) {
            continue;
        }
        source_ = placed.source;
        const auto found = labels_.find(placed.target);
        if (found == labels_.end()) {
            refuse("no label " + placed.target);
        }
        placed.instruction.f1 = static_cast<int>(found->second >> 8);
        placed.instruction.f2 = static_cast<int>(found->second & 0xff);
    }
    source_ = {};
    for (const auto& [label, place] : places_of_) {
        const auto found = labels_.find(label);
        if (found == labels_.end()) {
            refuse("no label " + label);
        }
        data_[place].value = static_cast<std::int64_t>(found->second);
    }
    if (!open_loops_.empty()) {
        refuse("a loop has no end");
    }
    const auto fits = [&](int words, int most, const char* of) {
        if (words > most) {
            refuse(fmt::format("the programs need {} words {}, there are {}", words, of, most));
        }
    };
    if (static_cast<int>(placed_.size()) > size_.program) {
        refuse(fmt::format("the programs need {} instructions, the store has {}", placed_.size(),
                           size_.program));
    }
    fits(further_words_, (further_in_x() ? 2 : 1) * engine::kPageWords,
         "beyond those without a page");
    keep_pages();
    source_ = {};
    fits(axis_words_, size_.axis_pages * engine::kPageWords, "of each axis");
    for (const int auxiliary : auxiliary_words_) {
        fits(auxiliary, engine::kPageWords, "of auxiliary axes");
    }
    const int pages = (further_words_ + engine::kPageWords - 1) / engine::kPageWords;
    const int words = data_words() + pages * engine::kPageWords;
    if (words > size_.data) {
        refuse(fmt::format("the data need {} words, the store has {}", words, size_.data));
    }
}

int Assembly::place(const std::string& name, int axis) const {
    for (const auto& [place, datum] : data_) {
        if (datum.name == name) {
            const bool of_axis =
                place >= kSharedWords && place < engine::kPageWords * auxiliary_page();
            return place + (of_axis ? axis * engine::kPageWords : 0);
        }
    }
    refuse("no word " + name);
}

int Assembly::data_words() const {
    const int last = auxiliary_words_[1] > 0   ? auxiliary_page() + 1
                     : auxiliary_words_[0] > 0 ? auxiliary_page()
                     : axis_words_ > 0         ? page_of(kAxes - 1, axis_words_ - 1)
                                               : kFirstPage - 1;
    return (last + 1) * engine::kPageWords;
}

std::vector<std::uint32_t> Assembly::program() const {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(size_.program));
    std::transform(placed_.begin(), placed_.end(), words.begin(),
                   [](const Placed& placed) { return encode(placed.instruction); });
    return words;
}

std::vector<std::int16_t> Assembly::memory() const {
    std::vector<std::int16_t> limbs(static_cast<std::size_t>(size_.data) *
                                    std::size_t{engine::kWordLimbs});
    for (int place = 0; place <= engine::kZero; ++place) {
        limbs[static_cast<std::size_t>(place)] = engine::constant_limb(place);
    }
    for (const auto& [place, datum] : data_) {
        for (int n = 0; n < 3; ++n) {
            const std::int64_t above = datum.value >> (engine::kLimbBits * n);
            limbs[std::size_t{engine::kWordLimbs} * static_cast<std::size_t>(place) +
                  static_cast<std::size_t>(n)] =
                static_cast<std::int16_t>(n < 2 ? above & 0x7fff : above);
        }
    }
    return limbs;
}

}  // namespace curvecore::assembler
