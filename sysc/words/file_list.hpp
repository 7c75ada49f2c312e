// SPDX-License-Identifier: Apache-2.0
// A list that grows to any length in little memory: a file without a name, mapped.
#pragma once

#ifdef __EMSCRIPTEN__

#include "sysc/words/memory_list.hpp"

namespace curvecore::sysc {
template <class T>
using FileList = MemoryList<T>;
}  // namespace curvecore::sysc

#else

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <new>
#include <system_error>
#include <type_traits>
#include <utility>

namespace curvecore::sysc {

/// A list that one thread appends to; then any number may read. References stay valid. Of any list
/// some megabytes are in memory, those touched last: the rest is in the file alone, and comes back
/// from there when it is read.
template <class T>
class FileList {
    static_assert(std::is_trivially_destructible_v<T>, "a file keeps bytes");

  public:
    FileList() = default;
    FileList(FileList&& other) noexcept { swap(other); }
    FileList& operator=(FileList&& other) noexcept {
        swap(other);
        return *this;
    }
    ~FileList() {
        if (first_ != nullptr) munmap(first_, kReserved);
        if (file_ != nullptr) std::fclose(file_);
    }

    /// Appends a value. @throws std::system_error: the disk is full, or cannot be written
    void push_back(const T& value) {
        if ((size_ + 1) * sizeof(T) > mapped_) grow();
        touch(size_);
        new (first_ + size_) T(value);
        ++size_;
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const T& operator[](std::size_t index) const {
        touch(index);
        return first_[index];
    }
    const T& front() const { return (*this)[0]; }
    const T& back() const { return (*this)[size_ - 1]; }

  private:
    static constexpr std::size_t kBlock = std::size_t(1) << 16;  // bytes: a fault maps no more
    static constexpr std::size_t kBlocks = 32;                   // of a list in memory, at most
    static constexpr std::size_t kLeast = std::size_t(1) << 16;  // bytes at once
    static constexpr std::size_t kMost = std::size_t(1) << 22;
    static constexpr std::size_t kReserved = std::size_t(1) << 38;  // address space, bytes

    /// Counts blocks as they are touched, and releases all of them when they are too many.
    void touch(std::size_t index) const {
        const std::size_t block = index * sizeof(T) / kBlock + 1;
        std::atomic<std::size_t>& held = held_[block % kBlocks];
        if (held.load(std::memory_order_relaxed) == block) return;
        if (touched_.fetch_add(1, std::memory_order_relaxed) >= kBlocks) let_go();
        held.store(block, std::memory_order_relaxed);
    }

    void let_go() const {
        for (std::atomic<std::size_t>& held : held_) held.store(0, std::memory_order_relaxed);
        touched_.store(1, std::memory_order_relaxed);
        if (mapped_ > 0) madvise(first_, mapped_, MADV_DONTNEED);
    }

    void grow() {
        if (file_ == nullptr) open();
        const std::size_t more = std::clamp(mapped_, kLeast, kMost);
        // Space is reserved on the disk now: a mapping that finds none later ends the process.
        const int error =
            posix_fallocate(fileno(file_), static_cast<off_t>(mapped_), static_cast<off_t>(more));
        if (error != 0) fail(error);
        void* const at = reinterpret_cast<char*>(first_) + mapped_;
        if (mmap(at, more, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, fileno(file_),
                 static_cast<off_t>(mapped_)) == MAP_FAILED) {
            fail(errno);
        }
        mapped_ += more;
    }

    void open() {
        file_ = std::tmpfile();
        if (file_ == nullptr) fail(errno);
        void* const at =
            mmap(nullptr, kReserved, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (at == MAP_FAILED) fail(errno);
        first_ = static_cast<T*>(at);
    }

    [[noreturn]] static void fail(int error) {
        throw std::system_error(error, std::generic_category(), "a plan's temporary file");
    }

    void swap(FileList& other) noexcept {
        std::swap(file_, other.file_);
        std::swap(first_, other.first_);
        std::swap(mapped_, other.mapped_);
        std::swap(size_, other.size_);
        let_go();
        other.let_go();
    }

    std::FILE* file_ = nullptr;
    T* first_ = nullptr;
    std::size_t mapped_ = 0;  // bytes
    std::size_t size_ = 0;
    mutable std::array<std::atomic<std::size_t>, kBlocks> held_{};  // the blocks, from 1; 0: none
    mutable std::atomic<std::size_t> touched_ = 0;
};

}  // namespace curvecore::sysc

#endif
