// SPDX-License-Identifier: Apache-2.0
// The program curvecore: parts through the cores, from the command line.
//
// Exit status: 0 done and every check held; 1 a check failed, or a board gives no samples; 2 the
// input or the command line is invalid, and nothing was written; 3 choose, explore: no
// configuration meets the request; 130 interrupted, nothing written (compare: the finished rows
// are).
#include <fmt/format.h>

#include <system_error>

#include "ref/text/input_error.hpp"
#include "sysc/board/board.hpp"
#include "sysc/cli/interrupt.hpp"
#include "sysc/cli/usage_error.hpp"
#include "sysc/commands/board/commands.hpp"
#include "sysc/commands/part/commands.hpp"
#include "sysc/commands/terminal/completion.hpp"
#include "sysc/commands/terminal/config_file.hpp"
#include "sysc/commands/terminal/help.hpp"
#include "sysc/commands/widths/commands.hpp"
#include "sysc/curvecore/commands.hpp"

namespace curvecore::sysc {

int run(std::vector<std::string> arguments) {
    CLI::App app{"Lines, arcs, helices and splines through FPGA interpolator cores", "curvecore"};
    app.set_version_flag("--version", "curvecore " CURVECORE_PROGRAM_VERSION);
    app.require_subcommand(1);
    begin_help(app);
    int status = 0;
    for (const auto add :
         {add_run, add_plan, add_words, add_vectors, add_cam, add_join, add_compare, add_choose,
          add_stream, add_home, add_board, add_explore, add_curve, add_completion}) {
        add(app, status);
    }
    add_config(app);
    const ConfigFile config(app, std::move(arguments));
    config.report();
    try {
        parse(app, config.arguments());
    } catch (const UsageError& error) {
        config.place(error);
        throw;
    }
    return status;
}

}  // namespace curvecore::sysc

int main(int argc, char** argv) {
    using namespace curvecore;
    const auto fail = [](int status, const char* kind, const std::exception& error) {
        fmt::print(stderr, "{}{}\n", kind, error.what());
        return status;
    };
    try {
        return sysc::run({argv + 1, argv + argc});
    } catch (const ref::InputError& error) {
        return fail(2, "", error);
    } catch (const sysc::UsageError& error) {
        return fail(2, "curvecore: error: ", error);
    } catch (const sysc::BoardError& error) {
        return fail(1, "curvecore: error: ", error);
    } catch (const sysc::Interrupted&) {
        return 130;
    } catch (const std::system_error& error) {  // a disk that is full
        return fail(2, "curvecore: error: ", error);
    } catch (const std::exception& error) {
        return fail(1, "curvecore: internal error: ", error);
    }
}
