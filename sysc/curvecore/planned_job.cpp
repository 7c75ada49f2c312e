// SPDX-License-Identifier: Apache-2.0
#include "sysc/curvecore/planned_job.hpp"

#include "sysc/curvecore/device_clock.hpp"
#include "sysc/widths/word_check.hpp"

namespace curvecore::sysc {

void plan_and_check(Job& job) {
    take_device(job.options);
    plan_job(job);
    check_words(job);
}

}  // namespace curvecore::sysc
