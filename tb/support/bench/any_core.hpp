// SPDX-License-Identifier: Apache-2.0
// A Verilated core behind its ports, of any widths: a bench is compiled once for all
// configurations, each of which adds its model (curve_model.cpp, motion_model.cpp).
#pragma once

#include <cstdint>
#include <memory>

#include "tb/support/bench/core_configuration.hpp"

namespace curvecore::tb {

constexpr int kPortAxes = 3 + ref::parameter_of(&ref::CoreParameters::aux_axes).high;

/// The core; Ports is a struct with the names of the module's ports, and rst_ni. Used as ClockedDut
/// is.
template <class Ports>
class AnyCore {
  public:
    class Model {
      public:
        virtual ~Model() = default;
        virtual void settle(Ports& ports) = 0;
        virtual void tick(Ports& ports) = 0;
        virtual uint64_t cycle() const = 0;
        virtual void limit_cycles(uint64_t limit) = 0;
    };

    /// Registers without a reset start with random bits that depend on the seed.
    explicit AnyCore(int seed = 1) : model_(make_model(seed)) {}

    Ports* operator->() { return &ports_; }
    const Ports* operator->() const { return &ports_; }

    void settle() { model_->settle(ports_); }
    void tick(uint64_t cycles = 1) {
        while (cycles-- > 0) model_->tick(ports_);
    }
    void reset(uint64_t edges = 2) {
        ports_.rst_ni = 0;
        tick(edges);
        ports_.rst_ni = 1;
        settle();
    }
    uint64_t cycle() const { return model_->cycle(); }
    void limit_cycles(uint64_t limit) { model_->limit_cycles(limit); }

  private:
    static std::unique_ptr<Model> make_model(int seed);

    Ports ports_;
    std::unique_ptr<Model> model_;
};

}  // namespace curvecore::tb
