# Finds TetGen (tetgen.h and its library), which ships no CMake package.
#
# Defines the target TetGen::TetGen and the variable TetGen_FOUND. TetGen is under the GNU Affero
# General Public License, and so is every binary that contains or links it.
find_path(TetGen_INCLUDE_DIR NAMES tetgen.h)
find_library(TetGen_LIBRARY NAMES tet tetgen)
mark_as_advanced(TetGen_INCLUDE_DIR TetGen_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TetGen
  REQUIRED_VARS TetGen_LIBRARY TetGen_INCLUDE_DIR)

if (TetGen_FOUND AND NOT TARGET TetGen::TetGen)
  add_library(TetGen::TetGen UNKNOWN IMPORTED)
  set_target_properties(TetGen::TetGen PROPERTIES
    IMPORTED_LOCATION             "${TetGen_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${TetGen_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS TETLIBRARY)
endif ()
