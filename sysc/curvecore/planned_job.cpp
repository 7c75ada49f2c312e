// SPDX-License-Identifier: Apache-2.0
#include "sysc/curvecore/planned_job.hpp"

#include "sysc/curvecore/device_clock.hpp"
#include "sysc/curves/word_check.hpp"

namespace curvecore::sysc {

Job plan_and_check(JobStream& stream) {
    take_device(stream.options());
    return stream.all(check_words);
}

}  // namespace curvecore::sysc
