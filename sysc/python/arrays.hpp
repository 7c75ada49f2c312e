// SPDX-License-Identifier: Apache-2.0
// Vectors as numpy arrays, which own them.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <initializer_list>
#include <utility>
#include <vector>

namespace curvecore::sysc {

template <class T>
using Array = nanobind::ndarray<nanobind::numpy, T>;

/// Moves a vector into an array of that shape; the product of its sizes is the vector's.
template <class T>
Array<T> to_array(std::vector<T>&& values, std::initializer_list<std::size_t> shape) {
    auto* const kept = new std::vector<T>(std::move(values));
    const nanobind::capsule owner(
        kept, [](void* of) noexcept { delete static_cast<std::vector<T>*>(of); });
    return Array<T>(kept->data(), shape, owner);
}

template <class T>
Array<T> to_array(std::vector<T>&& values) {
    const std::size_t size = values.size();
    return to_array(std::move(values), {size});
}

}  // namespace curvecore::sysc
