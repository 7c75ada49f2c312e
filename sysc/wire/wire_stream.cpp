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
/// Longest wait for a rest that is planned anew, by who resumed.
constexpr auto kFirstWords = std::chrono::seconds(3);
constexpr auto kStops = std::chrono::seconds(10);
constexpr std::uint64_t kNoRest = ~std::uint64_t{0};  // a rest that cannot be planned
constexpr int kStepPeriods = 4;  // from a sample that is taken to its last step

}  // namespace

WireStream::WireStream(RemoteMachine& machine, WordSource& words, WishQueue& wishes,
                       double override_rate, RestPlan* rest)
    : machine_(machine), words_(&words), rest_(rest), wishes_(wishes), wished_rate_(override_rate) {
    if (machine.live_period().count() > 0) awaits_ = std::min(awaits_, machine.live_period() / 2);
}

StreamEnd WireStream::run(const std::function<void()>& turn) {
    for (;;) {
        words_->take(planned_, awaits_);
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
        plan_rest();
        if (!meet_wishes()) return StreamEnd::kStopped;
        if (resumes_by_) resume();
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
    return next.pieces == pushed_.pieces && machine_.all_taken() && path() == next.wait.place &&
           !machine_.is(CURVECORE_STATE_ACTIVE_MASK);
}

void WireStream::look() {
    machine_.work();
    path_ = std::max(path_, begin_ + machine_.telemetry().path);
    words_->follow(path_, machine_.is(CURVECORE_STATE_ACTIVE_MASK) &&
                              !machine_.is(CURVECORE_STATE_STANDING_MASK));
    if (words_->raised() != raised_) set_rate(wished_rate_);
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
    const double rate = rate_that_link_carries(kOfLink * machine_.words_per_s(),
                                               static_cast<double>(planned_.busiest), link_rate_);
    if (rate == link_rate_) return;
    link_rate_ = rate;
    set_rate(wished_rate_);
}

void WireStream::set_rate(double wished) {
    wished_rate_ = wished;
    words_->raise(100 * wished);
    raised_ = words_->raised();
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
    const std::chrono::duration<double> time((periods + machine_.shaper_samples()) *
                                             build.sample_period_s);
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
                holds_ = true;
                resumes_by_.reset();
                break;
            case Wish::Kind::kResume:
                if (!resumes_by_) resumes_by_ = machine_.now() + kFirstWords;
                break;
            case Wish::Kind::kOverride:
                set_rate(wish->percent / 100.0);
                forget_rest();
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

/// Plans the rest anew, once the axes stand in a hold. Where the program rests or has waited itself
/// it goes on by time alone: that rest may be half over.
void WireStream::plan_rest() {
    const bool stands = machine_.all_taken() && machine_.is(CURVECORE_STATE_ACTIVE_MASK) &&
                        machine_.is(CURVECORE_STATE_HOLDING_MASK) &&
                        machine_.is(CURVECORE_STATE_STANDING_MASK);
    if (rest_ == nullptr || !holds_ || !stands) return;
    if (!rest_at_) {
        const bool rests = path_ == begin_ || path_ == waited_at_ || words_->path().rests_at(path_);
        const std::uint64_t held = planned_.segments.size() + planned_.pieces.size();
        if (!rests && rest_->plan(words_->drawn(path_, planned_.words - held), 100 * wished_rate_))
            rest_at_ = path_;
    } else if (rest_at_ == path_ && !next_ && !rest_->plans()) {
        next_ = rest_->take();
        if (!next_) rest_at_ = kNoRest;
    }
}

/// Ends a hold, or a wait for a person, once the rest is planned.
void WireStream::resume() {
    const bool fits = next_ && rest_at_ == path_ && rest_->fits(*next_);
    if (rest_at_ == path_ && !fits && machine_.now() < *resumes_by_) return;
    if (wait() != nullptr) {
        waited_at_ = wait()->place;
        planned_.waits.pop_front();
    }
    if (fits) {
        begin_rest();
    } else {
        machine_.hold(false);
    }
    waits_for_person_ = holds_ = false;
    forget_rest();
    resumes_by_.reset();
}

/// Lets the rest, planned anew, take the place of what the board has.
void WireStream::begin_rest() {
    empty_queues(true);
    look_until([this] { return machine_.telemetry().path == 0; });
    machine_.begin_here(next_->settings());
    anew_ = std::move(next_);
    words_ = anew_.get();
    begin_ = path_;
    planned_ = {};
    pushed_ = {};
    set_rate(wished_rate_);
}

void WireStream::forget_rest() {
    rest_at_.reset();
    next_.reset();
}

void WireStream::empty_queues(bool keep_outputs) {
    machine_.flush(keep_outputs);
    look_until([this] { return !machine_.is(CURVECORE_STATE_FLUSHING_MASK); });
}

/// Looks until this holds, for a while.
void WireStream::look_until(const std::function<bool()>& done) {
    machine_.finish();
    const WireClock::time_point end = machine_.now() + kStops;
    do {
        look();
    } while (!done() && machine_.now() < end);
}

void WireStream::stop() {
    machine_.hold(true);
    look_until([this] {
        return machine_.is(CURVECORE_STATE_STANDING_MASK) ||
               !machine_.is(CURVECORE_STATE_ACTIVE_MASK);
    });
    empty_queues(false);
}

}  // namespace curvecore::sysc
