// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/board/board_panel.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "ref/curve/axes.hpp"

namespace curvecore::sysc {
BoardPanel::BoardPanel(const std::string& web, const BoardServer& server, bool fast)
    : server_(server),
      fast_(fast),
      page_(
          web,
          [this](std::size_t from) {
              const std::lock_guard lock(mutex_);
              return points_.json(from);
          },
          none_) {
    const nlohmann::json hello{{"program", "virtual board " + server.where()},
                               {"version", CURVECORE_PROGRAM_VERSION},
                               {"command", "board"}};
    page_.show("hello", hello.dump());
    const std::string address = page_.address();
    fmt::print("page: {}\n", address.substr(0, address.find('#')));
    std::fflush(stdout);
}

void BoardPanel::see(const VirtualEdge& edge) {
    if (edge.output == kPwm) {
        if (!edge.on) on_ += edge.clock - risen_;
        risen_ = edge.clock;
    }
    outputs_ = (outputs_ & ~(1U << edge.output)) | (edge.on ? 1U : 0U) << edge.output;
}

/// Adds the place to the way since the drives were turned on.
void BoardPanel::follow() {
    const std::lock_guard lock(mutex_);
    const VirtualBoard& board = server_.board();
    const bool begins = board.drives_on() && !drives_on_;
    if (begins) {
        points_.clear();
        way_ = shown_way_ = 0;
    }
    double square = 0;
    for (std::size_t n = 0; n < places_.size(); ++n) {
        square += std::pow(static_cast<double>(board.places()[n] - places_[n]), 2);
    }
    places_ = board.places();
    if (square == 0 && !begins) return;
    if (!begins) way_ += std::sqrt(square);
    const auto point = [this] {
        return ShownPoint{ref::Vec3(places_[0], places_[1], places_[2]), way_};
    };
    points_.add(point, begins);
}

void BoardPanel::turn() {
    follow();
    note_changes();
    const WireClock::time_point now = WireClock::now();
    if (now < shown_ + PageServer::kPeriod) return;
    shown_ = now;
    page_.show("status", status());
    shown_way_ = way_;
}

void BoardPanel::note(const std::string& text) {
    const double time_s = static_cast<double>(server_.clocks()) / server_.times().clock_hz;
    page_.note(fmt::format("{:.3f} s {}", time_s, text));
}

void BoardPanel::note_changes() {
    const bool on = server_.board().drives_on();
    if (on != drives_on_) note(on ? "drives on" : "drives off");
    drives_on_ = on;
    const unsigned changed = (outputs_ ^ shown_outputs_) & ((1U << kPwm) - 1);
    for (int bit = 0; bit < kPwm; ++bit) {
        if ((changed >> bit & 1) == 0) continue;
        note(fmt::format("output {} {}", bit, (outputs_ >> bit & 1) != 0 ? "on" : "off"));
    }
    shown_outputs_ = outputs_;
}

/// Share of the clocks since it was asked last in which the PWM was on; the one before if none was.
double BoardPanel::power() {
    const std::uint64_t now = server_.clocks();
    if ((outputs_ >> kPwm & 1) != 0) on_ += now - risen_;
    const std::uint64_t clocks = now - counted_;
    if (clocks > 0) power_ = static_cast<double>(on_) / static_cast<double>(clocks);
    on_ = 0;
    risen_ = counted_ = now;
    return power_;
}

std::string BoardPanel::status() {
    nlohmann::ordered_json json;
    json["state"] = !drives_on_ ? "drives off" : way_ != shown_way_ ? "runs" : "stands";
    for (std::size_t n = 0; n < places_.size(); ++n) {
        json["axes"].push_back(
            {{"name", std::string(1, ref::kAxisLetters[n])}, {"steps", places_[n]}});
    }
    json["way_steps"] = way_;
    const double time_s = static_cast<double>(server_.clocks()) / server_.times().clock_hz;
    json["figures"]["its clock"] = fmt::format("{:.1f} s", time_s);
    if (!fast_) json["figures"]["of real time"] = fmt::format("{:.0f} %", 100 * server_.pace());
    json["figures"]["way"] = fmt::format("{:.0f} steps", way_);
    json["outputs"] = {{"bits", outputs_ & ((1U << kPwm) - 1)}, {"power", power()}};
    return json.dump();
}

}  // namespace curvecore::sysc
