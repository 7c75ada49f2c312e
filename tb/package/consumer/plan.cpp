// SPDX-License-Identifier: Apache-2.0
// The program plan FILE: plans a program for the default core, and prints the plan's figures.
#include <cstdio>

#include "hls/interpolator_kernel.hpp"
#include "sysc/job/job.hpp"

int main(int, char** argv) {
    curvecore::sysc::Options options;
    options.file = argv[1];
    const curvecore::sysc::Job job = curvecore::sysc::plan_job(options);
    std::printf("%zu segments, bound %.3f\n", job.plan.segments.size(), job.bound());

    using Kernel =
        curvecore::hls::InterpolatorKernel<curvecore::hls::DefaultConfiguration>;  // draws them
    return sizeof(Kernel) == 0;
}
