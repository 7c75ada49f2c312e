// SPDX-License-Identifier: Apache-2.0
// A Verilated module with one clock: clock, reset, trace and a limit on cycles. It knows no
// protocol.
//
//     ClockedDut<Vriemann_integrator> dut;
//     dut.reset();
//     dut->load_i = 1;          // inputs change while the clock is low ...
//     dut.settle();             // ... outputs that depend on them without a register follow ...
//     dut.tick();               // ... and one rising edge takes them.
#pragma once

#include <unistd.h>
#include <verilated.h>
#include <verilated_fst_c.h>
#if VM_COVERAGE
#include <verilated_cov.h>
#endif

#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

namespace curvecore::sysc {

template <class Model>
class ClockedDut {
  public:
    /// Registers without a reset start with random bits that depend on the seed.
    explicit ClockedDut(int seed = 1) {
        context_.randReset(2);
        context_.randSeed(seed);
        model_ = std::make_unique<Model>(&context_, "dut");
        model_->clk_i = 0;
        model_->eval();  // the clock's first edge needs a level before it
    }

    ClockedDut(const ClockedDut&) = delete;
    ClockedDut& operator=(const ClockedDut&) = delete;

    ~ClockedDut() {
        if (trace_) trace_->close();
        model_->final();
#if VM_COVERAGE
        const std::string file = "coverage." + std::to_string(getpid()) + ".dat";
        context_.coveragep()->write(file.c_str());
#endif
    }

    Model* operator->() { return model_.get(); }
    const Model* operator->() const { return model_.get(); }
    Model& operator*() { return *model_; }

    /// Lets outputs follow inputs within the cycle.
    void settle() { model_->eval(); }

    /// Advances by one rising edge. @throws std::runtime_error past the limit on cycles
    void tick() {
        rise();
        fall();
    }

    /// Does the halves of tick(), for speed: inputs that change before fall() need no settle().
    void rise() {
        if (++cycle_ > cycle_limit_) {
            throw std::runtime_error("the limit of " + std::to_string(cycle_limit_) +
                                     " cycles is reached");
        }
        model_->clk_i = 1;
        eval_half();
    }
    void fall() {
        model_->clk_i = 0;
        eval_half();
    }

    void tick(uint64_t cycles) {
        while (cycles-- > 0) tick();
    }

    /// Holds the reset for two edges, which suffice for every module; a core needs only one.
    void reset(uint64_t edges = 2) {
        model_->rst_ni = 0;
        tick(edges);
        model_->rst_ni = 1;
        settle();
    }

    uint64_t cycle() const { return cycle_; }
    void limit_cycles(uint64_t limit) { cycle_limit_ = limit; }

    /// Writes an FST waveform from now on, in picoseconds; the model must be built with TRACE.
    void trace_to(const std::string& file, double clock_hz) {
        half_ps_ = 0.5e12 / clock_hz;
        context_.traceEverOn(true);
        trace_ = std::make_unique<VerilatedFstC>();
        model_->trace(trace_.get(), 99);
        trace_->open(file.c_str());
    }

    /// Closes the waveform; the run goes on without it.
    void stop_trace() {
        if (trace_) trace_->close();
        trace_.reset();
    }

  private:
    void eval_half() {
        model_->eval();
        if (trace_) {
            const double time = static_cast<double>(context_.time()) * half_ps_;
            trace_->dump(static_cast<uint64_t>(std::llround(time)));
        }
        context_.timeInc(1);
    }

    VerilatedContext context_;
    std::unique_ptr<Model> model_;
    std::unique_ptr<VerilatedFstC> trace_;
    double half_ps_ = 0;  // half a clock, ps
    uint64_t cycle_ = 0;
    uint64_t cycle_limit_ = 1'000'000'000;
};

}  // namespace curvecore::sysc
