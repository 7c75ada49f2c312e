// SPDX-License-Identifier: Apache-2.0
#include "sysc/commands/part/planned_job.hpp"

#include "sysc/commands/terminal/device_clock.hpp"
#include "sysc/curves/word_check.hpp"

namespace curvecore::sysc {

Job plan_and_check(JobStream& stream) {
    take_device(stream.options());
    return stream.all(check_words);
}

}  // namespace curvecore::sysc
