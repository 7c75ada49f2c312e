// SPDX-License-Identifier: Apache-2.0
// Tables of arc and spline, run in words: the kernels' words, bit for bit, in every configuration
// of tb/configurations.csv. A line that is left out, or a sign or a fraction that is changed, is
// seen.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "ref/text/input_error.hpp"
#include "sysc/kernel/table_kernel.hpp"
#include "tb/support/microcode/curve_comparison.hpp"
#include "tb/support/microcode/microcode_configurations.hpp"

namespace curvecore::tb::table_machine_test {

std::string text_of(const CurveCase& of) {
    const std::string name = of.spline ? "spline" : "arc";
    std::ifstream file(std::string(CURVES_DIR) + "/" + name + ".net");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Kernels whose series are compared, too: visit(row, axis, order, word).
struct SplineWords : OpenSpline<sysc::RunTimeFormat> {
    using OpenSpline<sysc::RunTimeFormat>::OpenSpline;

    template <class Visit>
    void series(int order, Visit&& visit) const {
        for (int i = 0; i < order; ++i) visit("phi", 0, i, phi_[i]);
        for (int i = 0; i < order - 1; ++i) visit("Q", 0, i, Q_[i]);
        for (int i = 1; i <= order; ++i) visit("q", 0, i, q_[i]);
        for (int axis = 0; axis < 3 && order > 2; ++axis) visit("V", axis, 1, V_[axis][1]);
    }
};
struct ArcWords : hls::ArcCurve<sysc::RunTimeFormat> {
    using hls::ArcCurve<sysc::RunTimeFormat>::ArcCurve;
    template <class Visit>
    void series(int, Visit&&) const {}
};

/// Words that differ from a kernel's, of random segments.
class Comparison {
  public:
    Comparison(const CurveCase& of, const ref::CurveTable& table)
        : of_(of), format_(of.core, of.core.axes()), drawn_(table, format_) {}

    int segment(std::mt19937_64& random, int steps, int samples) {
        return of_.spline ? compare<SplineWords>(random, steps, samples)
                          : compare<ArcWords>(random, steps, samples);
    }

  private:
    template <class Kernel>
    int compare(std::mt19937_64& random, int steps, int samples) {
        const sysc::RunSegment words = random_segment(of_, random);
        Kernel kernel(format_);
        kernel.load(words);
        drawn_.load(words);
        int differ = 0;
        for (int step = 0; step < steps; ++step) {
            if (step > 0) {
                kernel.step();
                drawn_.step();
            }
            kernel.series(of_.core.order, [&](const char* row, int axis, int i, std::int64_t word) {
                differ += drawn_.word(row, i, axis) == word ? 0 : 1;
            });
            for (int sample = 0; sample < samples; ++sample) {
                const int bits = words.step_exponent + hls::kPathFrac;
                const std::uint64_t sigma = sample == 0 ? 0 : random() % (std::uint64_t{1} << bits);
                std::int64_t fine[sysc::kMostAxes];
                std::int64_t of_table[3];
                kernel.sample(static_cast<std::int64_t>(sigma), fine);
                drawn_.sample(static_cast<std::int64_t>(sigma), of_table);
                for (int axis = 0; axis < 3; ++axis) differ += fine[axis] == of_table[axis] ? 0 : 1;
            }
        }
        return differ;
    }

    CurveCase of_;
    sysc::RunTimeFormat format_;
    sysc::TableKernel drawn_;
};

/// Samples that differ, of so many segments; those behind the first that has some are not drawn.
int differ(const CurveCase& of, const ref::CurveTable& table, int segments) {
    Comparison comparison(of, table);
    std::mt19937_64 random(7);
    int sum = 0;
    for (int n = 0; n < segments && sum == 0; ++n) sum = comparison.segment(random, 3, 3);
    return sum;
}

TEST(TableMachine, DrawsTheKernelsWordsInEveryConfiguration) {
    int seen = 0;
    for (const CurveCase& of : configurations(false)) {
        const ref::CurveTable table = ref::read_curve_text("", text_of(of));
        EXPECT_EQ(differ(of, table, 4), 0) << text(of);
        ++seen;
    }
    EXPECT_GT(seen, 100);
}

/// Texts of a table with one line changed: left out, a term's sign turned, a fraction one off.
std::vector<std::string> changed(const std::string& table) {
    std::vector<std::string> lines;
    std::istringstream stream(table);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    std::vector<std::string> all;
    const std::regex made(R"(^  \S+ : ([+-]?\d+) \+?= .*)");
    for (std::size_t at = 0; at < lines.size(); ++at) {
        std::smatch match;
        if (!std::regex_match(lines[at], match, made)) continue;
        const auto with = [&](const std::string& line) {
            std::string text;
            for (std::size_t n = 0; n < lines.size(); ++n) {
                text += (n == at ? line : lines[n]) + "\n";
            }
            all.push_back(text);
        };
        const std::string line = lines[at].substr(0, lines[at].find('#'));
        with("");
        const std::size_t body = line.find('=') + 1;
        with(line.substr(0, body) +
             (line[body + 1] == '-' ? line.substr(body + 2) : " - " + line.substr(body)));
        for (std::size_t term = line.find(" + ", body); term != std::string::npos;
             term = line.find(" + ", term + 1)) {
            with(line.substr(0, term) + " - " + line.substr(term + 3));
        }
        for (const int by : {-1, 1}) {
            with(line.substr(0, static_cast<std::size_t>(match.position(1))) +
                 std::to_string(std::stoi(match[1]) + by) + " " +
                 line.substr(line.find_first_of("+=", body - 3)));
        }
    }
    return all;
}

/// Changes that change no value: what is exact has no use for more bits; -0 is 0.
constexpr const char* kSame[] = {"z.1 : -2 = -  0",           "sum_N[k] : -1 = sum(N[k])",
                                 "sum_T[k] : -1 = sum(T[k])", "move[k] : -1 = sum(c[k])",
                                 "three_a[k] : -1 =",         "moved : -1 = sum(q)"};

TEST(TableMachine, AChangedLineIsSeen) {
    for (const bool spline : {false, true}) {
        int refused = 0;
        int seen = 0;
        for (const std::string& text : changed(text_of({spline, {}}))) {
            int samples = 0;
            try {
                const ref::CurveTable table = ref::read_curve_text("", text);
                for (const int anchor : {1, 0}) {
                    for (const int mode : {0, 1}) {
                        CurveCase of{spline, {}};
                        of.core.mode = mode;
                        of.core.anchor = anchor;
                        of.core.parameter_guard = anchor * 4;
                        if (samples == 0) samples = differ(of, table, anchor == 1 ? 250 : 50);
                    }
                }
            } catch (const ref::InputError&) {
                ++refused;
                continue;
            }
            const bool same =
                std::any_of(std::begin(kSame), std::end(kSame),
                            [&](const char* line) { return text.find(line) != std::string::npos; });
            EXPECT_EQ(samples == 0, same) << text.substr(text.find("anchor"));
            ++seen;
        }
        EXPECT_GT(seen, spline ? 100 : 40);
        EXPECT_GT(refused, 10);
    }
}

}  // namespace curvecore::tb::table_machine_test
