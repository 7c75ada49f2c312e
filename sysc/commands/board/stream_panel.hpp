// SPDX-License-Identifier: Apache-2.0
// Panel of a streamed program, on the terminal and on a page: what a person sees and asks for.
#pragma once

#include <optional>

#include "sysc/home/encoders.hpp"
#include "sysc/job/options.hpp"
#include "sysc/panel/console.hpp"
#include "sysc/panel/page_server.hpp"
#include "sysc/panel/panel_status.hpp"
#include "sysc/panel/terminal_panel.hpp"
#include "sysc/wire/forecast.hpp"
#include "sysc/wire/wire_stream.hpp"

namespace curvecore::sysc {

class StreamPanel {
  public:
    struct Parts {
        const Options& options;
        const Drives& drives;
        RemoteMachine& machine;
        WordSource& words;
    };

    /// Opens what is needed; `web`: PageServer's, empty: no page. Prints the page's address.
    /// @throws UsageError
    StreamPanel(const Parts& parts, const std::string& control_file, const std::string& web);

    /// The axes stand where the program begins.
    void begin(const Encoders& encoders);

    /// Returns true if somebody can ask for something.
    bool heard() const { return console_.heard() || page_; }
    WishQueue& wishes() { return wishes_; }
    /// Takes wishes and shows the state, where someone looks and it is time to.
    void turn(const WireStream& stream);
    /// Shows how it ended.
    void end(const WireStream& stream, const std::string& how);
    /// Shows that the board does not answer any more. Returns where it was, and what to do.
    std::string lose(const WireStream& stream);

  private:
    PlannedPath& path();
    double mm_of(std::uint64_t quanta) const;
    std::vector<PanelAxis> axes() const;
    PanelStatus status(const WireStream& stream);
    std::string state(const WireStream& stream) const;
    void tell_wait(const WireStream& stream);
    void tell_begin(const WireStream& stream);
    std::string from_text(std::uint64_t path) const;
    void show(PanelStatus status);
    void log(const PanelStatus& status);

    Parts parts_;
    ref::Machine described_;
    double quantum_mm_;
    Console console_;
    WishQueue wishes_;
    TerminalPanel terminal_;
    std::optional<Forecast> forecast_;  // while somebody looks, of a program that is a file
    const Encoders* encoders_ = nullptr;
    std::vector<std::int32_t> begin_;  // steps
    WireClock::time_point shown_;
    std::uint64_t told_begin_ = 0;  // WireStream::begin()
    std::string wait_;              // for a person, as it was said; empty: none
    PanelStatus last_;
    std::optional<PageServer> page_;  // last member: its thread uses the others
};

}  // namespace curvecore::sysc
