// SPDX-License-Identifier: Apache-2.0
// One core of compiled_cores.cmake: compiled once per line of that table, with its Verilated model.
#include <thread>

#include "tb/program/rtl_bench.hpp"
#include "tb/support/core_configuration.hpp"
#include CFG_HEADER

namespace curvecore::tb {
namespace {

using C = Config;
using Bench = RtlBench<C, CFG_MODEL>;

/// Simulation in this thread, checks and samples.csv in another.
RtlResult run(const RtlRun& setup) {
    std::vector<hls::SegmentWords<C>> segments;
    segments.reserve(setup.job.plan.segments.size());
    for (const ref::Segment& segment : setup.job.plan.segments) {
        segments.push_back(hls::to_words<C>(segment));
    }
    Checker<C> checker(setup.job, segments, setup.writer, setup.pictures);
    Bench bench(setup, segments);
    Channel<Bench::Batch> channel(16);
    std::exception_ptr check_failure;
    std::thread check([&] {
        try {
            while (const auto batch = channel.pop()) {
                for (const RtlSample<C>& sample : *batch) checker.take(sample);
            }
        } catch (...) {
            check_failure = std::current_exception();
            channel.close();
        }
    });
    RtlResult result;
    std::exception_ptr bench_failure;
    try {
        result = bench.run(channel);
    } catch (...) {
        bench_failure = std::current_exception();
    }
    channel.close();
    check.join();
    if (check_failure) std::rethrow_exception(check_failure);
    if (bench_failure) std::rethrow_exception(bench_failure);
    result.check = checker.result();
    return result;
}

}  // namespace

CompiledCore CFG_FUNCTION() {
    CoreParameters parameters;
    parameters.build = static_cast<Build>(CFG_Build);
    parameters.order = CFG_Order;
    parameters.coef_bits = CFG_CoefBits;
    parameters.position_bits = CFG_PositionBits;
    parameters.guard_bits = CFG_GuardBits;
    parameters.aux_axes = CFG_AuxAxes;
    parameters.splines = CFG_Splines;
    parameters.mode = CFG_Mode;
    parameters.sample_interval = CFG_SampleInterval;
    parameters.turn_bits = CFG_TurnBits;
    parameters.parameter_guard = CFG_ParameterGuard;
    return {parameters, &run};
}

}  // namespace curvecore::tb
