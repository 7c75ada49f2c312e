// SPDX-License-Identifier: Apache-2.0
// Microcode on the twin (hls/engine.hpp), program by program.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hls/engine.hpp"
#include "hls/words.hpp"
#include "rtl/engine/assembler/assembly.hpp"
#include "tb/support/programs/long_form.hpp"

namespace curvecore::tb {

/// Index of a limb of the word at a place.
inline std::size_t limb_of(int place, int limb) {
    return engine::kWordLimbs * static_cast<std::size_t>(place) + static_cast<std::size_t>(limb);
}

/// Writes the table of rtl/engine/programs/powers.asm.
inline void write_powers(std::vector<std::int16_t>& memory) {
    constexpr int kPowers = 60;
    memory.resize(std::max(memory.size(), std::size_t{engine::kWordLimbs} * kPowers));
    for (int n = 0; n < kPowers; ++n) {
        for (int limb = 0; limb < engine::kWordLimbs; ++limb) {
            const int bit = n - engine::kLimbBits * limb;
            memory[limb_of(n, limb)] =
                static_cast<std::int16_t>(bit >= 0 && bit < engine::kLimbBits ? 1 << bit : 0);
        }
    }
}

/// Returns whether a profile's word may go to its queue's begin: a piece's others follow the first.
inline bool may_wrap(std::uint64_t word) {
    const auto tag = static_cast<hls::Tag>(hls::get(hls::kTagField, word));
    return tag == hls::Tag::kPiece || tag == hls::Tag::kStop || tag == hls::Tag::kStep;
}

/// Returns what the profile's queue keeps of a word: 46 signed bits, a ds or a coefficient.
inline std::int64_t queued(std::uint64_t word) {
    const auto tag = static_cast<hls::Tag>(hls::get(hls::kTagField, word));
    const auto low = [word](int bits) {
        return static_cast<std::int64_t>(word << (64 - bits)) >> (64 - bits);
    };
    if (tag == hls::Tag::kDs) return static_cast<std::int64_t>(hls::get(hls::kLengthField, word));
    return low(tag >= hls::Tag::kC1 && tag <= hls::Tag::kC3 ? hls::kCoefField.bits : 46);
}

/// The board around the engine, as far as a test makes it: the memory behind it, and what else is
/// at its ports (rtl/engine/programs/ports.asm).
struct MicrocodePorts {
    std::vector<std::int16_t> memory;
    std::uint32_t address = 0;
    std::function<std::int16_t(int port, int limb)> give;
    std::function<void(int port, int limb, std::int16_t value)> take;
    std::function<bool(int code)> condition;

    std::int16_t in(int port, int limb) {
        if (port == kMemory) return limb_there();
        return give ? give(port, limb) : std::int16_t{0};
    }
    void out(int port, int limb, std::int16_t value) {
        const auto bits = static_cast<std::uint32_t>(value & 0x7fff);
        if (port == kMemory) {
            limb_there() = value;
        } else if (port == kAddress) {
            address = limb == 0 ? bits : address | bits << engine::kLimbBits;
        } else if (take) {
            take(port, limb, value);
        }
    }

  private:
    static constexpr int kMemory = 3;
    static constexpr int kAddress = 4;

    std::int16_t& limb_there() {
        if (address >= memory.size()) throw std::runtime_error("no such place in the memory");
        return memory[address++];
    }
};

/// A digest of all that programs do: values that are read and put out, and clocks.
class MicrocodeTrace {
  public:
    void add(std::uint64_t value) { sum_ = (sum_ ^ value) * 0x100000001b3u + (sum_ >> 40); }
    bool operator==(const MicrocodeTrace& other) const { return sum_ == other.sum_; }

  private:
    std::uint64_t sum_ = 0;
};

/// Programs of an assembly, begun by the background when a board's condition asks for them.
class MicrocodeMachine {
  public:
    static constexpr int kFirstRequest = engine::kBoard;

    /// Writes what begins the programs of these labels; they end at `idle`, or give back.
    static void dispatch(assembler::Assembly& assembly, const std::vector<std::string>& labels) {
        assembly.from({"dispatch", 0, ""});
        assembly.branch("idle");
        assembly.branch("idle");  // the foreground
        assembly.label("idle");
        assembly.open_auxiliary();  // a page that no program finds open
        assembly.open_further();
        for (std::size_t n = 0; n < labels.size(); ++n) {
            assembly.branch(labels[n], engine::kCall | (kFirstRequest + static_cast<int>(n)));
        }
        assembly.branch("idle");
        assembly.label("dispatched");
    }

    MicrocodeMachine(const assembler::Assembly& assembly, std::vector<std::uint32_t> program,
                     MicrocodeTrace* trace = nullptr)
        : assembly_(assembly),
          dispatched_(static_cast<int>(assembly.labels().at("dispatched"))),
          idle_(static_cast<int>(assembly.labels().at("idle"))),
          at_first_(memory_of(assembly)),
          engine_(std::move(program), at_first_) {
        board_.trace = trace;
    }
    explicit MicrocodeMachine(const assembler::Assembly& assembly)
        : MicrocodeMachine(assembly, assembly.program()) {}

    /// Executes a program; returns its clocks. @throws std::runtime_error if it does not end, ends
    /// elsewhere, or leaves another page X open where that has words beyond
    int run(int request) {
        board_.request = kFirstRequest + request;
        int back = 0;
        while (engine_.place(false) < dispatched_) {
            back = engine_.place(false) + 1;
            engine_.step(board_);
        }
        board_.request = -1;
        const std::uint64_t begin = engine_.clock();
        const int x = engine_.page(false, false);
        while (engine_.place(false) >= dispatched_) {
            engine_.step(board_);
            if (engine_.clock() - begin > most_clocks_) throw std::runtime_error("no end");
        }
        if (engine_.place(false) != back && engine_.place(false) != idle_) {
            throw std::runtime_error("it ends elsewhere");
        }
        if (assembly_.size().data > 256 && engine_.page(false, false) != x) {
            throw std::runtime_error("another page X");
        }
        const auto clocks = static_cast<int>(engine_.clock() - begin);
        if (board_.trace != nullptr) board_.trace->add(static_cast<std::uint64_t>(clocks));
        return clocks;
    }

    /// Executes the reset's program, which finds anything in the words that it gives values.
    void reset(int request) {
        for (const assembler::Start& start : assembly_.starts()) {
            std::fill_n(at(start.field.name, 0), start.limbs, kAnything);
        }
        run(request);
        for (const assembler::Start& start : assembly_.starts()) {
            std::int64_t value = start.value;
            if (!start.label.empty()) {
                value = static_cast<std::int64_t>(assembly_.labels().at(start.label));
            }
            const std::int16_t* const limbs = at(start.field.name, 0);
            for (int limb = 0; limb < start.limbs; ++limb) {
                const std::int64_t digit = limb + 1 < start.limbs ? value & 0x7fff : value;
                starts_hold_ = starts_hold_ && limbs[limb] == digit;
                value >>= engine::kLimbBits;
            }
        }
    }
    /// Returns whether every reset gave all words their values.
    bool starts_hold() const { return starts_hold_; }

    void set(const std::string& word, std::int64_t value, int axis = 0) {
        std::int16_t* limbs = at(word, axis);
        limbs[0] = static_cast<std::int16_t>(value & 0x7fff);
        limbs[1] = static_cast<std::int16_t>(value >> 15 & 0x7fff);
        limbs[2] = static_cast<std::int16_t>(value >> 30);
    }
    std::int64_t get(const std::string& word, int axis = 0) {
        const std::int16_t* limbs = at(word, axis);
        return limbs[0] + limbs[1] * (std::int64_t{1} << 15) + limbs[2] * (std::int64_t{1} << 30);
    }
    bool hazard() const { return engine_.hazard(); }
    /// Writes anything into the words that the sources' locals share, as other programs do.
    void spoil_locals(std::mt19937_64& random) {
        for (const auto& [place, datum] : assembly_.data()) {
            if (datum.name.rfind("scratch ", 0) != 0) continue;
            const std::uint64_t bits = random() % 2 == 0 ? 0 : 0x7fff;
            for (int limb = 0; limb < engine::kWordLimbs; ++limb) {
                engine_.memory()[limb_of(place, limb)] = static_cast<std::int16_t>(random() & bits);
            }
        }
    }
    /// Returns whether a program wrote where no word has a name.
    bool strays() {
        const std::vector<std::int16_t>& memory = engine_.memory();
        for (std::size_t limb = 0; limb < memory.size(); ++limb) {
            if (at_first_[limb] == kAnything && memory[limb] != kAnything) return true;
        }
        return false;
    }

    /// The board that the programs find.
    MicrocodePorts& ports() { return board_.ports; }

  private:
    /// One sample of many may go through hundreds of segments.
    std::uint64_t most_clocks_ = static_cast<std::uint64_t>(cases(200'000, 50'000'000));
    static constexpr std::int16_t kAnything = 0x2aaa;

    struct Board : engine::QuietBoard {
        int request = -1;
        MicrocodePorts ports;
        MicrocodeTrace* trace = nullptr;
        bool condition(int code, std::uint64_t) const {
            return request >= 0 ? code == request : ports.condition && ports.condition(code);
        }
        std::int16_t in(int port, int limb, std::uint64_t) { return ports.in(port, limb); }
        void out(int port, int limb, std::int16_t value, std::uint64_t) {
            ports.out(port, limb, value);
            if (trace != nullptr)
                trace->add(4 * static_cast<std::uint64_t>(port) + static_cast<std::uint64_t>(limb));
        }
        void read(std::int16_t limb, std::uint64_t) {
            if (trace != nullptr) trace->add(static_cast<std::uint16_t>(limb));
        }
    };

    /// The data at first; what stands in words that have no name is not 0.
    static std::vector<std::int16_t> memory_of(const assembler::Assembly& assembly) {
        std::vector<std::int16_t> memory = assembly.memory();
        std::vector<bool> named(memory.size());
        const auto name = [&](int place, int words) {
            std::fill_n(named.begin() + std::ptrdiff_t{engine::kWordLimbs} * place,
                        std::ptrdiff_t{engine::kWordLimbs} * words, true);
        };
        name(0, engine::kConstantWords);
        for (const auto& [place, datum] : assembly.data()) {
            for (int axis = 0; axis < assembler::kAxes; ++axis) {
                name(assembly.place(datum.name, axis), datum.words);
            }
        }
        for (std::size_t limb = 0; limb < memory.size(); ++limb) {
            if (!named[limb]) memory[limb] = kAnything;
        }
        return memory;
    }

    std::int16_t* at(const std::string& word, int axis) {
        const auto known = places_.try_emplace({word, axis}, 0);
        if (known.second) known.first->second = assembly_.place(word, axis);
        return &engine_.memory()[limb_of(known.first->second, 0)];
    }

    const assembler::Assembly& assembly_;
    int dispatched_;
    int idle_;
    bool starts_hold_ = true;
    std::vector<std::int16_t> at_first_;
    engine::Engine engine_;
    Board board_;
    std::map<std::pair<std::string, int>, int> places_;
};

}  // namespace curvecore::tb
