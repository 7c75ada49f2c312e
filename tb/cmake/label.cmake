# SPDX-License-Identifier: Apache-2.0
# label_needs(<label> <target> ...): target label_<label> builds them, for `ctest -L <label>`.
# scripts/test.sh builds it alone.
function(label_needs label)
  if(NOT TARGET label_${label})
    add_custom_target(label_${label})
  endif()
  if(ARGN)
    add_dependencies(label_${label} ${ARGN})
  endif()
endfunction()
