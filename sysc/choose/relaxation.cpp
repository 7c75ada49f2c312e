// SPDX-License-Identifier: Apache-2.0
#include "sysc/choose/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sysc/choose/chooser.hpp"
#include "sysc/cli/quantity.hpp"

namespace curvecore::sysc {
namespace {

constexpr double kMostFactor = 1e4;        // factor on the asked value, or its inverse
constexpr double kFactorPrecision = 1.05;  // of a factor, relative

using Change = std::function<void(Requirement& requirement, double factor)>;

bool possible(const Requirement& requirement) { return Chooser(requirement).possible(); }

/// Returns the factor nearest to 1, between 1 and `farthest`, with which the requirement is
/// possible; 0 if there is none. Farther out another limit may bind again, so the search goes out
/// step by step.
double nearest(const Requirement& requirement, double farthest, const Change& change) {
    const auto with = [&](double factor) {
        Requirement changed = requirement;
        change(changed, factor);
        return possible(changed);
    };
    const double out = farthest > 1 ? 4 : 0.25;
    const auto clamped = [&](double factor) {
        return farthest > 1 ? std::min(factor, farthest) : std::max(factor, farthest);
    };
    double bad = 1;
    double good = clamped(out);
    while (!with(good)) {
        if (good == farthest) return 0;
        bad = good;
        good = clamped(good * out);
    }
    while (std::abs(std::log(good / bad)) > std::log(kFactorPrecision)) {
        const double middle = std::sqrt(good * bad);
        (with(middle) ? good : bad) = middle;
    }
    return good;
}

/// Changes a size, and the travel with it, as far as the `other` size allows.
Change reach(double Requirement::*size, double Requirement::*other) {
    return [size, other](Requirement& requirement, double factor) {
        const double spare = requirement.travel_mm / (requirement.*size);
        requirement.*size *= factor;
        requirement.travel_mm = std::max(spare * (requirement.*size), requirement.*other);
    };
}

class Search {
  public:
    explicit Search(const Requirement& requirement) : requirement_(requirement) {}

    void number(const char* name, double asked, double farthest, const Change& change,
                const std::function<std::string(double)>& text) {
        const double factor = nearest(requirement_, farthest, change);
        if (factor == 0) return;
        // Rounded to three digits away from the asked value, so that the reported value is
        // possible.
        const double exact = asked * factor;
        const double digit = std::pow(10.0, std::floor(std::log10(exact)) - 2);
        const double said =
            (factor > 1 ? std::ceil(exact / digit) : std::floor(exact / digit)) * digit;
        found_.push_back({name, asked, said,
                          fmt::format("{} {} instead of {} ({:.3g} %)", name, text(said),
                                      text(asked), 100 * said / asked)});
    }

    void device() {
        const Device* best = nullptr;
        for (const Device& device : kDevices) {
            Requirement other = requirement_;
            other.device = &device;
            if (!requirement_.clock_hz && !clock_is_known(device)) continue;
            const bool smaller = best == nullptr || device.lut4 < best->lut4;
            if (&device != requirement_.device && smaller && possible(other)) best = &device;
        }
        if (best == nullptr) return;
        found_.push_back(
            {"device", static_cast<double>(requirement_.device->lut4),
             static_cast<double>(best->lut4),
             fmt::format("device {} instead of {}", best->name, requirement_.device->name)});
    }

    void unit() {
        if (!requirement_.unit_mm) return;
        Requirement other = requirement_;
        for (const double unit : kUnits) {
            other.unit_mm = unit;
            if (!possible(other)) continue;
            found_.push_back({"unit", *requirement_.unit_mm, unit,
                              fmt::format("unit {} instead of {}", exact_length(unit),
                                          exact_length(*requirement_.unit_mm))});
            return;
        }
    }

    /// Adds the clock that the smallest core needs, or reaches.
    void clock() {
        if (!requirement_.clock_hz) return;
        if (!clock_is_known(*requirement_.device)) {
            number(
                "clock", *requirement_.clock_hz, kMostFactor,
                [](Requirement& other, double factor) { *other.clock_hz *= factor; },
                frequency_text);
            return;
        }
        Requirement other = requirement_;
        other.clock_hz.reset();
        const std::vector<Choice> any = Chooser(other).smallest(1);
        if (any.empty()) return;
        const double asked = *requirement_.clock_hz;
        const bool slower = asked > any.front().clock_hz;
        const double possible = slower ? any.front().clock_hz : any.front().need.least();
        found_.push_back({"clock", asked, possible,
                          fmt::format("clock {} instead of {}", frequency_text(possible),
                                      frequency_text(asked))});
    }

    std::vector<Relaxation> found() { return std::move(found_); }

  private:
    const Requirement& requirement_;
    std::vector<Relaxation> found_;
};

std::string scaled(double value, const std::vector<std::pair<double, const char*>>& units) {
    for (const auto& [size, name] : units) {
        if (value >= size * (1 - 5e-5)) return fmt::format("{:.4g} {}", value / size, name);
    }
    return fmt::format("{:.4g} {}", value / units.back().first, units.back().second);
}

}  // namespace

std::string length_text(double mm) {
    return scaled(mm, {{1e3, "m"}, {1, "mm"}, {1e-3, "um"}, {1e-6, "nm"}});
}

std::string feed_text(double mm_per_s) {
    return scaled(mm_per_s * 60, {{1e3, "m/min"}, {1, "mm/min"}});
}

std::string frequency_text(double hz) {
    return scaled(hz, {{1e6, "MHz"}, {1e3, "kHz"}, {1, "Hz"}});
}

std::vector<Relaxation> relaxations(const Requirement& requirement,
                                    const std::function<void(int)>& tried) {
    Search search(requirement);
    std::vector<std::function<void()>> searches;
    const auto number = [&](const char* name, double asked, double farthest, const Change& change,
                            const std::function<std::string(double)>& text) {
        searches.emplace_back([=, &search] { search.number(name, asked, farthest, change, text); });
    };
    number(
        "error", requirement.error_mm, kMostFactor,
        [](Requirement& other, double factor) { other.error_mm *= factor; }, length_text);
    searches.emplace_back([&] { search.unit(); });
    if (requirement.arcs()) {
        number("radius", requirement.radius_mm,
               std::max(1 / kMostFactor, requirement.least_radius_mm / requirement.radius_mm),
               reach(&Requirement::radius_mm, &Requirement::length_mm), length_text);
    }
    if (requirement.splines()) {
        number("length", requirement.length_mm, 1 / kMostFactor,
               reach(&Requirement::length_mm, &Requirement::radius_mm), length_text);
    }
    if (requirement.arcs()) {
        number(
            "least radius", requirement.least_radius_mm,
            requirement.radius_mm / requirement.least_radius_mm,
            [](Requirement& other, double factor) { other.least_radius_mm *= factor; },
            length_text);
    }
    number(
        "feed", requirement.feed, 1 / kMostFactor,
        [](Requirement& other, double factor) { other.feed *= factor; }, feed_text);
    number(
        "sample rate", 1 / requirement.sample_period_s, 1 / kMostFactor,
        [](Requirement& other, double factor) { other.sample_period_s /= factor; }, frequency_text);
    searches.emplace_back([&] { search.clock(); });
    number(
        "host words", requirement.host_words, kMostFactor,
        [](Requirement& other, double factor) { other.host_words *= factor; },
        [](double words) { return fmt::format("{:.4g}/s", words); });
    searches.emplace_back([&] { search.device(); });
    for (std::size_t n = 0; n < searches.size(); ++n) {
        searches[n]();
        tried(static_cast<int>(100 * (n + 1) / searches.size()));
    }
    return search.found();
}

}  // namespace curvecore::sysc
