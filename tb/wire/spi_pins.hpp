// SPDX-License-Identifier: Apache-2.0
// SPI to the pins of a Verilated board, 12 clocks a bit. The clock runs with SPI's: a board without
// requests stands still.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sysc/cores/clocked_dut.hpp"
#include "sysc/link/spi_link.hpp"

namespace curvecore::sysc {

constexpr int kHalfBit = 6;  // clocks

/// Steps: clock, axis, direction.
using Steps = std::vector<std::array<std::int64_t, 3>>;

template <class Dut>
class SpiPins : public SpiBus {
  public:
    explicit SpiPins(Steps& steps) : steps_(steps) {
        dut_.limit_cycles(~std::uint64_t(0));
        dut_->cs_ni = 1;
        dut_->sclk_i = 0;
        dut_->mosi_i = 0;
        dut_.reset();
    }

    Bytes exchange(const Bytes& bytes) override {
        Bytes came;
        dut_->cs_ni = 0;
        for (const std::uint8_t byte : bytes) {
            unsigned in = 0;
            for (int bit = 7; bit >= 0; --bit) {
                dut_->mosi_i = byte >> bit & 1;
                pass(kHalfBit);
                in = in << 1 | dut_->miso_o;
                dut_->sclk_i = 1;
                pass(kHalfBit);
                dut_->sclk_i = 0;
            }
            came.push_back(static_cast<std::uint8_t>(in));
        }
        pass(kHalfBit);
        dut_->cs_ni = 1;
        pass(kHalfBit);
        return came;
    }

    std::uint64_t clock() const { return dut_.cycle(); }

  private:
    void pass(int clocks) {
        for (; clocks > 0; --clocks) {
            dut_.tick();
            const unsigned rises = dut_->step_o & ~level_;
            level_ = dut_->step_o;
            for (int axis = 0; rises >> axis != 0; ++axis) {
                if ((rises >> axis & 1) == 0) continue;
                const int way = (dut_->direction_o >> axis & 1) != 0 ? -1 : 1;
                steps_.push_back({static_cast<std::int64_t>(dut_.cycle()), axis, way});
            }
        }
    }

    ClockedDut<Dut> dut_;
    Steps& steps_;
    unsigned level_ = 0;
};

}  // namespace curvecore::sysc
