// SPDX-License-Identifier: Apache-2.0
// A page for a browser: served over HTTP, kept up to date over a web socket.
//
//   GET /                the page
//   GET /points?from=N   points of the path from the Nth on: {"thinned":..,"points":[[..],..]}
//   GET /live            web socket. To the page: {"<name>": <what is shown under it>}, and
//                        {"control": true} once it sent {"token": ".."}; from it then
//                        {"wish": "hold"}, as in a control file.
//
// Whoever has the token may ask for something, others may look. The token stands behind the # of
// the page's address, which a browser sends to nobody. Pages of others, which a browser would let
// ask, are refused by their origin, and names made to mean this computer by the name. There
// are 16 connections at most, of which the oldest one without the token makes room for a new one; a
// page's messages have 256 bytes; wishes wait in a WishQueue.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "sysc/panel/wish.hpp"

namespace curvecore::sysc {

class PageServer {
  public:
    static constexpr std::chrono::milliseconds kPeriod{200};  // from one state shown to the next

    /// Serves from another thread.
    /// @param at PORT or ADDRESS:PORT; 127.0.0.1 when left out, port 0: any free one
    /// @param points returns the JSON of points from a number on; called by that thread
    /// @throws UsageError: no such address, or it is in use
    PageServer(const std::string& at, std::function<std::string(std::size_t)> points,
               WishQueue& wishes);
    ~PageServer();
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;

    /// Returns the page's address, with the token.
    std::string address() const;
    /// Returns true if a page is open.
    bool watched() const;
    /// Shows JSON under a name to all pages, and to those that come later.
    void show(const std::string& name, const std::string& json);
    /// Adds a line to the log that the pages show, of which the last 200 are kept.
    void note(const std::string& line);

  private:
    class Connection;
    struct State;
    std::deque<std::string> log_;
    std::unique_ptr<State> state_;
};

}  // namespace curvecore::sysc
