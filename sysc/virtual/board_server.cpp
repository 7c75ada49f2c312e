// SPDX-License-Identifier: Apache-2.0
#include "sysc/virtual/board_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/ip/udp.hpp>
#include <cmath>

#include "hls/registers/board_frame.h"
#include "sysc/cli/usage_error.hpp"
#include "sysc/link/frame.hpp"
#include "sysc/link/readable.hpp"

namespace curvecore::sysc {
namespace {

namespace asio = boost::asio;
using Udp = asio::ip::udp;
using std::chrono::milliseconds;

/// Silence after which a master loses the board, s of the board.
constexpr double kMasterLeaves = 1;
/// Refused frames after which it loses a fast board whose drives are off.
constexpr int kRefusals = 8;
/// Time by which a frame advances the clock of a fast board, s of the board.
constexpr double kTimeOfFrame = 0.005;
/// Greatest number of words that a frame may read, and of frames that wait.
constexpr std::size_t kMostRead = 128;
constexpr std::size_t kMostWaiting = 256;
/// Clocks between two checks of the socket.
constexpr std::uint64_t kClocksAtOnce = 2000;

}  // namespace

struct BoardServer::State {
    struct Waiting {
        Bytes frame;
        Udp::endpoint from;
        std::size_t words_read;
    };

    State(const BoardServerOptions& options, std::function<void(const VirtualStep&)> step)
        : fast(options.fast), board(std::move(step), options.axes, options.build, options.table) {}

    void receive(milliseconds wait);
    void take(const Bytes& frame, const Udp::endpoint& from);
    bool master_left() const;
    void run(std::uint64_t clocks);
    void follow_wall();
    std::uint64_t due();

    bool fast;
    VirtualBoard board;
    asio::io_context context;
    Udp::socket socket{context};
    std::optional<Udp::endpoint> master;
    std::uint64_t master_spoke = 0;  // clock of the board
    int refused = 0;                 // frames of others since then
    std::deque<Waiting> waiting;
    std::optional<Udp::endpoint> asks;  // receiver of the next answer
    WireClock::time_point looked = WireClock::now();
    double clocks_due = 0;
    double clocks_lost = 0;  // clocks of real time that were not made
};

void BoardServer::State::receive(milliseconds wait) {
    for (; readable(socket.native_handle(), wait); wait = milliseconds(0)) {
        Bytes frame(65536);
        Udp::endpoint from;
        boost::system::error_code gone;  // the receiver of the last answer is gone
        frame.resize(socket.receive_from(asio::buffer(frame), from, 0, gone));
        if (!gone) take(frame, from);
    }
}

void BoardServer::State::take(const Bytes& frame, const Udp::endpoint& from) {
    const FrameContents contents = contents_of(frame);
    if (frame.empty() || frame.size() > CURVECORE_LONGEST_FRAME ||
        contents.words_read > kMostRead || waiting.size() >= kMostWaiting) {
        return;
    }
    // Also those of another host, which waits until the master has left.
    if (fast) clocks_due += kTimeOfFrame * board.times().clock_hz;
    if (master_left()) master.reset();
    if (contents.writes && !master) master = from;
    const bool from_master = master == from;
    if ((contents.writes || !contents.whole) && !from_master) {
        ++refused;
        return;
    }
    if (from_master) {
        master_spoke = board.clocks();
        refused = 0;
    }
    waiting.push_back({frame, from, contents.words_read});
}

bool BoardServer::State::master_left() const {
    const double silent = static_cast<double>(board.clocks() - master_spoke);
    return silent > kMasterLeaves * board.times().clock_hz ||
           (fast && refused >= kRefusals && !board.drives_on());
}

/// Runs the clocks; frames go in one after the other, the next when the last is answered.
void BoardServer::State::run(std::uint64_t clocks) {
    for (; clocks > 0; --clocks) {
        if (!waiting.empty() && board.taken() && !asks) {
            board.offer(waiting.front().frame);
            if (waiting.front().words_read > 0) asks = waiting.front().from;
            waiting.pop_front();
        }
        const std::optional<Bytes> answer = board.clock();
        if (answer && asks) {
            boost::system::error_code gone;
            socket.send_to(asio::buffer(*answer), *asks, 0, gone);
            asks.reset();
        }
    }
}

/// Follows real time. A board that is behind does not catch up.
void BoardServer::State::follow_wall() {
    const WireClock::time_point now = WireClock::now();
    const double passed = std::chrono::duration<double>(now - looked).count();
    looked = now;
    clocks_due += passed * board.times().clock_hz;
    const double most = 0.1 * board.times().clock_hz;
    if (clocks_due > most) {
        clocks_lost += clocks_due - most;
        clocks_due = most;
    }
}

/// Clocks that are due, up to a limit at once.
std::uint64_t BoardServer::State::due() {
    if (!fast) follow_wall();
    const double whole = std::min(std::floor(clocks_due), static_cast<double>(kClocksAtOnce));
    clocks_due -= whole;
    return static_cast<std::uint64_t>(whole);
}

BoardServer::BoardServer(const BoardServerOptions& options,
                         std::function<void(const VirtualStep&)> step)
    : state_(std::make_unique<State>(options, std::move(step))) {
    std::string address = options.address;
    try {
        const unsigned short port = take_port(address);
        const Udp::endpoint here(asio::ip::make_address(address), port);
        state_->socket.open(here.protocol());
        state_->socket.bind(here);
    } catch (const boost::system::system_error& error) {
        throw UsageError(fmt::format("--listen {}: {}", options.address, error.code().message()));
    }
}

BoardServer::~BoardServer() = default;

std::string BoardServer::where() const {
    const Udp::endpoint here = state_->socket.local_endpoint();
    return fmt::format("{}:{}", here.address().to_string(), here.port());
}

void BoardServer::work() {
    const std::uint64_t clocks = state_->due();
    state_->run(clocks);
    state_->receive(milliseconds(clocks == kClocksAtOnce ? 0 : 1));
}

const VirtualBoard& BoardServer::board() const { return state_->board; }

double BoardServer::pace() const {
    const auto passed = static_cast<double>(clocks());
    return passed / (passed + state_->clocks_lost);
}

}  // namespace curvecore::sysc
