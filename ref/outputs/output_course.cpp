// SPDX-License-Identifier: Apache-2.0
#include "ref/outputs/output_course.hpp"

#include <algorithm>
#include <map>

namespace curvecore::ref {
namespace {

constexpr int kOn = 1;
constexpr int kCounterClockwise = 2;
constexpr int kMist = 4;
constexpr int kFlood = 8;
constexpr int kFirstOutput = 4;
constexpr int kOutputs = 4;

/// Bits that a code sets and clears; those of M62 to M65: of P0.
struct Switch {
    int set;
    int clear;
};
const std::map<std::string, Switch> kSwitches{
    {"M3", {kOn, kCounterClockwise}},
    {"M4", {kOn | kCounterClockwise, 0}},
    {"M5", {0, kOn | kCounterClockwise}},
    {"M7", {kMist, 0}},
    {"M8", {kFlood, 0}},
    {"M9", {0, kMist | kFlood}},
    {"M62", {1 << kFirstOutput, 0}},
    {"M63", {0, 1 << kFirstOutput}},
    {"M64", {1 << kFirstOutput, 0}},
    {"M65", {0, 1 << kFirstOutput}},
};

bool sets_level(const std::string& code, bool analog) {
    return analog ? code == "M67" || code == "M68" : code == "S";
}

}  // namespace

bool switches_outputs(const std::string& code, bool analog) {
    return sets_level(code, analog) || kSwitches.count(code) > 0;
}

/// Returns true if the next event is before this length.
bool OutputCourse::comes(const Events& events, double length) const {
    return taken_ < events.list().size() && events.list()[taken_].length < length;
}

/// Returns true if one of the next events before this length waits.
bool OutputCourse::stays(const Events& events, double length) const {
    for (std::size_t n = taken_; n < events.list().size() && events.list()[n].length < length; ++n)
        if (events.list()[n].waits) return true;
    return false;
}

Events::Event OutputCourse::take(const Events& events) { return events.list()[taken_++]; }

void OutputCourse::obey(const Events& events, const Events::Event& event) {
    const std::string& code = events.code_of(event);
    if (sets_level(code, rules_.full_q > 0)) asked_ = event.value;
    const auto known = kSwitches.find(code);
    if (known == kSwitches.end()) return;
    Switch change = known->second;
    if ((change.set | change.clear) == 1 << kFirstOutput) {
        if (event.value >= kOutputs) return;
        const int output = static_cast<int>(event.value);
        change = {change.set << output, change.clear << output};
    }
    bits_ = (bits_ & ~change.clear) | change.set;
}

OutputCourse::State OutputCourse::state(const Move& move) const {
    State state;
    state.bits = rules_.laser ? bits_ & ~kCounterClockwise : bits_;
    const bool analog = rules_.full_q > 0;
    const bool off = (bits_ & kOn) == 0 && (rules_.laser || !analog);
    const bool dark = off || (rules_.laser && move.rapid);
    state.level = dark ? 0 : std::clamp(asked_ / (analog ? rules_.full_q : rules_.full), 0.0, 1.0);
    const bool follows = rules_.laser && (bits_ & kCounterClockwise) != 0;
    state.follow = rules_.laser && rules_.dark_at_rest ? kAtAnyButRest : kAtAnySpeed;
    if (follows && !move.rapid) state.follow = move.feed;
    if (follows && move.rapid && given_) state.follow = given_->follow;
    return state;
}

void OutputCourse::note(std::vector<Change>& changes, const State& state, double share,
                        Behind behind, int line) {
    if (!given_ || state.bits != given_->bits) {
        changes.push_back({OutputKind::kBits, double(state.bits), share, behind, line});
    }
    if (!given_ || state.follow != given_->follow) {
        changes.push_back({OutputKind::kFollow, state.follow, share, behind, line});
    }
    if (!given_ || state.level != given_->level) {
        changes.push_back({OutputKind::kLevel, state.level, share, behind, line});
    }
    given_ = state;
}

std::vector<OutputCourse::Change> OutputCourse::next(const Move& move, const Events& events) {
    std::vector<Change> changes;
    begin(move, events, changes);
    const double length = move.to - move.from;
    while (comes(events, move.to - kSamePlace)) {
        const Events::Event event = take(events);
        obey(events, event);
        note(changes, state(move), (event.length - move.from) / length, {waits_}, event.line);
    }
    return changes;
}

/// Notes what is asked for where a move begins.
void OutputCourse::begin(const Move& move, const Events& events, std::vector<Change>& changes) {
    while (comes(events, move.from - kLeftOut)) obey(events, take(events));
    const bool stays_here = stays(events, move.from + kSamePlace);
    Behind behind{waits_};
    while (comes(events, move.from + kSamePlace)) {
        const Events::Event event = take(events);
        const bool dwell = event.rest > 0 && !stays_here;
        if (event.waits || dwell != behind.dwell) {
            note(changes, state(move), 0, behind, event.line);
            waits_ += event.waits ? 1 : 0;
            behind = {waits_, dwell};
        }
        obey(events, event);
    }
    note(changes, state(move), 0, behind, move.line);
}

std::vector<OutputCourse::Change> OutputCourse::end(const Events& events) {
    std::vector<Change> changes;
    int line = 0;
    while (taken_ < events.list().size()) {
        const Events::Event event = take(events);
        obey(events, event);
        line = event.line;
    }
    State state;
    state.bits = bits_ & ~((1 << kFirstOutput) - 1);
    note(changes, state, 1, {waits_}, line);
    return changes;
}

}  // namespace curvecore::ref
