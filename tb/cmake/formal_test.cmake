# SPDX-License-Identifier: Apache-2.0
# formal_test(tb/formal/<room>/<module>_formal.sv): tests formal.<module>.proved, .covered and one
# .catches.<NAME> for every line `// control: NAME ...` of the wrapper, one .proved.<NAME> for every
# line `// configuration: NAME ...`. Controls but the first, and what `// long: TEST ...` names, run
# in the long form alone (label long: scripts/campaign.sh).
function(formal_test wrapper)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${wrapper})
  cmake_path(GET wrapper STEM module)
  string(REGEX REPLACE "_formal$" "" module ${module})
  # Names alone: in a list of lines one with an open bracket swallows those behind it.
  file(READ ${wrapper} text)
  string(REGEX MATCHALL "\n// control: [A-Za-z0-9_]+" controls "${text}")
  if(NOT controls)
    message(FATAL_ERROR "${wrapper} declares no control: a proof that cannot fail proves nothing")
  endif()

  set(prove ${PROJECT_SOURCE_DIR}/tb/formal/prove.sh)
  set(sources ${RTL_PACKAGES} ${RTL_MODULES})
  set(name formal.${module})
  add_test(NAME ${name}.proved COMMAND ${prove} prove ${wrapper} - ${sources})
  add_test(NAME ${name}.covered COMMAND ${prove} cover ${wrapper} - ${sources})
  set(tests ${name}.proved ${name}.covered)
  foreach(control ${controls})
    string(REPLACE "\n// control: " "" control ${control})
    add_test(NAME ${name}.catches.${control}
             COMMAND ${prove} control ${wrapper} ${control} ${sources})
    list(APPEND tests ${name}.catches.${control})
  endforeach()
  file(STRINGS ${wrapper} configurations REGEX "^// configuration: ")
  foreach(configuration ${configurations})
    string(REGEX REPLACE "^// configuration: ([A-Za-z0-9_]+).*" "\\1" configuration
           ${configuration})
    add_test(NAME ${name}.proved.${configuration}
             COMMAND ${prove} prove ${wrapper} ${configuration} ${sources})
    list(APPEND tests ${name}.proved.${configuration})
  endforeach()
  set_tests_properties(${tests} PROPERTIES LABELS formal
                       ENVIRONMENT STATE_SEARCH=$<TARGET_FILE:state_search>)
  file(STRINGS ${wrapper} long REGEX "^// long: ")
  string(REPLACE "// long: " "" long "${long}")
  separate_arguments(long)
  list(TRANSFORM long PREPEND ${name}.)
  list(FILTER tests INCLUDE REGEX "\\.catches\\.")
  list(POP_FRONT tests)
  set_tests_properties(${tests} ${long} PROPERTIES LABELS "formal;long")
endfunction()
