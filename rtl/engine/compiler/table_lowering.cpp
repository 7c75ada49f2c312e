// SPDX-License-Identifier: Apache-2.0
#include "rtl/engine/compiler/table_lowering.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hls/configuration.hpp"
#include "hls/fixed_word.hpp"
#include "ref/curves/order_demand.hpp"
#include "rtl/engine/compiler/line_lowering.hpp"

namespace curvecore::assembler {

using engine::Op;
using ref::TableLine;
using ref::TableTerm;

FineScale fine_scale(const ref::CoreParameters& core) {
    constexpr int kMostFine = hls::kPathFrac;  // a step's length is 2^(kPathFrac + k)
    const int fine = 47 + core.guard_bits - core.coef_bits;
    return fine > kMostFine ? FineScale{fine - kMostFine, kMostFine} : FineScale{0, fine};
}

namespace {

constexpr int kAxesBeforeOthers = 3;

/// Rows of `anchor` and `order` that no step changes: made at load.
std::set<std::string> fixed_rows(const ref::CurveTable& table) {
    std::set<std::string> fixed;
    for (const auto& [name, row] : table.rows) {
        if (!row.start && name != "tau") {
            fixed.insert(name);
        }
    }
    for (const char* section : {"next", "sample"}) {
        for (const TableLine& line : table.section(section)) {
            fixed.erase(line.row);
        }
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (const char* section : {"anchor", "order"}) {
            for (const TableLine& line : table.section(section)) {
                bool same = line.function == TableLine::Function::kTerms;
                for (const TableTerm& term : line.terms) {
                    for (const ref::RowOperand& of : {term.a, term.b}) {
                        same &= of.row.empty() || fixed.count(same_row(table, of).row) != 0;
                    }
                }
                changed |= !same && fixed.erase(line.row) != 0;
            }
        }
    }
    return fixed;
}

class Lowering {
  public:
    Lowering(const ref::CurveTable& table, const ref::CoreParameters& core)
        : table_(table),
          core_(core),
          by_lines_(table.samples_by_lines(core.polynomial())),
          demand_(order_demand(table, core.order, core.polynomial())),
          fixed_(fixed_rows(table)),
          writer_(code_, core.coef_bits),
          lines_(table, core, demand_, writer_) {
        code_.name = table.name;
    }

    CurveCode made() {
        words();
        load();
        writer_.begin(code_.open);
        lines("anchor", false);
        orders(false);
        late_orders();
        for (const TableLine& line : table_.section("next")) {
            if (is_early(line)) {
                lines_.lower(line);
            }
        }
        next();
        sample();
        return std::move(code_);
    }

  private:
    void words() {
        for (const auto& [field, name] : table_.bus) {
            const bool of_axis = table_.rows.at(name).of_axis;
            const int word = lines_.state(name, field + (of_axis ? "[k]" : ""));
            if (table_.rows.at(name).word) {
                writer_.fix(word);
            }
        }
        const std::pair<const char*, const char*> scales[] = {
            {scale_word::kToTau, "tau_scale"},
            {scale_word::kToFine, "fine_scale"},
            {scale_word::kPlaceToFine, "place_scale"},
            {scale_word::kDown, "step_scale"}};
        for (const auto& [name, word] : scales) {
            writer_.fix(writer_.value(name, false, word));
        }
        writer_.fix(writer_.value(place_word::kStart, true, "start[k]"));
        writer_.value(place_word::kOrigin, true, "origin[k]");
        writer_.value(place_word::kFine, true, "fine[k]");
        writer_.value(place_word::kSigma, false, "sigma");
        for (int axis = kAxesBeforeOthers; axis < core_.axes(); ++axis) {
            writer_.fix(auxiliary("advance", axis));
            writer_.fix(auxiliary("start", axis));
        }
    }

    /// Rows that are fixed in the segment, and what a segment begins with.
    void load() {
        writer_.begin(code_.load);
        down_twice();
        writer_.from({table_.file, 0, "origins"});
        for (int axis = kAxesBeforeOthers; axis < core_.axes(); ++axis) {
            copy(auxiliary("origin", axis), auxiliary("start", axis));
        }
        if (!ref::makes(table_, "anchor", "place")) {
            copy(writer_.value(place_word::kOrigin, true), writer_.value(place_word::kStart, true));
        }
        for (const auto& [name, row] : table_.rows) {
            if (row.start && row.value) {
                writer_.from({table_.file, row.line, fmt::format("const {}", name)});
                copy(lines_.state(name), lines_.constant(*row.value, row.fraction));
            }
        }
        for (const TableLine& line : table_.section("load")) {
            writer_.fix(lines_.lower(line));
        }
        lines("anchor", true);
        orders(true);
    }

    /// (2^(44-s))^2 / 2^45, doubled.
    void down_twice() {
        writer_.from({table_.file, 0, scale_word::kDownTwice});
        const int down = writer_.value(scale_word::kDown, false);
        const int half = writer_.temporary(false);
        const int twice = writer_.value(scale_word::kDownTwice, false);
        writer_.share(Op::kMulr, half, {down}, {down}, true);
        writer_.share(Op::kAdd, twice, {half}, {half});
        writer_.fix(twice);
    }

    void next() {
        writer_.begin(code_.next);
        writer_.from({table_.file, 0, "origins of auxiliary axes: advance"});
        for (int axis = kAxesBeforeOthers; axis < core_.axes(); ++axis) {
            lines_.move(auxiliary("origin", axis), auxiliary("origin", axis),
                        auxiliary("advance", axis), scale_word::kToFine);
        }
        for (const TableLine& line : table_.section("next")) {
            if (is_early(line)) {
                continue;
            }
            const int moved = lines_.lower(line);
            if (line.row == "move") {
                const int origin = writer_.value(place_word::kOrigin, true);
                lines_.move(origin, origin, moved, scale_word::kToFine);
            }
        }
    }

    /// Lines of `anchor`, fixed or not.
    void lines(const char* section, bool fixed) {
        for (const TableLine& line : table_.section(section)) {
            if ((fixed_.count(line.row) != 0) != fixed) {
                continue;
            }
            const int made = lines_.lower(line);
            if (fixed) {
                writer_.fix(made);
            }
            if (line.row == "place") {
                lines_.move(writer_.value(place_word::kOrigin, true),
                            writer_.value(place_word::kStart, true), made,
                            scale_word::kPlaceToFine);
            }
        }
    }

    void orders(bool fixed) {
        std::set<std::string> begun;  // rows whose order 1 the anchor gives
        for (const TableLine& line : table_.section("anchor")) {
            if (line.order.value_or(0) == 1) {
                begun.insert(line.row);
            }
        }
        for (int i = 1; i <= core_.order; ++i) {
            for (const TableLine& line : table_.section("order")) {
                const auto needed = demand_.find(line.row);
                if (needed == demand_.end() || i > needed->second ||
                    (fixed_.count(line.row) != 0) != fixed ||
                    (i == 1 && begun.count(line.row) != 0)) {
                    continue;
                }
                const int made = lines_.lower(line, i);
                if (fixed) {
                    writer_.fix(made);
                }
            }
        }
    }

    bool read_by_sample(const std::string& row) const {
        const auto reads = [&](const TableLine& line) {
            return line.series.row == row || line.variable == row ||
                   std::any_of(line.terms.begin(), line.terms.end(), [&](const TableTerm& term) {
                       return term.a.row == row || term.b.row == row;
                   });
        };
        const auto& lines = table_.section("sample");
        return by_lines_ ? std::any_of(lines.begin(), lines.end(), reads) : row == table_.output;
    }

    /// Returns whether a sum of `next` is made as soon as its series is there, which no sample
    /// reads: then the series needs no words.
    bool is_early(const TableLine& line) const {
        return line.function == TableLine::Function::kSum && !line.of_axis &&
               !read_by_sample(line.series.row) && !read_by_sample(line.row);
    }

    /// Orders over i of a series that is there to the end, for what comes behind the last order:
    /// they are made anew, so that they need no words meanwhile.
    void late_orders() {
        const auto& next = table_.section("next");
        for (const TableLine& line : table_.section("order")) {
            const bool over = line.terms.size() == 1 && !line.of_axis &&
                              line.terms[0].meeting == TableTerm::Meeting::kOverOrder;
            const auto stays = [&](const TableLine& of) {
                return is_early(of) && over &&
                       of.series.row == same_row(table_, line.terms[0].a).row;
            };
            const auto needed = demand_.find(line.row);
            if (needed == demand_.end() || std::none_of(next.begin(), next.end(), stays)) {
                continue;
            }
            for (int i = 1; i <= needed->second; ++i) {
                lines_.lower_anew(line, i);
            }
        }
    }

    void sample() {
        writer_.begin(code_.sample);
        const int unit = core_.coef_bits - 1;
        const int tau = lines_.state("tau");
        writer_.from({table_.file, 0, "tau = sigma / 2^k, cut"});
        const int aligned = writer_.temporary(false);
        writer_.share(Op::kMull, aligned, {writer_.value(place_word::kSigma, false)},
                      {writer_.value(scale_word::kToTau, false)});
        writer_.share(Op::kMulr, tau, {aligned}, {-1, unit + 2}, true);
        if (by_lines_) {
            for (const TableLine& line : table_.section("sample")) {
                const int made = lines_.lower(line);
                if (line.row == "d") {
                    land(made);
                }
            }
        } else {
            TableLine line;
            line.row = "d";
            line.of_axis = true;
            line.fraction = table_.rows.at(table_.output).fraction;
            line.function = TableLine::Function::kHorner;
            line.series.row = table_.output;
            line.series.of_axis = true;
            line.text = fmt::format("d[k] : {:+} = horner({}[k])", line.fraction, table_.output);
            land(lines_.lower(line));
        }
        writer_.from({table_.file, 0, "auxiliary axes: advance*tau"});
        for (int axis = kAxesBeforeOthers; axis < core_.axes(); ++axis) {
            const int moved = writer_.temporary(false);
            lines_.product(moved, auxiliary("advance", axis), tau, unit, false);
            lines_.move(auxiliary("fine", axis), auxiliary("origin", axis), moved,
                        scale_word::kToFine);
        }
    }

    void land(int displacement) {
        lines_.move(writer_.value(place_word::kFine, true),
                    writer_.value(place_word::kOrigin, true), displacement, scale_word::kToFine);
    }

    int auxiliary(const char* what, int axis) {
        return writer_.auxiliary(fmt::format("{}[{}]", what, axis));
    }

    void copy(int to, int from) {
        writer_.put(writer_.at(to).of_axis, Op::kMull, to, {from}, {-1, 0});
    }

    const ref::CurveTable& table_;
    const ref::CoreParameters& core_;
    bool by_lines_;  // samples
    std::map<std::string, int> demand_;
    std::set<std::string> fixed_;
    CurveCode code_;
    StepWriter writer_;
    LineLowering lines_;
};

}  // namespace

CurveCode lower(const ref::CurveTable& table, const ref::CoreParameters& core) {
    return Lowering(table, core).made();
}

}  // namespace curvecore::assembler
