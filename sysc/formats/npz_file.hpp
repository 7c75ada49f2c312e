// SPDX-License-Identifier: Apache-2.0
// A file of arrays as numpy.load() reads it: an archive of .npy files, which are not compressed.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace curvecore::sysc {

class NpzFile {
  public:
    /// Most bytes of a file: places in an archive have 32 bits.
    static constexpr std::uint64_t kMostBytes = 0xFFFF'0000;

    explicit NpzFile(const std::string& path) : stream_(path, std::ios::binary) {}

    /// Adds an array of 64-bit numbers, int64 or uint64 as the list has them.
    /// @param shape its sizes, the last one the fastest; their product is that of the list
    template <class List>
    void add(const std::string& name, const std::vector<std::size_t>& shape, const List& values) {
        using Value = std::decay_t<decltype(values[0])>;
        static_assert(sizeof(Value) == sizeof(std::uint64_t));
        add(name, std::is_signed_v<Value> ? "<i8" : "<u8", shape,
            [&values](std::size_t at) { return static_cast<std::uint64_t>(values[at]); });
    }
    /// @throws std::runtime_error when not all of it could be written
    void close();

  private:
    struct Entry {
        std::string name;
        std::uint32_t crc;
        std::uint32_t bytes;
        std::uint32_t place;
    };

    void add(const std::string& name, const char* type, const std::vector<std::size_t>& shape,
             const std::function<std::uint64_t(std::size_t)>& value);
    void write_local(const Entry& entry);

    std::ofstream stream_;
    std::vector<Entry> entries_;
};

}  // namespace curvecore::sysc
