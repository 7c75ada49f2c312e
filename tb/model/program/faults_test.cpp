// SPDX-License-Identifier: Apache-2.0
#include "sysc/board/faults.hpp"

#include <gtest/gtest.h>

namespace curvecore::tb::faults_test {

TEST(Faults, AreNamedBitByBit) {
    EXPECT_EQ(sysc::fault_text(0), "none");
    EXPECT_EQ(sysc::fault_text(0x81),
              "a segment word that cannot be, is not as it was made or for another configuration, "
              "no sample for too long, or foreign or changed microcode");
}

}  // namespace curvecore::tb::faults_test
