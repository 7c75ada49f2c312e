// SPDX-License-Identifier: Apache-2.0
// `curvecore words`: memory files for $readmemh, and further data for a test bench.
#include <fmt/format.h>

#include <optional>

#include "ref/text/input_error.hpp"
#include "sysc/commands/options/part_options.hpp"
#include "sysc/commands/options/typed_option.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/part/word_files.hpp"
#include "sysc/commands/terminal/device_clock.hpp"
#include "sysc/commands/terminal/json_result.hpp"
#include "sysc/commands/terminal/summary.hpp"
#include "sysc/curves/word_check.hpp"
#include "sysc/job/job_stream.hpp"
#include "sysc/wire/wire_options.hpp"

namespace curvecore::sysc {
namespace {

/// Writes where planning failed after the first words; these end at rest before the failure.
void write_incomplete(const OutputFolder& folder, const ref::InputError& error) {
    folder.write("INCOMPLETE", std::string(error.what()) + "\n");
}

struct WordsOptions {
    PartOptions part;
    std::string board;  // link; empty: not given
};

int words_command(WordsOptions& asked) {
    Options options = asked.part.complete();
    if (!asked.board.empty()) take_board(asked.board, options);
    JobStream stream(options);
    take_device(stream.options());
    OutputFolder folder(options.folder);
    WordFiles files(folder);
    std::optional<ref::InputError> failed;
    try {
        while (const ref::Plan* part = stream.next()) {
            check_words(stream.job(), *part);
            files.add(stream.job(), *part);
        }
    } catch (const ref::InputError& error) {
        if (files.empty()) throw;
        failed = error;
        write_incomplete(folder, error);
    }
    const Job& job = stream.job();
    files.close(job);
    folder.commit();
    if (options.json) {
        print_json(files.json(job));
    } else if (!options.quiet) {
        fmt::print("{}", files.summary(job));
    }
    print_warnings(job);
    if (failed) throw *failed;
    return 0;
}

}  // namespace

void add_words(CLI::App& app, int& status) {
    auto [command, asked] =
        add_command(app, status, "words", "segment and profile words as memory files for $readmemh",
                    words_command);
    add_common(command, asked.part);
    add_text(command, "--to", asked.board, "BOARD",
             "for this board, which is asked for its core, clock, sample period and queues");
}

}  // namespace curvecore::sysc
