// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/synth_run.hpp"

#include <filesystem>
#include <sstream>

namespace curvecore::tb {
namespace fs = std::filesystem;

SynthRun::SynthRun(const std::vector<std::string>& tools) : ProgramRun("/usr/bin/env") {
    fs::create_directory(folder() / "bin");
    for (const std::string command : {"bash", "dirname", "ls", "sleep", "touch"}) {
        fs::create_symlink("/bin/" + command, folder() / "bin" / command);
    }
    for (const std::string& tool : tools) {
        const std::string file = "bin/" + tool;
        write(file, "#!/bin/sh\nexec " SYNTH_PYTHON " " SYNTH_FAKE " " + tool + " \"$@\"\n");
        fs::permissions(folder() / file, fs::perms::owner_all);
    }
}

ProgramResult SynthRun::synth(const std::vector<std::string>& options) const {
    std::string script = "$SYNTH";
    for (const std::string& option : options) script += " '" + option + "'";
    return shell(script);
}

ProgramResult SynthRun::shell(const std::string& script) const {
    const std::string here = folder().string();
    return run({"PATH=" + here + "/bin", "FAKE_LOG=" + here + "/log", "FAKE_GATE=" + here + "/gate",
                "SYNTH=" SYNTH_PYTHON " " SYNTH_PY " --output out",
                "HLS=" SYNTH_PYTHON " " HLS_PY " --output out",
                "MICROCODE_GENERATOR=" MICROCODE_GENERATOR, "/bin/sh", "-c", script});
}

int SynthRun::runs(const std::string& tool) const {
    std::istringstream log(read("log"));
    int number = 0;
    for (std::string line; std::getline(log, line);) number += line == tool ? 1 : 0;
    return number;
}

}  // namespace curvecore::tb
