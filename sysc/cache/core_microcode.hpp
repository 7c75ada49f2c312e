// SPDX-License-Identifier: Apache-2.0
// Programs of the engine of a core that is made on demand: files beside it, which it reads when it
// is opened.
#pragma once

#include <filesystem>
#include <string>

#include "rtl/engine/compiler/microcode_files.hpp"
#include "rtl/engine/compiler/motion_program.hpp"
#include "sysc/core/core_parameters.hpp"

namespace curvecore::sysc {

/// Texts for $readmemh; without text for a core that has no engine.
class CoreMicrocode {
  public:
    /// Assembles what lies in `sources`, which has the layout of the source tree.
    /// @throws UsageError: the engine has no room for these parameters
    CoreMicrocode(const CoreParameters& parameters, const assembler::QueueWords& queues,
                  const std::filesystem::path& sources, int rate_bits = 0);

    bool empty() const { return files_.empty(); }
    std::string text() const;
    void write(const std::filesystem::path& folder) const;
    /// Returns true if the folder has these texts.
    bool lies_in(const std::filesystem::path& folder) const;

  private:
    assembler::MicrocodeFiles files_;
};

}  // namespace curvecore::sysc
