# SPDX-License-Identifier: Apache-2.0
# core_parameters(<result> Name=Value ...): every parameter of the table ref/format/parameters.def,
# with its default where it is not named.
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${PROJECT_SOURCE_DIR}/ref/format/parameters.def)

function(core_parameters result)
  file(STRINGS ${PROJECT_SOURCE_DIR}/ref/format/parameters.def rows REGEX "^PARAMETER")
  set(all "")
  foreach(row ${rows})
    string(REGEX REPLACE "^PARAMETER.[a-z_]+, ([A-Za-z]+), [0-9]+, [0-9]+, ([0-9]+),.*" "\\1;\\2"
           row "${row}")
    list(GET row 0 name)
    list(GET row 1 value)
    foreach(given ${ARGN})
      if(given MATCHES "^${name}=(.+)")
        set(value ${CMAKE_MATCH_1})
      endif()
    endforeach()
    list(APPEND all ${name}=${value})
  endforeach()
  set(${result} ${all} PARENT_SCOPE)
endfunction()
