// SPDX-License-Identifier: Apache-2.0
// A cache of Verilated cores, which are built on demand.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sysc/cache/core_microcode.hpp"
#include "sysc/core/core_parameters.hpp"
#include "sysc/cores/rtl_setup.hpp"

namespace curvecore::sysc {

/// A Verilated module that is made when it is asked for.
struct CachedModel {
    const char* kind;                     // what it is called
    const char* top;                      // module
    const char* source;                   // file with the function curvecore_model
    CoreParameters core;                  // inside it
    std::vector<std::string> parameters;  // Name=Value, of the module
    int segment_queue_words;
    int profile_queue_words;
    int rate_bits = 0;  // of a board's engine: motion_program.hpp
};

class CoreCache {
  public:
    /// Finds the folders. Sources of cores are in share/curvecore beside the installed program's
    /// bin, otherwise in the source tree. Cores are kept in $CURVECORE_CORES, or
    /// $XDG_CACHE_HOME/curvecore if installed, otherwise in the source tree's build/cores.
    /// @param rtl folder of the RTL's sources; empty: rtl/ of those
    /// @param dut files of a design that has a core's ports; empty: the RTL is made
    explicit CoreCache(const std::string& rtl = "", std::vector<std::string> dut = {});

    /// Opens the core with these parameters, and builds it if it is not in the cache; waits for
    /// another run that builds it. Reports its work on stderr, unless quiet.
    /// @throws UsageError without Verilator, when it refuses sources that are not its own, when a
    /// design has not the core's ports, and when sources changed while it read them;
    /// std::runtime_error when it fails
    MakeBoard* open(const CoreParameters& parameters, bool quiet) const;
    /// Opens any module; returns its function curvecore_model.
    void* open(const CachedModel& model, bool quiet) const;

  private:
    /// Folder of the model; its name has a digest of all files and parameters that the model is
    /// made from.
    std::filesystem::path folder_of(const CachedModel& model, const CoreMicrocode& microcode) const;
    /// @throws UsageError, too, if files changed meanwhile: which of them were read is unknown
    void make(const CachedModel& model, const CoreMicrocode& microcode,
              const std::filesystem::path& folder, bool quiet) const;

    /// Sources that are not the program's, for messages.
    std::string sources_text() const;
    /// Text of the design with all that it includes.
    std::string dut_text() const;

    std::filesystem::path sources_;
    std::filesystem::path rtl_;
    std::vector<std::string> dut_;
    std::filesystem::path cores_;
};

}  // namespace curvecore::sysc
