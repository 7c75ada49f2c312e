// SPDX-License-Identifier: Apache-2.0
// The smallest configuration that is proven to keep a requirement.
#pragma once

#include <map>
#include <utility>

#include "sysc/choose/candidate.hpp"
#include "sysc/choose/clock_need.hpp"

namespace curvecore::sysc {

/// What a configuration fails by, or would with one bit less.
///
///   kAccuracy   no segment's derived bound is below the limit
///   kDataRate   the segments are more than the host can send
///   kLatency    integration steps take longer than the path through them at this clock
///   kClock      the sample rate needs more clocks, or the device does not reach the clock
///   kArea       the device is too small
///   kLeast      the parameter is the least that the cores have
enum class Reason { kNone, kAccuracy, kDataRate, kLatency, kClock, kArea, kLeast };

const char* reason_name(Reason reason);

/// | field     | unit | meaning                                                                  |
/// |-----------|------|--------------------------------------------------------------------------|
/// | candidate |      |                                                                          |
/// | demand    |      | bounds, segments and steps                                               |
/// | need      | Hz   | clocks that these need                                                   |
/// | clock_hz  | Hz   | there is: the requirement's, or the estimate less its error              |
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
    explicit Chooser(const Requirement& requirement)
        : requirement_(requirement), model_(requirement) {}

    /// Smallest first; each of the `count` needs a fifth less of the host or of the clock than the
    /// smaller ones; then the smallest of the other build. Empty: none keeps the requirement.
    std::vector<Choice> smallest(std::size_t count);

    /// Whether a configuration keeps the requirement; of a coarse choice of them, so that "no" may
    /// be wrong by a little.
    bool possible();

    /// kNone: it keeps the requirement.
    Reason judge(const Candidate& candidate, Choice& choice);

  private:
    /// The unit, and all that the samples depend on but the widths of Known.
    using Group = std::pair<double, std::vector<int>>;
    struct Known {
        int coef_bits, guard_bits;
        Load most;  // within which it was looked for
        Demand demand;
    };

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
