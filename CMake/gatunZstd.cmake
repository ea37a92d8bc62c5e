# Sets gatun_libraries to zstd: that of the system, or one that is compiled from its sources.
set(GATUN_ZSTD_SOURCE "" CACHE PATH
  "Folder of zstd's sources, which are compiled into a static library; empty for the zstd of the system")

if (NOT GATUN_ZSTD_SOURCE)
  find_package(zstd REQUIRED)
  set(gatun_libraries
    $<IF:$<TARGET_EXISTS:zstd::libzstd_shared>,zstd::libzstd_shared,zstd::libzstd_static>)
  return ()
endif ()

set(gatun_libraries gatunZstd)
if (NOT TARGET gatunZstd)
  file(GLOB zstd_sources
    "${GATUN_ZSTD_SOURCE}/lib/common/*.c"
    "${GATUN_ZSTD_SOURCE}/lib/compress/*.c"
    "${GATUN_ZSTD_SOURCE}/lib/decompress/*.c")
  add_library(gatunZstd STATIC ${zstd_sources})
  set_target_properties(gatunZstd PROPERTIES
    UNITY_BUILD        OFF
    C_VISIBILITY_PRESET hidden)
  # The assembler of the sources is for x86-64 only.
  target_compile_definitions(gatunZstd PRIVATE ZSTD_DISABLE_ASM ZSTDLIB_VISIBLE=)
  target_include_directories(gatunZstd SYSTEM INTERFACE "${GATUN_ZSTD_SOURCE}/lib")
endif ()
