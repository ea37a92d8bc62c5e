# zstd as a static library only, for a libgatun that needs no other libraries: -Dzstd_DIR=<this folder>.
find_library(GATUN_STATIC_ZSTD NAMES libzstd.a REQUIRED)
find_path(GATUN_STATIC_ZSTD_INCLUDE NAMES zstd.h REQUIRED)
if (NOT TARGET zstd::libzstd_static)
  add_library(zstd::libzstd_static STATIC IMPORTED)
  set_target_properties(zstd::libzstd_static PROPERTIES
    IMPORTED_LOCATION             "${GATUN_STATIC_ZSTD}"
    INTERFACE_INCLUDE_DIRECTORIES "${GATUN_STATIC_ZSTD_INCLUDE}")
endif ()
