# SPDX-License-Identifier: Apache-2.0
# html_page(<name> <template>.hpp.in [<script> ...]): <name>.html, with the style that all pages
# share, as a C++ string in the header that the template says; @<script>@ in it stands for the
# file <script>.js.
function(html_page name template)
  set(style ${PROJECT_SOURCE_DIR}/sysc/report/page.css)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${name}.html ${style})
  file(READ ${style} page_style)
  file(READ ${name}.html page)
  string(REPLACE "@page_style@" "${page_style}" page "${page}")
  foreach(script ${ARGN})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script}.js)
    file(READ ${script}.js text)
    string(REPLACE "@${script}@" "${text}" page "${page}")
  endforeach()
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REGEX REPLACE "\\.in$" "" header ${template})
  configure_file(${template} generated/${folder}/${header} @ONLY)
endfunction()
