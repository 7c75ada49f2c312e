// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/wire_stream.hpp"

#include <algorithm>
#include <cmath>

#include "hls/registers/registers.h"

namespace curvecore::sysc {
namespace {

/// Faults that turn the machine off, or lose its words.
constexpr std::uint32_t kEnds = CURVECORE_FAULTS & ~CURVECORE_STATE_WATCHDOG_MASK;
/// Faults that turn the machine off. It then refuses words under way, which is no fault of theirs.
constexpr std::uint32_t kOff = kEnds & ~(CURVECORE_STATE_BUS_MASK | CURVECORE_STATE_MOTION_MASK);
/// Share of a link's words a second that is used; the rest is for repetitions.
constexpr double kOfLink = 0.9;
constexpr auto kStops = std::chrono::seconds(10);
constexpr int kStepPeriods = 4;  // from a sample that is taken to its last step

}  // namespace

WireStream::WireStream(RemoteMachine& machine, WordSource& words, WishQueue& wishes,
                       double override_rate)
    : machine_(machine), words_(words), wishes_(wishes), wished_rate_(override_rate) {}

StreamEnd WireStream::run(const std::function<void()>& turn) {
    for (;;) {
        words_.take(planned_);
        keep_to_link();
        push();
        look();
        if (machine_.is(kEnds)) return StreamEnd::kFault;
        if (machine_.is(CURVECORE_STATE_CAUGHT_MASK)) return StreamEnd::kCaught;
        if (machine_.is(CURVECORE_STATE_WATCHDOG_MASK)) machine_.clear_watchdog();
        if (drawn()) {
            settle();
            return StreamEnd::kDone;
        }
        if (!waits_for_person_ && at_wait()) {
            settle();
            waits_for_person_ = true;
        }
        if (!meet_wishes()) return StreamEnd::kStopped;
        turn();
    }
}

/// Sends words up to the next wait for a person: the board takes the rest as another program.
void WireStream::push() {
    for (;;) {
        RemoteMachine::WordCounts most{planned_.segments.size(), planned_.pieces.size()};
        if (!planned_.waits.empty()) {
            const WaitWord& wait = planned_.waits.front();
            most = {wait.segments - pushed_.segments, wait.pieces - pushed_.pieces};
        }
        const auto [segments, pieces] = machine_.push(planned_.segments, planned_.pieces, most);
        if (segments + pieces == 0) return;
        pushed_.segments += segments;
        pushed_.pieces += pieces;
    }
}

/// Returns true if all that comes before the next wait for a person is drawn.
bool WireStream::at_wait() const {
    if (planned_.waits.empty()) return false;
    const WaitWord& next = planned_.waits.front();
    return next.pieces == pushed_.pieces && machine_.all_taken() &&
           machine_.telemetry().path == next.wait.place &&
           !machine_.is(CURVECORE_STATE_ACTIVE_MASK);
}

void WireStream::look() {
    machine_.work();
    path_ = std::max(path_, machine_.telemetry().path);
    words_.follow(path_, machine_.is(CURVECORE_STATE_ACTIVE_MASK) &&
                             !machine_.is(CURVECORE_STATE_STANDING_MASK));
    if (words_.raised() != raised_) set_rate(wished_rate_);
    faults_ = (faults_ & CURVECORE_FAULTS) |
              (machine_.telemetry().state & (CURVECORE_FAULTS | CURVECORE_STATE_FAULT_AXIS_MASK));
    if ((faults_ & kOff) != 0) faults_ &= ~CURVECORE_STATE_BUS_MASK;
    held_ = held_ || machine_.is(CURVECORE_STATE_HOLDING_MASK | CURVECORE_STATE_UNDERRUN_MASK);
    see_waits();
}

/// Notes where the board waited. UNDERRUN is sticky: it reports the first time, and then a program
/// that stands without a hold.
void WireStream::see_waits() {
    const bool first = waits_.empty() && machine_.is(CURVECORE_STATE_UNDERRUN_MASK);
    const bool stands =
        machine_.is(CURVECORE_STATE_UNDERRUN_MASK) && machine_.is(CURVECORE_STATE_ACTIVE_MASK) &&
        machine_.is(CURVECORE_STATE_STANDING_MASK) && !machine_.is(CURVECORE_STATE_HOLDING_MASK);
    if (first || (stands && !waiting_)) waits_.push_back(path_);
    waiting_ = first || stands;
}

/// Limits the rate of time to the rate of words.
void WireStream::keep_to_link() {
    const double carried = kOfLink * machine_.words_per_s();
    const auto busiest = static_cast<double>(planned_.busiest);
    if (carried == 0 || busiest * link_rate_ <= carried) return;
    link_rate_ = carried / busiest;
    set_rate(wished_rate_);
}

void WireStream::set_rate(double wished) {
    wished_rate_ = wished;
    words_.raise(100 * wished);
    raised_ = words_.raised();
    const double rate = std::min(wished_rate_ / raised_, link_rate_);
    machine_.set_override(std::clamp(static_cast<int>(std::lround(rate * 65536)), 1, 65536));
}

bool WireStream::drawn() const {
    return planned_.all && planned_.segments.empty() && planned_.pieces.empty() &&
           path() == planned_.path && !machine_.is(CURVECORE_STATE_ACTIVE_MASK);
}

/// Waits for the steps of the samples that are made ahead, also on a board whose clock goes on with
/// frames alone, some quarter of a period with each question.
void WireStream::settle() {
    const RemoteBuild& build = machine_.build();
    const double periods = CURVECORE_FIELD(build.widths, WIDTHS_SAMPLES_AHEAD) + kStepPeriods;
    const std::chrono::duration<double> time(periods * build.sample_period_s);
    const WireClock::time_point end =
        machine_.now() + std::chrono::duration_cast<WireClock::duration>(time);
    while (machine_.now() < end) look();
    for (int n = 0; n < 2 * periods; ++n) machine_.steps();
}

/// Carries out wishes. Returns false if one of them ended the program.
bool WireStream::meet_wishes() {
    while (const std::optional<Wish> wish = wishes_.next()) {
        switch (wish->kind) {
            case Wish::Kind::kHold:
                machine_.hold(true);
                break;
            case Wish::Kind::kResume:
                machine_.hold(false);
                if (wait() != nullptr) planned_.waits.pop_front();
                waits_for_person_ = false;
                break;
            case Wish::Kind::kOverride:
                set_rate(wish->percent / 100.0);
                break;
            case Wish::Kind::kStop:
                stop();
                return false;
            case Wish::Kind::kEstop:
                machine_.estop();
                break;
        }
    }
    return true;
}

void WireStream::stop() {
    const auto until = [this](auto done) {
        machine_.finish();
        const WireClock::time_point end = machine_.now() + kStops;
        do {
            look();
        } while (!done() && machine_.now() < end);
    };
    machine_.hold(true);
    until([this] {
        return machine_.is(CURVECORE_STATE_STANDING_MASK) ||
               !machine_.is(CURVECORE_STATE_ACTIVE_MASK);
    });
    machine_.flush();
    until([this] { return !machine_.is(CURVECORE_STATE_FLUSHING_MASK); });
}

}  // namespace curvecore::sysc
