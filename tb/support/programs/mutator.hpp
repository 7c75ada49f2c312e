// SPDX-License-Identifier: Apache-2.0
// Random mutations of valid texts, which readers must refuse, or read soundly.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace curvecore::tb {

/// Number of cases of a test: `standard`, or CURVECORE_MUTATIONS (scripts/campaign.sh).
inline int mutations(int standard) {
    const char* asked = std::getenv("CURVECORE_MUTATIONS");
    return asked == nullptr ? standard : std::stoi(asked);
}

/// A reproducible random mutator of texts.
class Mutator {
  public:
    /// Creates a mutator; `pieces` are the texts that it inserts.
    Mutator(std::vector<std::string> samples, std::vector<std::string> pieces)
        : samples_(std::move(samples)), pieces_(std::move(pieces)) {}

    std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

    /// An excerpt of up to 30 lines of a sample, usually from its start.
    std::string excerpt() {
        const std::string& sample = samples_[below(samples_.size())];
        std::size_t begin = 0;
        if (below(4) == 0) {
            begin = sample.find('\n', below(sample.size())) + 1;
        }
        std::size_t end = begin;
        for (std::size_t lines = 1 + below(30); lines > 0 && end < sample.size(); --lines) {
            end = std::min(sample.find('\n', end), sample.size() - 1) + 1;
        }
        return sample.substr(begin, end - begin);
    }

    void mutate(std::string& text) {
        const std::size_t at = below(text.size() + 1);
        const std::size_t length = 1 + below(below(4) == 0 ? 20 : 3);
        switch (below(7)) {
            case 0:
                text.erase(at, length);
                break;
            case 1:
                text.insert(at, 1, static_cast<char>(below(256)));
                break;
            case 2:
                if (at < text.size()) {
                    text[at] = static_cast<char>(below(2) == 0 ? '0' + below(10) : below(128));
                }
                break;
            case 3:
                text.insert(at, text.substr(below(text.size() + 1), length));
                break;
            case 4:
                text += excerpt();
                break;
            default:
                text.insert(at, pieces_[below(pieces_.size())]);
        }
    }

  private:
    std::vector<std::string> samples_;
    std::vector<std::string> pieces_;
    std::mt19937_64 random_{20240607};
};

}  // namespace curvecore::tb
