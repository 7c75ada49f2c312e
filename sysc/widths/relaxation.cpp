// SPDX-License-Identifier: Apache-2.0
#include "tb/choose/concession.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tb/choose/chooser.hpp"

namespace curvecore::tb {
namespace {

constexpr double kFarthest = 1e4;    // times what was asked, or one part of so many
constexpr double kPrecision = 1.05;  // of a factor

using Change = std::function<void(Wish& wish, double factor)>;

bool possible(const Wish& wish) { return Chooser(wish).possible(); }

/// The factor nearest to 1 between 1 and `farthest` with which the wish is possible; 0: none is.
/// Farther away another limit may hold again, so the search goes out step by step.
double nearest(const Wish& wish, double farthest, const Change& change) {
    const auto with = [&](double factor) {
        Wish changed = wish;
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
    while (std::abs(std::log(good / bad)) > std::log(kPrecision)) {
        const double middle = std::sqrt(good * bad);
        (with(middle) ? good : bad) = middle;
    }
    return good;
}

/// Of a size, and of the travel with it, as far as the `other` size lets it.
Change reach(double Wish::*size, double Wish::*other) {
    return [size, other](Wish& wish, double factor) {
        const double spare = wish.travel_mm / (wish.*size);
        wish.*size *= factor;
        wish.travel_mm = std::max(spare * (wish.*size), wish.*other);
    };
}

class Search {
  public:
    explicit Search(const Wish& wish) : wish_(wish) {}

    void number(const char* name, double asked, double farthest, const Change& change,
                const std::function<std::string(double)>& text) {
        const double factor = nearest(wish_, farthest, change);
        if (factor == 0) return;
        // Rounded to three digits away from what was asked, so that what is said is possible.
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
            Wish other = wish_;
            other.device = &device;
            const bool smaller = best == nullptr || device.lut4 < best->lut4;
            if (&device != wish_.device && smaller && possible(other)) best = &device;
        }
        if (best == nullptr) return;
        found_.push_back({"device", static_cast<double>(wish_.device->lut4),
                          static_cast<double>(best->lut4),
                          fmt::format("device {} instead of {}", best->name, wish_.device->name)});
    }

    void unit() {
        if (!wish_.unit_mm) return;
        Wish other = wish_;
        for (const double unit : kUnits) {
            other.unit_mm = unit;
            if (!possible(other)) continue;
            found_.push_back(
                {"unit", *wish_.unit_mm, unit,
                 fmt::format("unit {} instead of {}", unit_text(unit), unit_text(*wish_.unit_mm))});
            return;
        }
    }

    /// What the smallest core needs, or reaches.
    void clock() {
        if (!wish_.clock_hz) return;
        Wish other = wish_;
        other.clock_hz.reset();
        const std::vector<Choice> any = Chooser(other).smallest(1);
        if (any.empty()) return;
        const double asked = *wish_.clock_hz;
        const bool slower = asked > any.front().clock_hz;
        const double possible = slower ? any.front().clock_hz : any.front().need.least();
        found_.push_back({"clock", asked, possible,
                          fmt::format("clock {} instead of {}", frequency_text(possible),
                                      frequency_text(asked))});
    }

    std::vector<Concession> found() { return std::move(found_); }

  private:
    const Wish& wish_;
    std::vector<Concession> found_;
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

std::string unit_text(double mm) {
    return mm > 5e-4 ? "1um" : mm > 5e-5 ? "0.1um" : mm > 5e-6 ? "10nm" : "1nm";
}

std::string feed_text(double mm_per_s) {
    return scaled(mm_per_s * 60, {{1e3, "m/min"}, {1, "mm/min"}});
}

std::string frequency_text(double hz) {
    return scaled(hz, {{1e6, "MHz"}, {1e3, "kHz"}, {1, "Hz"}});
}

std::vector<Concession> concessions(const Wish& wish) {
    Search search(wish);
    search.number(
        "error", wish.error_mm, kFarthest,
        [](Wish& other, double factor) { other.error_mm *= factor; }, length_text);
    search.unit();
    if (wish.arcs()) {
        search.number("radius", wish.radius_mm,
                      std::max(1 / kFarthest, wish.least_radius_mm / wish.radius_mm),
                      reach(&Wish::radius_mm, &Wish::length_mm), length_text);
    }
    if (wish.splines()) {
        search.number("length", wish.length_mm, 1 / kFarthest,
                      reach(&Wish::length_mm, &Wish::radius_mm), length_text);
    }
    if (wish.arcs()) {
        search.number(
            "least radius", wish.least_radius_mm, wish.radius_mm / wish.least_radius_mm,
            [](Wish& other, double factor) { other.least_radius_mm *= factor; }, length_text);
    }
    search.number(
        "feed", wish.feed, 1 / kFarthest, [](Wish& other, double factor) { other.feed *= factor; },
        feed_text);
    search.number(
        "sample rate", 1 / wish.sample_period_s, 1 / kFarthest,
        [](Wish& other, double factor) { other.sample_period_s /= factor; }, frequency_text);
    search.clock();
    search.number(
        "host words", wish.host_words, kFarthest,
        [](Wish& other, double factor) { other.host_words *= factor; },
        [](double words) { return fmt::format("{:.4g}/s", words); });
    search.device();
    return search.found();
}

}  // namespace curvecore::tb
