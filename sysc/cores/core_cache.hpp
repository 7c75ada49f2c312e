// SPDX-License-Identifier: Apache-2.0
// A cache of Verilated cores, which are built on demand.
#pragma once

#include <filesystem>

#include "sysc/core/core_parameters.hpp"
#include "sysc/cores/rtl_setup.hpp"

namespace curvecore::sysc {

class CoreCache {
  public:
    /// Finds the folders. Sources of cores are in share/curvecore beside the installed program's
    /// bin, otherwise in the source tree. Cores are kept in $CURVECORE_CORES, or
    /// $XDG_CACHE_HOME/curvecore if installed, otherwise in the source tree's build/cores.
    CoreCache();

    /// Opens the core with these parameters, and builds it if it is not in the cache; waits for
    /// another run that builds it. Reports its work on stderr, unless quiet.
    /// @throws UsageError without Verilator, std::runtime_error when it fails
    MakeBoard* open(const CoreParameters& parameters, bool quiet) const;

  private:
    /// Digest of all files and parameters that the core is made from.
    std::string digest(const CoreParameters& parameters) const;
    void make(const CoreParameters& parameters, const std::filesystem::path& folder,
              bool quiet) const;

    std::filesystem::path sources_;
    std::filesystem::path cores_;
};

}  // namespace curvecore::sysc
