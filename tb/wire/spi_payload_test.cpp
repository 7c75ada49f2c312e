// SPDX-License-Identifier: Apache-2.0
// Words that SPI carries to the engine's board while it draws, 4,096 clocks a sample.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <random>

#include "Vspi_payload_board.h"
#include "hls/registers/registers.h"
#include "sysc/wire/wire_options.hpp"
#include "sysc/wire/word_source.hpp"
#include "tb/wire/spi_pins.hpp"

namespace curvecore::sysc {
namespace {

/// Words go into a board's queues while it draws: the share of the line's bits that they are.
TEST(SpiPayload, IsMostOfTheLinesBits) {
    Options options;
    options.file = testing::TempDir() + "spi_words.ngc";
    std::ofstream program(options.file);
    program << "G21 G90 G64 F6000\n";
    std::mt19937_64 random(1);
    for (int move = 1; move <= 3000; ++move) {
        program << "G1 X" << 0.2 * move << " Y" << static_cast<double>(random() % 100) / 1000
                << "\n";
    }
    program << "M2\n";
    program.close();
    Steps steps;
    auto bus = std::make_unique<SpiPins<Vspi_payload_board>>(steps);
    const SpiPins<Vspi_payload_board>& pins = *bus;
    SpiLink link(std::move(bus), 5'120'000 / (2.0 * kHalfBit));
    RemoteMachine machine(link);
    take_board(machine.build(), options);
    WordSource source(options);
    machine.prepare(drives_of(WireOptions(), machine.build().axes), options.unit_mm);
    machine.begin(source.settings(), 0);
    PlannedWords planned;
    while (!planned.all) source.take(planned);
    const auto left = [&] { return planned.segments.size() + planned.pieces.size(); };
    const std::size_t all = left();
    const std::uint64_t begin = pins.clock();
    while (left() > 0 && machine.telemetry().segment_room > 100) {
        for (;;) {
            const auto [segments, pieces] = machine.push(
                planned.segments, planned.pieces, {planned.segments.size(), planned.pieces.size()});
            if (segments + pieces == 0) break;
        }
        machine.work();
    }
    machine.finish();
    const double bits = static_cast<double>(pins.clock() - begin) / (2 * kHalfBit);
    const double share = 64.0 * static_cast<double>(all - left()) / bits;
    std::cout << all - left() << " words of 64 bits in " << share << " of the line's bits, "
              << steps.size() << " steps meanwhile\n";
    EXPECT_GT(all - left(), 2000U);
    EXPECT_GT(share, 0.5);
    EXPECT_GT(steps.size(), 100U);
    EXPECT_EQ(machine.telemetry().state & CURVECORE_FAULTS, 0U);
}

}  // namespace
}  // namespace curvecore::sysc
