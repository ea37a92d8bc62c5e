# WebAssembly: Debian's package emscripten, whose own toolchain file does most of it.
#
# CMAKE_FIND_ROOT_PATH names a folder with the headers that the core needs; see Documentation/building.md.
set(EMSCRIPTEN_ROOT_PATH /usr/share/emscripten)
include("${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake")
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# Exceptions of the browser, and vectors. zstd looks for SSE2, which Emscripten has in terms of these vectors, and
# compresses as everywhere.
set(CMAKE_C_FLAGS_INIT "-msimd128 -msse2")
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/wasm.h")
