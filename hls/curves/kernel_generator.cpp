// SPDX-License-Identifier: Apache-2.0
// kernel_generator FOLDER FILE.net ..: the kernels of tables, FOLDER/NAME.hpp.
#include <cstdio>
#include <exception>
#include <fstream>

#include "hls/curves/kernel_text.hpp"
#include "ref/curves/table_reader.hpp"
#include "ref/text/text_file.hpp"

int main(int argc, char** argv) {
    using namespace curvecore;
    try {
        for (int n = 2; n < argc; ++n) {
            const std::string file = argv[n];
            const std::string text = ref::read_text_file(file);
            const ref::CurveTable table = ref::read_network_text(file, text);
            const std::string to = std::string(argv[1]) + "/" + table.name + ".hpp";
            std::ofstream out(to);
            out << hls::kernel_text(table, text);
            if (!out.flush()) throw std::runtime_error(to + ": cannot be written");
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kernel_generator: %s\n", error.what());
        return 1;
    }
    return argc > 2 ? 0 : 2;
}
