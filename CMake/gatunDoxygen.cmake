# The target doxygen: pages of all installed headers in doxygen/html of the build tree. Warnings are errors.
find_program(GATUN_DOXYGEN NAMES doxygen)
mark_as_advanced(GATUN_DOXYGEN)

# Each folder of a module lists its headers, the core also those that may change.
set(gatun_doxygen_input "\"${PROJECT_SOURCE_DIR}/Documentation/doxygen/groups.dox\"")
foreach (folder IN ITEMS Module IO Filters Rendering Filters/TetGen)
  if (folder STREQUAL "Filters/TetGen" AND NOT GATUN_ENABLE_TETGEN)
    continue ()
  endif ()
  set(headers)
  foreach (list IN ITEMS headers experimental_headers classes)
    get_directory_property(names DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}" DEFINITION "${list}")
    list(TRANSFORM names REPLACE "(vtk[A-Za-z0-9]+)$" "\\1.h")
    list(APPEND headers ${names})
  endforeach ()
  list(TRANSFORM headers REPLACE "(.+)" "  \"${PROJECT_SOURCE_DIR}/${folder}/\\1\"")
  list(APPEND gatun_doxygen_input ${headers})
endforeach ()
list(JOIN gatun_doxygen_input " \\\n" gatun_doxygen_input)
set(gatun_doxyfile "${CMAKE_BINARY_DIR}/doxygen/Doxyfile")
configure_file("${PROJECT_SOURCE_DIR}/Documentation/doxygen/Doxyfile.in" "${gatun_doxyfile}" @ONLY)

if (GATUN_DOXYGEN)
  add_custom_target(doxygen
    COMMAND "${GATUN_DOXYGEN}" "${gatun_doxyfile}"
    COMMENT "Writing doxygen/html"
    VERBATIM)
endif ()
