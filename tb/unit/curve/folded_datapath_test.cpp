// SPDX-License-Identifier: Apache-2.0
// rtl/serial/folded_datapath.sv: its constants keep their values. Its sums and products are tested
// within the serial core.
#include <gtest/gtest.h>

#include <vector>

#include "Vfolded_datapath.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
using namespace sysc;
namespace {

constexpr int kBits = CFG_CoefBits;
constexpr int64_t kOne = int64_t{1} << (kBits - 2);
constexpr int kOneAddress = 0x81;
constexpr int kZeroAddress = 0xa0;
constexpr int kScale = 4;  // a shift by CoefBits - 2

class FoldedDatapath : public testing::Test {
  protected:
    FoldedDatapath() {
        dut_->target_i = 0;
        dut_->external_i = 0;
        dut_->first_i = 0;
        dut_->more_i = 0;
        dut_->scale_i = kScale;
        dut_.reset();
    }

    void write(int address, int64_t word) {
        dut_->external_i = 1;
        dut_->external_address_i = address;
        dut_->external_data_i = to_port(word, kBits);
        dut_.tick();
        dut_->external_i = 0;
    }

    /// Moves the word at `from`, which goes to address `to` if target is 1.
    int64_t move(int from, int to, int target) {
        dut_->a_address_i = from;
        dut_->b_address_i = kOneAddress;
        dut_->c_address_i = kZeroAddress;
        dut_->d_address_i = to;
        dut_->target_i = target;
        dut_.tick();
        dut_->target_i = 0;
        dut_.tick(7);
        dut_.settle();
        const int64_t word = from_port(dut_->d_o, kBits);
        dut_.tick(2);
        return word;
    }

    ClockedDut<Vfolded_datapath> dut_;
};

TEST_F(FoldedDatapath, WritesItsResults) {
    write(3, 12345);
    EXPECT_EQ(move(3, 0x70, 1), 12345);
    EXPECT_EQ(move(0x70, 0, 2), 12345);
    if (CFG_Splines) {
        move(3, 0x1a1, 1);
        EXPECT_EQ(move(0x1a1, 0, 2), 12345);
    }
}

TEST_F(FoldedDatapath, NoResultChangesAConstant) {
    std::vector<int> places = {kOneAddress, 0x91};
    for (int address = 0xa0; address <= 0xaf; ++address) places.push_back(address);
    std::vector<int64_t> constants;
    for (const int address : places) constants.push_back(move(address, 0, 2));
    EXPECT_EQ(constants[0], kOne);
    write(3, 12345);
    for (const int address : places) move(3, address, 1);
    for (std::size_t n = 0; n < places.size(); ++n) {
        EXPECT_EQ(move(places[n], 0, 2), constants[n]) << "address " << places[n];
    }
}

}  // namespace
}  // namespace curvecore::tb
