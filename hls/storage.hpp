// SPDX-License-Identifier: Apache-2.0
// Storage of a word, chosen once for all kernels of a translation unit:
//
//   | macro             | storage                                                               |
//   |-------------------|-----------------------------------------------------------------------|
//   | (none)            | native integers, the fast one: values out of range stay as they are   |
//   | CURVECORE_CHECKED | native integers that throw std::range_error when a value leaves its   |
//   |                   | word's range                                                          |
//   | CURVECORE_AC_INT  | ac_int                                                                |
//   | CURVECORE_AP_INT  | ap_int                                                                |
//   | CURVECORE_BIT_INT | _BitInt, as clang has it; with -fwrapv                                 |
//
// All give the same bits while every value is within its word's range. Each has an inline namespace
// of its own, so that one program may use two of them.
#pragma once

#if defined(CURVECORE_AC_INT)
#define CURVECORE_STORAGE ac_storage
#elif defined(CURVECORE_AP_INT)
#define CURVECORE_STORAGE ap_storage
#elif defined(CURVECORE_BIT_INT)
#define CURVECORE_STORAGE bit_storage
#elif defined(CURVECORE_CHECKED)
#define CURVECORE_STORAGE checked_storage
#else
#define CURVECORE_STORAGE native_storage
#endif
