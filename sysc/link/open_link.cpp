// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/write.hpp>
#include <charconv>

#include "sysc/cli/usage_error.hpp"
#include "sysc/link/readable.hpp"
#include "sysc/link/spi_link.hpp"

namespace curvecore::sysc {
namespace {

using std::chrono::milliseconds;
namespace asio = boost::asio;

/// A link whose frames are datagrams: UDP has its own checksum.
class UdpLink : public Link {
  public:
    UdpLink(const std::string& address, unsigned short port) {
        socket_.connect({asio::ip::make_address(address), port});
    }

    /// Sends a frame; one that cannot be sent is lost: nobody listens (yet), or a buffer is full.
    void send(const Bytes& frame) override {
        boost::system::error_code lost;
        socket_.send(asio::buffer(frame), 0, lost);
    }

    std::optional<Bytes> receive(WireClock::duration wait) override {
        if (!readable(socket_.native_handle(), wait)) return std::nullopt;
        Bytes answer(65536);
        boost::system::error_code lost;
        answer.resize(socket_.receive(asio::buffer(answer), 0, lost));
        if (lost) return std::nullopt;
        return answer;
    }

    WireClock::duration poll_period() const override { return milliseconds(1); }

  private:
    asio::io_context context_;
    asio::ip::udp::socket socket_{context_};
};

/// A serial line with 8 bits, no parity, one stop bit.
class SerialLink : public Link {
  public:
    SerialLink(const std::string& device, unsigned baud) : port_(context_, device), baud_(baud) {
        using Port = asio::serial_port;
        port_.set_option(Port::baud_rate(baud));
        port_.set_option(Port::character_size(8));
        port_.set_option(Port::parity(Port::parity::none));
        port_.set_option(Port::stop_bits(Port::stop_bits::one));
        port_.set_option(Port::flow_control(Port::flow_control::none));
    }

    void send(const Bytes& frame) override { asio::write(port_, asio::buffer(slip_encode(frame))); }

    std::optional<Bytes> receive(WireClock::duration wait) override {
        const WireClock::time_point end = WireClock::now() + wait;
        for (;;) {
            while (next_ < held_) {
                if (std::optional<Bytes> frame = decoder_.take(buffer_[next_++])) return frame;
            }
            if (!readable(port_.native_handle(), end - WireClock::now())) return std::nullopt;
            next_ = 0;
            held_ = port_.read_some(asio::buffer(buffer_));
        }
    }

    WireClock::duration poll_period() const override { return milliseconds(20); }
    double bytes_per_s() const override { return baud_ / 10.0; }

  private:
    asio::io_context context_;
    asio::serial_port port_;
    unsigned baud_;
    SlipDecoder decoder_;
    std::array<std::uint8_t, 4096> buffer_{};
    std::size_t next_ = 0;
    std::size_t held_ = 0;
};

/// Takes the number behind the last `mark` off a name; `standard` if there is none.
unsigned number_behind(char mark, std::string& name, unsigned standard, unsigned most) {
    const std::size_t at = name.rfind(mark);
    if (at == std::string::npos) return standard;
    const std::string text = name.substr(at + 1);
    unsigned number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number > most) {
        throw UsageError(fmt::format("{}: '{}' is no number up to {}", name, text, most));
    }
    name.resize(at);
    return number;
}

}  // namespace

unsigned short take_port(std::string& address) {
    return static_cast<unsigned short>(number_behind(':', address, kWirePort, 65535));
}

std::unique_ptr<Link> open_link(const std::string& name) {
    const std::size_t colon = name.find(':');
    const std::string kind = name.substr(0, colon);
    std::string where = colon == std::string::npos ? "" : name.substr(colon + 1);
    try {
        if (kind == "udp" && !where.empty()) {
            const unsigned short port = take_port(where);
            return std::make_unique<UdpLink>(where, port);
        }
        if (kind == "serial" && !where.empty()) {
            const unsigned baud = number_behind('@', where, 115200, 12'000'000);
            return std::make_unique<SerialLink>(where, baud);
        }
        if (kind == "spi" && !where.empty()) {
            const unsigned hertz = number_behind('@', where, 1'000'000, 100'000'000);
            return std::make_unique<SpiLink>(open_spi_device(where, hertz), hertz);
        }
    } catch (const boost::system::system_error& error) {
        throw UsageError(fmt::format("{}: {}", name, error.code().message()));
    }
    throw UsageError(fmt::format("'{}' is no board: {}", name, kLinkNames));
}

}  // namespace curvecore::sysc
