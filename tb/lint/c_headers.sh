#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# c_headers.sh ROOT : each header that hosts and firmware share compiles alone, as C99 and as C++14,
# by every compiler that is here, for 64 and for 32 bits without an operating system, and asks for
# nothing but memory to be copied and set. A header that is broken does not.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
strict='-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -O1'
# compiles HEADER
compiles() {
  for compiler in cc clang clang-14; do
    command -v $compiler >/dev/null || continue
    for options in '-x c -std=c99' '-x c -std=c99 -m32' '-x c++ -std=c++14'; do
      echo "#include \"$1\"" >"$folder/alone"
      $compiler $options $strict -ffreestanding -c -o "$folder/alone.o" "$folder/alone" || return 1
    done
  done
  cc -x c -std=c99 -O1 -fkeep-inline-functions -ffreestanding -c -o "$folder/alone.o" \
    "$folder/alone" || return 1
  nm -u "$folder/alone.o" | grep -vwE 'memcpy|memmove|memset|memcmp|__stack_chk_fail'
  [ $? -eq 1 ]
}
status=0
root=$(realpath "$1")
for header in "$root"/hls/registers/*.h; do
  compiles "$header" || { echo "$header is not as a header of C99 is to be"; status=1; }
done
# broken LINE : with this line in it
broken() {
  cp "$root"/hls/registers/*.h "$folder"
  sed -i "s|^#endif\$|$1\n#endif|" "$folder/board_link.h"
  compiles "$folder/board_link.h" >"$folder/out" 2>&1 && { echo "not found: $1"; status=1; }
}
broken 'static inline void out_of_c99(void) { _Static_assert(1, ""); }'
broken 'static inline int32_t of_32_bits(int64_t time) { return time; }'
broken 'int printf(const char*, ...); static inline void prints(void) { printf("a"); }'
exit $status
