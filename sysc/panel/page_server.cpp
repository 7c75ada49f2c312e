// SPDX-License-Identifier: Apache-2.0
#include "sysc/panel/page_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <charconv>
#include <cstdio>
#include <deque>
#include <future>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "sysc/cli/usage_error.hpp"
#include "sysc/panel/panel_template.hpp"

namespace curvecore::sysc {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Error = beast::error_code;
using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

constexpr int kMostConnections = 16;
constexpr std::size_t kMostLog = 200;         // lines
constexpr std::size_t kLongestMessage = 256;  // bytes, from a page
constexpr std::size_t kLongestHeader = 8192;
constexpr auto kPatience = std::chrono::seconds(10);
constexpr auto kIdle =
    std::chrono::seconds(60);  // of a web socket, which is asked for a sign of life
constexpr auto kFarewell = std::chrono::seconds(5);
constexpr const char* kAddress = "127.0.0.1";

std::string new_token() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

/// Splits [ADDRESS:]PORT.
Tcp::endpoint endpoint_of(const std::string& at) {
    const std::size_t colon = at.rfind(':');
    const std::string address = colon == std::string::npos ? kAddress : at.substr(0, colon);
    const std::string digits = colon == std::string::npos ? at : at.substr(colon + 1);
    unsigned port = 0;
    const char* end = digits.data() + digits.size();
    const auto [behind, error] = std::from_chars(digits.data(), end, port);
    Error wrong;
    const asio::ip::address ip = asio::ip::make_address(address, wrong);
    if (error != std::errc() || behind != end || port > 65535 || wrong) {
        throw UsageError(fmt::format(
            "--web {}: must be a port, 0 to 65535, or ADDRESS:PORT, as 127.0.0.1:8080", at));
    }
    return {ip, static_cast<unsigned short>(port)};
}

/// Name in a Host header, without its port.
std::string host_of(const std::string& header) {
    const bool bare = !header.empty() && header.back() == ']';
    return bare ? header : header.substr(0, header.rfind(':'));
}

}  // namespace

struct PageServer::State {
    State(const std::string& at, std::function<std::string(std::size_t)> all, WishQueue& asked);

    void accept();
    bool make_room();
    void show(const std::string& name, std::string message);
    void finish();
    Response answer(const Request& request) const;
    bool knows(const Request& request) const;

    const std::string token = new_token();
    const std::function<std::string(std::size_t)> points;
    WishQueue& wishes;
    asio::io_context context{1};
    Tcp::acceptor acceptor{context};
    std::atomic<int> viewers{0};
    // Of the thread alone:
    std::map<std::string, std::string> shown;              // messages
    std::vector<std::shared_ptr<Connection>> connections;  // the oldest first
    std::promise<void> ended;
    std::thread thread;
};

/// A connection of a browser: one request, or a web socket.
class PageServer::Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(Tcp::socket socket, State& server) : socket_(std::move(socket)), server_(server) {
        parser_.header_limit(kLongestHeader);
        parser_.body_limit(0);
    }

    void begin() {
        socket_.next_layer().expires_after(kPatience);
        http::async_read(socket_.next_layer(), buffer_, parser_,
                         [self = shared_from_this()](Error error, std::size_t) {
                             error ? self->leave() : self->answer();
                         });
    }

    /// Sends a message; one of the same name that still waits is of no use any more.
    void send(const std::string& name, const std::string& message) {
        if (!viewing_) return;
        for (std::size_t n = 1; n < waiting_.size(); ++n) {
            if (waiting_[n].first != name) continue;
            waiting_[n].second = message;
            return;
        }
        waiting_.emplace_back(name, message);
        if (waiting_.size() == 1) write();
    }

    bool has_control() const { return control_; }

    void leave() {
        std::vector<std::shared_ptr<Connection>>& all = server_.connections;
        const auto here = std::find(all.begin(), all.end(), shared_from_this());
        if (here == all.end()) return;
        all.erase(here);
        if (viewing_) --server_.viewers;
        beast::close_socket(beast::get_lowest_layer(socket_));
    }

    /// Closes it behind what waits.
    void finish() {
        finishing_ = true;
        if (viewing_ && waiting_.empty()) close();
    }

  private:
    void answer() {
        const Request request = parser_.release();
        response_ = server_.answer(request);
        if (response_.result() == http::status::switching_protocols) return upgrade(request);
        http::async_write(socket_.next_layer(), response_,
                          [self = shared_from_this()](Error, std::size_t) { self->leave(); });
    }

    void upgrade(const Request& request) {
        socket_.next_layer().expires_never();
        socket_.set_option(websocket::stream_base::timeout{kPatience, kIdle, true});
        socket_.read_message_max(kLongestMessage);
        socket_.async_accept(request, [self = shared_from_this()](Error error) {
            error ? self->leave() : self->view();
        });
    }

    void view() {
        viewing_ = true;
        ++server_.viewers;
        buffer_.clear();
        for (const auto& [name, message] : server_.shown) send(name, message);
        read();
    }

    void read() {
        socket_.async_read(buffer_, [self = shared_from_this()](Error error, std::size_t) {
            if (error) return self->leave();
            self->understand(beast::buffers_to_string(self->buffer_.data()));
            self->buffer_.clear();
            self->read();
        });
    }

    void understand(const std::string& text) {
        const nlohmann::json said = nlohmann::json::parse(text, nullptr, false);
        const auto value = [&said](const char* name) {
            const bool there = said.is_object() && said.contains(name) && said[name].is_string();
            return there ? std::optional<std::string>(said[name]) : std::nullopt;
        };
        if (const std::optional<std::string> token = value("token")) {
            control_ = *token == server_.token;
            send("control", fmt::format(R"({{"control":{}}})", control_));
        } else if (const std::optional<std::string> asked = value("wish"); asked && control_) {
            if (const std::optional<Wish> wish = wish_of(*asked)) server_.wishes.push(*wish);
        }
    }

    void write() {
        socket_.text(true);
        socket_.async_write(asio::buffer(waiting_.front().second),
                            [self = shared_from_this()](Error error, std::size_t) {
                                if (error) return self->leave();
                                self->waiting_.pop_front();
                                if (!self->waiting_.empty()) return self->write();
                                if (self->finishing_) self->close();
                            });
    }

    void close() {
        socket_.async_close(websocket::close_code::going_away,
                            [self = shared_from_this()](Error) { self->leave(); });
    }

    websocket::stream<beast::tcp_stream> socket_;
    State& server_;
    beast::flat_buffer buffer_{kLongestHeader};
    http::request_parser<http::string_body> parser_;
    Response response_;
    std::deque<std::pair<std::string, std::string>> waiting_;  // the first one is being written
    bool viewing_ = false;
    bool finishing_ = false;
    bool control_ = false;
};

PageServer::State::State(const std::string& at, std::function<std::string(std::size_t)> all,
                         WishQueue& asked)
    : points(std::move(all)), wishes(asked) {
    const Tcp::endpoint here = endpoint_of(at);
    try {
        acceptor.open(here.protocol());
        acceptor.set_option(asio::socket_base::reuse_address(true));
        acceptor.bind(here);
        acceptor.listen();
    } catch (const boost::system::system_error& error) {
        throw UsageError(fmt::format("--web {}: {}", at, error.code().message()));
    }
}

void PageServer::State::accept() {
    acceptor.async_accept([this](Error error, Tcp::socket socket) {
        if (!acceptor.is_open()) return;
        if (!error && make_room()) {
            connections.push_back(std::make_shared<Connection>(std::move(socket), *this));
            connections.back()->begin();
        }
        accept();
    });
}

/// Returns true if one more connection may be; the oldest one without the token makes room for it.
bool PageServer::State::make_room() {
    if (connections.size() < kMostConnections) return true;
    const auto other = std::find_if(connections.begin(), connections.end(),
                                    [](const auto& one) { return !one->has_control(); });
    if (other == connections.end()) return false;
    std::shared_ptr(*other)->leave();
    return true;
}

void PageServer::State::show(const std::string& name, std::string message) {
    shown[name] = std::move(message);
    for (const std::shared_ptr<Connection>& connection : connections) {
        connection->send(name, shown[name]);
    }
}

void PageServer::State::finish() {
    acceptor.close();
    for (const std::shared_ptr<Connection>& connection : std::vector(connections)) {
        connection->finish();
    }
}

/// Returns true if the request names this computer, or may name it as it likes.
bool PageServer::State::knows(const Request& request) const {
    const std::string host = host_of(std::string(request[http::field::host]));
    return !acceptor.local_endpoint().address().is_loopback() || host == "localhost" ||
           host == "127.0.0.1" || host == "[::1]";
}

Response PageServer::State::answer(const Request& request) const {
    Response response;
    const auto say = [&](http::status status, const char* type, std::string text) {
        response.result(status);
        response.set(http::field::content_type, type);
        response.body() = std::move(text);
    };
    const std::string target(request.target());
    const std::string origin(request[http::field::origin]);
    const bool own =
        origin.empty() || origin == "http://" + std::string(request[http::field::host]);
    std::size_t from = 0;
    if (!knows(request) || !own) {
        say(http::status::forbidden, "text/plain", "not from here\n");
    } else if (request.method() != http::verb::get) {
        say(http::status::method_not_allowed, "text/plain", "only GET\n");
    } else if (target == "/live" && websocket::is_upgrade(request)) {
        response.result(http::status::switching_protocols);
    } else if (target == "/") {
        say(http::status::ok, "text/html; charset=utf-8", kPanelPage);
    } else if (std::sscanf(target.c_str(), "/points?from=%zu", &from) == 1) {
        say(http::status::ok, "application/json", points(from));
    } else {
        say(http::status::not_found, "text/plain", "not here\n");
    }
    response.set(http::field::cache_control, "no-store");
    response.set("Content-Security-Policy",
                 "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                 "connect-src 'self'; frame-ancestors 'none'; base-uri 'none'");
    response.set("X-Content-Type-Options", "nosniff");
    response.keep_alive(false);
    response.prepare_payload();
    return response;
}

PageServer::PageServer(const std::string& at, std::function<std::string(std::size_t)> points,
                       WishQueue& wishes)
    : state_(std::make_unique<State>(at, std::move(points), wishes)) {
    state_->accept();
    state_->thread = std::thread([state = state_.get()] {
        state->context.run();
        state->ended.set_value();
    });
}

PageServer::~PageServer() {
    std::future<void> ended = state_->ended.get_future();
    asio::post(state_->context, [this] { state_->finish(); });
    if (ended.wait_for(kFarewell) != std::future_status::ready) state_->context.stop();
    state_->thread.join();
}

std::string PageServer::address() const {
    const Tcp::endpoint here = state_->acceptor.local_endpoint();
    const std::string host = here.address().to_string();
    return fmt::format(here.address().is_v6() ? "http://[{}]:{}/#{}" : "http://{}:{}/#{}", host,
                       here.port(), state_->token);
}

bool PageServer::watched() const { return state_->viewers > 0; }

void PageServer::note(const std::string& line) {
    if (log_.size() == kMostLog) log_.pop_front();
    log_.push_back(line);
    show("log", nlohmann::json(log_).dump());
}

void PageServer::show(const std::string& name, const std::string& json) {
    asio::post(state_->context, [this, name, message = fmt::format(R"({{"{}":{}}})", name, json)] {
        state_->show(name, message);
    });
}

}  // namespace curvecore::sysc
