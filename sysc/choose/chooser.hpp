// SPDX-License-Identifier: Apache-2.0
// Search for the smallest configuration that is proven to meet a requirement.
#pragma once

#include <map>
#include <utility>

#include "sysc/choose/candidate.hpp"
#include "sysc/choose/clock_need.hpp"

namespace curvecore::sysc {

/// Reason why a configuration fails, or would fail with one bit less.
///
///   kAccuracy   no segment's derived bound is below the limit
///   kDataRate   there are more segments than the host can send
///   kLatency    integration steps take longer than the path through them at this clock
///   kClock      the sample rate needs more clocks, or the device does not reach the clock
///   kArea       the device is too small
///   kLeast      the parameter has the least value that the cores allow
enum class Reason { kNone, kAccuracy, kDataRate, kLatency, kClock, kArea, kLeast };

const char* reason_name(Reason reason);

/// | field     | unit | meaning                                                                  |
/// |-----------|------|--------------------------------------------------------------------------|
/// | candidate |      |                                                                          |
/// | demand    |      | bounds, segments and steps                                               |
/// | need      | Hz   | clocks that the demand needs                                             |
/// | clock_hz  | Hz   | clock available: the requirement's, or the estimate less its error       |
/// | binds     |      | what keeps each parameter from being smaller by one                      |
struct Choice {
    Candidate candidate;
    Demand demand;
    ClockNeed need;
    double clock_hz = 0;
    std::vector<std::pair<const char*, Reason>> binds;
};

class Chooser {
  public:
    /// Its clock_hz is given where the device's clock is not known.
    explicit Chooser(const Requirement& requirement)
        : requirement_(requirement), model_(requirement) {}

    /// Returns up to `count` choices, smallest first, each of which needs a fifth less of the host
    /// or of the clock than the smaller ones; then the smallest of the other build. Empty: none
    /// meets the requirement.
    std::vector<Choice> smallest(std::size_t count);

    /// Returns true if a configuration meets the requirement. Only a coarse subset is tried, so
    /// "no" may be slightly wrong.
    bool possible();

    /// Judges a candidate; kNone: it meets the requirement.
    Reason judge(const Candidate& candidate, Choice& choice);

  private:
    /// The unit, and all parameters that the samples depend on but the widths of Known.
    using Group = std::pair<double, std::vector<int>>;
    struct Known {
        int coef_bits, guard_bits;
        Load most;  // load within which the search was made
        Demand demand;
    };

    double fastest(const Candidate& candidate) const;
    static Group group(const Candidate& candidate);
    Load most_load(const Candidate& candidate, double clock_hz) const;
    const Demand& demand(const Candidate& candidate, const Load& most);
    bool hopeless(const Candidate& candidate, const Load& most);
    void find_binds(Choice& choice);

    const Requirement requirement_;
    const DemandModel model_;
    std::map<Group, std::vector<Known>> known_;
};

}  // namespace curvecore::sysc
