# Finds xxHash, which ships no CMake package on most systems.
#
# Defines the target xxHash::xxHash and the variables xxHash_FOUND, xxHash_VERSION.
find_package(PkgConfig QUIET)
if (PkgConfig_FOUND)
  pkg_check_modules(PC_xxHash QUIET libxxhash)
endif ()

find_path(xxHash_INCLUDE_DIR
  NAMES xxhash.h
  HINTS ${PC_xxHash_INCLUDE_DIRS})
find_library(xxHash_LIBRARY
  NAMES xxhash
  HINTS ${PC_xxHash_LIBRARY_DIRS})
mark_as_advanced(xxHash_INCLUDE_DIR xxHash_LIBRARY)
set(xxHash_VERSION "${PC_xxHash_VERSION}")

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(xxHash
  REQUIRED_VARS xxHash_LIBRARY xxHash_INCLUDE_DIR
  VERSION_VAR   xxHash_VERSION)

if (xxHash_FOUND AND NOT TARGET xxHash::xxHash)
  add_library(xxHash::xxHash UNKNOWN IMPORTED)
  set_target_properties(xxHash::xxHash PROPERTIES
    IMPORTED_LOCATION             "${xxHash_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${xxHash_INCLUDE_DIR}")
endif ()
