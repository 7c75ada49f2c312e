// SPDX-License-Identifier: Apache-2.0
// The host's end of SPI against the Verilated board's pins, 12 clocks a bit.
#include "sysc/link/spi_link.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <thread>

#include "Vspi_board.h"
#include "sysc/virtual/board_server.hpp"
#include "sysc/wire/wire_options.hpp"
#include "sysc/wire/wire_stream.hpp"
#include "tb/wire/spi_pins.hpp"

namespace curvecore::sysc {
namespace {

/// Draws the program and returns the link's figures.
LinkFigures draw(Link& link, const std::string& part) {
    Options options;
    options.file = part;
    RemoteMachine machine(link);
    take_board(machine.build(), options);
    WordSource words(options);
    machine.prepare(drives_of(WireOptions(), machine.build().axes), options.unit_mm);
    machine.begin(words.settings(), 0);  // no watchdog: the board's time is not the host's
    WishQueue wishes;
    WireStream stream(machine, words, wishes, 1);
    EXPECT_EQ(stream.run([] {}), StreamEnd::kDone);
    EXPECT_FALSE(stream.held());
    EXPECT_EQ(stream.link_rate(), 1);
    for (int n = 0; n < 20; ++n) machine.steps();  // until the last step is out
    return machine.figures();
}

Steps from_the_first(Steps steps) {
    const std::int64_t first = steps.empty() ? 0 : steps[0][0];
    for (auto& step : steps) step[0] -= first;
    return steps;
}

TEST(SpiLink, DrawsTheStepsThatUdpDraws) {
    const std::string part = testing::TempDir() + "spi_part.ngc";
    std::ofstream(part) << "G21 G90 G61 F1800\nG1 X3 Z1\nG3 X5 Y2 I0 J2\nG5 X7 Y5 I0 J2 P-1 Q0\n"
                           "G1 X0\nM2\n";
    Steps over_udp;
    {
        BoardServer server({"127.0.0.1:0", true, {}}, [&](const VirtualStep& step) {
            over_udp.push_back(
                {static_cast<std::int64_t>(step.clock), step.axis, step.back ? -1 : 1});
        });
        std::atomic<bool> works{true};
        std::thread board([&] {
            while (works) server.work();
        });
        const std::unique_ptr<Link> link = open_link("udp:" + server.where());
        draw(*link, part);
        works = false;
        board.join();
    }
    Steps over_spi;
    SpiLink link(std::make_unique<SpiPins<Vspi_board>>(over_spi), 5'120'000 / (2.0 * kHalfBit));
    const LinkFigures figures = draw(link, part);
    EXPECT_GT(over_udp.size(), 5000U);
    EXPECT_EQ(over_spi.size(), over_udp.size());
    EXPECT_TRUE(from_the_first(over_spi) == from_the_first(over_udp));
    EXPECT_EQ(figures.repeated, 0U);
}

/// A bus that sends its given bytes once, and nothing from then on.
class Talker : public SpiBus {
  public:
    explicit Talker(Bytes line) : line_(std::move(line)) {}
    Bytes exchange(const Bytes& bytes) override {
        Bytes came(bytes.size(), CURVECORE_LINE_END);
        std::copy(line_.begin(), line_.end(), came.begin());
        line_.clear();
        return came;
    }

  private:
    Bytes line_;
};

TEST(SpiLink, HearsWhatTheBoardSaysWhileTheHostSpeaks) {
    const Bytes first{1, 2, 0xc0, 0xdb};
    const Bytes second{3};
    Bytes line = slip_encode(first);
    line.insert(line.begin() + 1, {0xdb, 0xdb});
    for (const std::uint8_t byte : slip_encode(second)) line.push_back(byte);
    SpiLink link(std::make_unique<Talker>(line), 1e6);
    link.send(Bytes(100, 7));
    const WireClock::duration at_once{};
    EXPECT_EQ(link.receive(at_once), first);
    EXPECT_EQ(link.receive(at_once), second);
    EXPECT_EQ(link.receive(std::chrono::milliseconds(5)), std::nullopt);
}

}  // namespace
}  // namespace curvecore::sysc
