// SPDX-License-Identifier: Apache-2.0
// Interruption of a run (Ctrl-C): the unfinished output is removed, as after any other failure.
#pragma once

#include <csignal>
#include <stdexcept>

namespace curvecore::sysc {

class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Catches SIGINT and SIGTERM during its lifetime; a second signal ends the program at once.
class InterruptGuard {
  public:
    InterruptGuard() {
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, &note);
    }
    ~InterruptGuard() {
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
    }
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// @throws Interrupted if a signal has come
    static void check() {
        if (noted_ != 0) throw Interrupted();
    }

  private:
    static void note(int signal) {
        noted_ = 1;
        std::signal(signal, SIG_DFL);
    }

    inline static volatile std::sig_atomic_t noted_ = 0;
};

}  // namespace curvecore::sysc
