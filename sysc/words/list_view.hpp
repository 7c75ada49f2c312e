// SPDX-License-Identifier: Apache-2.0
// A list to be read, wherever it lies.
#pragma once

#include <vector>

#include "sysc/words/file_list.hpp"

namespace curvecore::sysc {

/// A view of a complete list, which must outlive it.
template <class T>
class ListView {
  public:
    explicit ListView(const std::vector<T>& list) : first_(list.data()), size_(list.size()) {}
    explicit ListView(const FileList<T>& list) : file_(&list), size_(list.size()) {}

    std::size_t size() const { return size_; }
    const T& operator[](std::size_t index) const {
        return file_ != nullptr ? (*file_)[index] : first_[index];
    }

  private:
    const FileList<T>* file_ = nullptr;
    const T* first_ = nullptr;
    std::size_t size_;
};

}  // namespace curvecore::sysc
