// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/rest_plan.hpp"

#include <chrono>
#include <exception>
#include <utility>

#include "ref/machine/path_quantum.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace {

/// Time of the last change of a file; the least one: it is gone.
std::filesystem::file_time_type written(const std::string& file) {
    std::error_code gone;
    return std::filesystem::last_write_time(file, gone);
}

}  // namespace

RestPlan::RestPlan(Options options, Check check)
    : options_(std::move(options)),
      quantum_mm_(ref::path_quantum_mm(machine_of(options_), options_.unit_mm)),
      check_(std::move(check)),
      written_(written(options_.file)) {}

bool RestPlan::plan(const DrawnBefore& before, double percent) {
    if (plans()) return false;
    Options options = options_;
    options.from_mm += static_cast<double>(before.path) * quantum_mm_;
    options.override_percent = percent;
    planned_ = std::async(std::launch::async, [options, before] {
        auto words = std::make_unique<WordSource>(options, machine_of(options), before);
        words->settings();
        return words;
    });
    return true;
}

bool RestPlan::plans() const {
    return planned_.valid() &&
           planned_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

std::unique_ptr<WordSource> RestPlan::take() {
    if (plans()) return nullptr;
    try {
        std::unique_ptr<WordSource> rest = planned_.get();
        return written(options_.file) == written_ ? std::move(rest) : nullptr;
    } catch (const std::exception&) {
        return nullptr;
    }
}

bool RestPlan::fits(const WordSource& rest) const {
    try {
        check_(rest);
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

}  // namespace curvecore::sysc
