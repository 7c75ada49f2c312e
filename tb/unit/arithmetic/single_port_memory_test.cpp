// SPDX-License-Identifier: Apache-2.0
// rtl/queue/single_port_memory.sv: what was written is read, whatever the form.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "Vsingle_port_memory.h"
#include "sysc/cores/clocked_dut.hpp"
#include "sysc/cores/port_word.hpp"

namespace curvecore::tb {
namespace {
using namespace sysc;

/// One of few places, in all parts of the memory.
unsigned some(std::mt19937_64& random) {
    return static_cast<unsigned>(random() % 64 * CFG_Words / 64);
}

TEST(SinglePortMemory, ReadsWhatWasWritten) {
    ClockedDut<Vsingle_port_memory> dut;
    dut.limit_cycles(UINT64_MAX);
    std::mt19937_64 random{1};
    std::map<unsigned, std::uint64_t> words;
    int read = 0;
    for (int n = 0; n < 200'000; ++n) {
        const unsigned place = some(random);
        const bool writes = words.count(place) == 0 || random() % 4 == 0;
        const std::uint64_t word = random() & ((std::uint64_t{1} << CFG_Bits) - 1);
        dut->write_i = writes;
        dut->place_i = place;
        dut->word_i = to_port(static_cast<std::int64_t>(word), CFG_Bits);
        dut.tick();
        dut->write_i = 0;
        dut->place_i = some(random);  // the next one is no matter of this one
        dut.settle();
        if (writes) {
            words[place] = word;
        } else {
            ASSERT_EQ(dut->word_o, words[place]) << place << ", clock " << n;
            ++read;
        }
    }
    EXPECT_GT(read, 100'000);
}

}  // namespace
}  // namespace curvecore::tb
