// SPDX-License-Identifier: Apache-2.0
// Verilated cores that are made when they are asked for, and kept.
#pragma once

#include <filesystem>

#include "sysc/core/core_parameters.hpp"
#include "sysc/cores/rtl_setup.hpp"

namespace curvecore::sysc {

class CoreCache {
  public:
    /// Installed, the cores' sources are in share/curvecore beside the program's bin, else in the
    /// source tree. Cores are kept in $CURVECORE_CORES, or $XDG_CACHE_HOME/curvecore if installed,
    /// else in the source tree's build/cores.
    CoreCache();

    /// The core of these parameters, made if it is not there; another run that makes it is waited
    /// for. Says on stderr what it does, unless quiet.
    /// @throws UsageError without Verilator, std::runtime_error when it fails
    MakeBoard* open(const CoreParameters& parameters, bool quiet) const;

  private:
    /// Of all that a core is made from.
    std::string digest(const CoreParameters& parameters) const;
    void make(const CoreParameters& parameters, const std::filesystem::path& folder,
              bool quiet) const;

    std::filesystem::path sources_;
    std::filesystem::path cores_;
};

}  // namespace curvecore::sysc
