// SPDX-License-Identifier: Apache-2.0
// Records of the archive are those of the ZIP file format (APPNOTE 6.3.10, 4.3.7 to 4.3.16), method
// 0, stored; an array is as numpy.lib.format says, version 1.0.
#include "sysc/formats/npz_file.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/crc.hpp>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace curvecore::sysc {
namespace {

constexpr std::size_t kAligned = 64;    // where an array's numbers begin
constexpr std::size_t kAtOnce = 8192;   // numbers that are written
constexpr std::uint16_t kVersion = 20;  // of the format that is needed to read it
constexpr std::uint16_t kDate = 0x21;   // 1980-01-01: the same file again for the same arrays

/// A record of bytes: numbers have the lowest first.
class Record {
  public:
    Record& add(std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) text_ += static_cast<char>(value >> 8 * i & 0xFF);
        return *this;
    }
    Record& add(const std::string& text) {
        text_ += text;
        return *this;
    }
    const std::string& text() const { return text_; }
    void clear() { text_.clear(); }

  private:
    std::string text_;
};

/// The head of an array's file.
std::string npy_head(const char* type, const std::vector<std::size_t>& shape) {
    std::string sizes;
    for (const std::size_t size : shape) sizes += fmt::format("{}, ", size);
    std::string text =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, sizes);
    constexpr std::size_t kBefore = 10;
    text.resize((kBefore + text.size() + kAligned) / kAligned * kAligned - kBefore - 1, ' ');
    text += '\n';
    Record head;
    head.add("\x93NUMPY").add(1, 1).add(0, 1).add(text.size(), 2).add(text);
    return head.text();
}

/// Adds the fields that both records of a file of the archive have.
Record& add_entry(Record& record, std::uint32_t crc, std::uint32_t bytes, std::size_t name) {
    return record.add(kVersion, 2)
        .add(0, 2)
        .add(0, 2)
        .add(0, 2)
        .add(kDate, 2)
        .add(crc, 4)
        .add(bytes, 4)
        .add(bytes, 4)
        .add(name, 2)
        .add(0, 2);
}

}  // namespace

void NpzFile::write_local(const Entry& entry) {
    Record record;
    record.add("PK\x03\x04");
    add_entry(record, entry.crc, entry.bytes, entry.name.size()).add(entry.name);
    stream_ << record.text();
}

void NpzFile::add(const std::string& name, const char* type, const std::vector<std::size_t>& shape,
                  const std::function<std::uint64_t(std::size_t)>& value) {
    const std::string head = npy_head(type, shape);
    const std::size_t count =
        std::accumulate(shape.begin(), shape.end(), std::size_t(1), std::multiplies<>());
    const std::streamoff place = stream_.tellp();
    Entry entry{name + ".npy", 0, static_cast<std::uint32_t>(head.size() + 8 * count),
                static_cast<std::uint32_t>(place)};
    write_local(entry);
    boost::crc_32_type crc;
    crc.process_bytes(head.data(), head.size());
    stream_ << head;
    Record part;
    for (std::size_t at = 0; at < count;) {
        part.clear();
        for (const std::size_t end = std::min(count, at + kAtOnce); at < end; ++at) {
            part.add(value(at), 8);
        }
        crc.process_bytes(part.text().data(), part.text().size());
        stream_ << part.text();
    }
    entry.crc = crc.checksum();
    stream_.seekp(place);  // the record before it has the checksum
    write_local(entry);
    stream_.seekp(0, std::ios::end);
    entries_.push_back(std::move(entry));
}

void NpzFile::close() {
    Record list;
    for (const Entry& entry : entries_) {
        list.add("PK\x01\x02").add(kVersion, 2);
        add_entry(list, entry.crc, entry.bytes, entry.name.size());
        list.add(0, 2).add(0, 2).add(0, 2).add(0, 4).add(entry.place, 4).add(entry.name);
    }
    const std::streamoff place = stream_.tellp();
    Record end;
    end.add("PK\x05\x06").add(0, 2).add(0, 2).add(entries_.size(), 2).add(entries_.size(), 2);
    end.add(list.text().size(), 4).add(static_cast<std::uint64_t>(place), 4).add(0, 2);
    stream_ << list.text() << end.text();
    stream_.close();
    if (!stream_) throw std::runtime_error("cannot write an .npz: is the disk full?");
}

}  // namespace curvecore::sysc
