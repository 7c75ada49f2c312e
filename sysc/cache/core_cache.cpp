// SPDX-License-Identifier: Apache-2.0
// The cache of cores: a core's folder <build>-<digest> holds core.so and core.sum, the digest of
// core.so's bytes, and an engine's programs. A truncated or changed entry is made again.
#include "sysc/cache/core_cache.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "ref/format/queues.hpp"
#include "rtl/engine/compiler/word_numbers.hpp"
#include "sysc/cache/build_tools.hpp"
#include "sysc/cache/dut_design.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/shipped_files.hpp"
#include "sysc/cli/usage_error.hpp"

namespace curvecore::sysc {
namespace fs = std::filesystem;
namespace {

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// FNV-1a of 64 bits: it tells files apart, but is not cryptographic.
class Digest {
  public:
    void add(const std::string& text) {
        for (const char c : text) {
            state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
        }
        state_ = (state_ ^ 0x100u) * 0x100000001B3u;  // so that "ab" "c" differs from "a" "bc"
    }
    std::string text() const { return fmt::format("{:016x}", state_); }

  private:
    std::uint64_t state_ = 0xCBF29CE484222325u;
};

std::string digest_of(const fs::path& file) {
    Digest digest;
    digest.add(text_of(file));
    return digest.text();
}

/// A lock, held while one run looks at a core's folder or fills it.
class Lock {
  public:
    Lock(const fs::path& file, bool quiet)
        : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (file_ < 0) throw std::runtime_error("cannot write " + file.string());
        if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
        if (!quiet) fmt::print(stderr, "curvecore: waiting for another run that makes this core\n");
        if (flock(file_, LOCK_EX) != 0) throw Interrupted();
    }
    ~Lock() { close(file_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int file_;
};

/// A folder that is removed again.
class Scratch {
  public:
    explicit Scratch(fs::path folder) : folder_(std::move(folder)) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const fs::path& folder() const { return folder_; }

  private:
    fs::path folder_;
};

CachedModel core_model(const CoreParameters& parameters) {
    CachedModel model{"core", "motion_interpolator",   "sysc/cores/compiled_core.cpp", parameters,
                      {},     ref::kBoardSegmentWords, ref::kBoardProfileWords};
    CoreParameters simulated = parameters;
    simulated.multiplier_form = 0;  // products are the same, and no vendor's cells are needed
    std::istringstream text(ref::parameters_text(simulated));
    for (std::string word; text >> word;) model.parameters.push_back(word);
    return model;
}

/// Verilator's parameters of the top module.
std::vector<std::string> all_parameters(const CachedModel& model) {
    std::vector<std::string> all{fmt::format("Build={}", static_cast<int>(model.core.build)),
                                 fmt::format("SegmentQueueWords={}", model.segment_queue_words),
                                 fmt::format("ProfileQueueWords={}", model.profile_queue_words)};
    if (model.core.table) {
        all.push_back(fmt::format("Table={}", assembler::table_number(model.core)));
    }
    all.insert(all.end(), model.parameters.begin(), model.parameters.end());
    return all;
}

}  // namespace

CoreCache::CoreCache(const std::string& rtl, std::vector<std::string> dut)
    : sources_(shipped_files().folder),
      rtl_(rtl.empty() ? sources_ / "rtl" : fs::absolute(rtl)),
      dut_(std::move(dut)),
      cores_(sources_ / "build/cores") {
    if (shipped_files().installed) {
        const char* const cache = std::getenv("XDG_CACHE_HOME");
        const char* const home = std::getenv("HOME");
        cores_ = cache != nullptr && *cache != 0
                     ? fs::path(cache) / "curvecore"
                     : fs::path(home != nullptr ? home : ".") / ".cache/curvecore";
    }
    const char* const cores = std::getenv("CURVECORE_CORES");
    if (cores != nullptr && *cores != 0) cores_ = cores;
    cores_ = fs::absolute(cores_);
}

fs::path CoreCache::folder_of(const CachedModel& model, const CoreMicrocode& microcode) const {
    std::vector<fs::path> files;
    const fs::path own = sources_ / "rtl";
    for (const fs::path& folder : {rtl_, sources_ / "sysc/board", sources_ / "sysc/cores",
                                   sources_ / "sysc/virtual", sources_ / "sysc/cmake"}) {
        // A fork may have modules in .v, and includes of any name.
        const bool every = folder == rtl_ && rtl_ != own;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            const std::string kind = entry.path().extension();
            const bool read = every || kind == ".sv" || kind == ".hpp" || kind == ".sh";
            if (read && entry.is_regular_file()) files.push_back(entry.path());
        }
    }
    files.push_back(sources_ / model.source);
    std::sort(files.begin(), files.end());
    Digest digest;
    for (const fs::path& file : files) {
        digest.add(file.lexically_relative(sources_));
        digest.add(text_of(file));
    }
    if (!dut_.empty()) digest.add(dut_text());
    for (const std::string& parameter : all_parameters(model)) digest.add(parameter);
    digest.add(CURVECORE_VERILATOR_VERSION);
    digest.add(CURVECORE_CXX " " CURVECORE_CXX_VERSION);
    if (!microcode.empty()) {
        digest.add(microcode.text());
        digest.add(cores_);  // a core of another place reads its programs there
    }
    return cores_ / fmt::format("{}-{}", build_name(model.core.build), digest.text());
}

std::string CoreCache::sources_text() const {
    return dut_.empty() ? rtl_.string() : fmt::format("{}", fmt::join(dut_, ", "));
}

std::string CoreCache::dut_text() const {
    check_build_tools();
    std::vector<std::string> command{"verilator", "-E"};
    for (std::string& flag : dut_flags(dut_)) command.push_back(std::move(flag));
    const fs::path file = cores_ / fmt::format("dut.{}.txt", getpid());
    run_tool(command, file, cores_);  // what it refuses is said when it is made
    std::string text = text_of(file);
    fs::remove(file);
    return text;
}

void CoreCache::make(const CachedModel& model, const CoreMicrocode& microcode,
                     const fs::path& folder, bool quiet) const {
    check_build_tools();
    if (!quiet) {
        fmt::print(stderr, "curvecore: making the {} {} {}: once, {}; it is kept in {}\n",
                   model.kind, build_name(model.core.build), ref::parameters_text(model.core),
                   model.core.build == Build::kParallel ? "up to a minute" : "some 15 s",
                   cores_.string());
    }
    const auto begin = std::chrono::steady_clock::now();
    const fs::path work = folder.string() + ".tmp";
    const fs::path log = folder.string() + ".log";
    fs::remove_all(folder);
    fs::remove_all(work);
    std::vector<std::string> parameters = all_parameters(model);
    DutDesign dut{model.top, {}};
    if (!dut_.empty()) {
        WantedCore wanted{sources_ / "rtl", model.top, parameters};
        if (!microcode.empty()) {
            wanted.parameters.push_back(
                fmt::format("Program=\"{}\"", (folder / "program.hex").string()));
            wanted.parameters.push_back(fmt::format("Data=\"{}\"", (folder / "data.hex").string()));
        }
        const Scratch scratch(folder.string() + ".ports");
        dut = find_dut(dut_, wanted, scratch.folder(), log);
    }
    std::vector<std::string> command{"env",
                                     "VERILATOR=verilator",
                                     fmt::format("CXX={}", CURVECORE_CXX),
                                     fmt::format("CCACHE={}", in_path("ccache") ? "ccache" : ""),
                                     fmt::format("MICROCODE={}", folder.string()),
                                     fmt::format("RTL={}", rtl_.string()),
                                     fmt::format("DUT={}", fmt::join(dut.flags, " ")),
                                     sources_ / "sysc/cmake/make_core.sh",
                                     sources_,
                                     work / "model",
                                     dut.top,
                                     model.source};
    for (std::string& parameter : parameters) command.push_back(std::move(parameter));
    if (run_tool(command, log, dut_.empty() ? "." : cores_) != 0) {
        fs::remove_all(work);
        if (rtl_ != sources_ / "rtl" || !dut_.empty()) {
            throw UsageError(fmt::format("--{} {}: {}; all of it: {}", dut_.empty() ? "rtl" : "dut",
                                         sources_text(), reason_in(log), log.string()));
        }
        throw std::runtime_error(fmt::format("the {} could not be made: {}; see {}", model.kind,
                                             reason_in(log), log.string()));
    }
    if (folder_of(model, microcode) != folder) {
        fs::remove_all(work);
        throw UsageError(
            fmt::format("{}: files changed while the {} was made from them: run it again",
                        sources_text(), model.kind));
    }
    fs::rename(work / "model/core.so", work / "core.so");
    fs::remove_all(work / "model");
    microcode.write(work);
    std::ofstream(work / "core.sum") << digest_of(work / "core.so");
    fs::rename(work, folder);
    fs::remove(log);
    if (!quiet) {
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        fmt::print(stderr, "curvecore: made in {:.0f} s\n", time.count());
    }
}

MakeBoard* CoreCache::open(const CoreParameters& parameters, bool quiet) const {
    return reinterpret_cast<MakeBoard*>(open(core_model(parameters), quiet));
}

void* CoreCache::open(const CachedModel& model, bool quiet) const {
    fs::create_directories(cores_);
    const CoreMicrocode microcode(model.core,
                                  {model.segment_queue_words, model.profile_queue_words}, sources_,
                                  model.rate_bits);
    const fs::path folder = folder_of(model, microcode);
    const fs::path file = folder / "core.so";
    const Lock lock(folder.string() + ".lock", quiet);
    if (!fs::exists(file) || text_of(folder / "core.sum") != digest_of(file) ||
        !microcode.lies_in(folder)) {
        make(model, microcode, folder, quiet);
    }
    void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = library != nullptr ? dlsym(library, "curvecore_model") : nullptr;
    if (symbol == nullptr) throw std::runtime_error(fmt::format("cannot open {}", dlerror()));
    return symbol;
}

}  // namespace curvecore::sysc
