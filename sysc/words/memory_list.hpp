// SPDX-License-Identifier: Apache-2.0
// A list of the functions of FileList (sysc/words/file_list.hpp), where no file can be mapped: in
// WebAssembly.
#pragma once

#include <cstddef>
#include <vector>

namespace curvecore::sysc {

/// A list in memory, one value behind the other. References are valid until a value is appended.
template <class T>
class MemoryList {
  public:
    void push_back(const T& value) { values_.push_back(value); }

    std::size_t size() const { return values_.size(); }
    bool empty() const { return values_.empty(); }
    const T& operator[](std::size_t index) const { return values_[index]; }
    const T& front() const { return values_.front(); }
    const T& back() const { return values_.back(); }

  private:
    std::vector<T> values_;
};

}  // namespace curvecore::sysc
