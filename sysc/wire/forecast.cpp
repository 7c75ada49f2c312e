// SPDX-License-Identifier: Apache-2.0
#include "sysc/wire/forecast.hpp"

#include <exception>

#include "sysc/job/job_stream.hpp"

namespace curvecore::sysc {

Forecast::Forecast(const Options& options)
    : path_(machine_of(options)), thread_([this, options] { plan(options); }) {}

Forecast::~Forecast() {
    stop_ = true;
    thread_.join();
}

void Forecast::plan(Options options) {
    options.live = false;
    options.override_percent = 100;
    options.threads = 1;  // the plan that is drawn is due, this one is not
    try {
        JobStream stream(options);
        while (const ref::Plan* part = stream.next()) {
            if (stop_) return;
            path_.add(*part);
        }
        all_ = true;
    } catch (const std::exception&) {
        return;
    }
}

}  // namespace curvecore::sysc
