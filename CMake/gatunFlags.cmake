# Compiler flags, as interface targets that are linked privately and never installed:
#
#   gatunSanitizers   the sanitizers of GATUN_SANITIZE, for everything, generated code included
#   gatunBuildFlags   that, and warnings, for code written by hand
#   gatunTestFlags    that, for tests of the core and fuzz targets
if (NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  message(FATAL_ERROR "Gatun is compiled by GCC or clang, not by ${CMAKE_CXX_COMPILER_ID}.")
endif ()

option(GATUN_WARNINGS_AS_ERRORS "Stop at the first compiler warning" OFF)

set(GATUN_SANITIZE "" CACHE STRING
  "Sanitizers to build with, such as \"address,undefined\" or \"thread\"; empty for none")
set_property(CACHE GATUN_SANITIZE PROPERTY STRINGS "" "address,undefined" "thread")

add_library(gatunSanitizers INTERFACE)
if (GATUN_SANITIZE)
  string(REPLACE ";" "," sanitizers "${GATUN_SANITIZE}")
  target_compile_options(gatunSanitizers INTERFACE
    "-fsanitize=${sanitizers}" -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
  target_link_options(gatunSanitizers INTERFACE
    "-fsanitize=${sanitizers}")
endif ()
if (GATUN_BUILD_FUZZERS)
  if (NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "GATUN_BUILD_FUZZERS needs clang (-DCMAKE_CXX_COMPILER=clang++).")
  endif ()
  # Libraries report their coverage to libFuzzer, which only the fuzzers themselves contain.
  target_compile_options(gatunSanitizers INTERFACE -fsanitize=fuzzer-no-link)
endif ()

add_library(gatunBuildFlags INTERFACE)
target_link_libraries(gatunBuildFlags INTERFACE gatunSanitizers)
# No -Wpedantic: it finds a stray semicolon in every use of vtkTypeMacro. The core, which has none,
# gets it in Module/CMakeLists.txt.
target_compile_options(gatunBuildFlags INTERFACE
  -Wall
  -Wextra
  -Wshadow
  -Wundef
  -Wcast-align
  -Wcast-qual
  -Wformat=2
  "$<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor;-Woverloaded-virtual>"
  "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wduplicated-cond;-Wlogical-op;-Wno-psabi>"
  # The walk joins conditions without branching on purpose.
  "$<$<COMPILE_LANG_AND_ID:CXX,Clang>:-Wno-bitwise-instead-of-logical>"
  # In a unity build, an anonymous namespace is in an included file.
  "$<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<COMPILE_LANG_AND_ID:CXX,GNU>>:-Wno-subobject-linkage>"
  "$<$<BOOL:${GATUN_WARNINGS_AS_ERRORS}>:-Werror>")

# The code of tests need not be fast, but there is much of it to compile. The core that they test is
# compiled as everywhere.
set(GATUN_TEST_OPTIMIZATION "-O1" CACHE STRING "Optimization of the tests of the core and of fuzz targets")
mark_as_advanced(GATUN_TEST_OPTIMIZATION)
add_library(gatunTestFlags INTERFACE)
target_link_libraries(gatunTestFlags INTERFACE gatunBuildFlags)
target_compile_options(gatunTestFlags INTERFACE
  "$<$<NOT:$<CONFIG:Debug>>:${GATUN_TEST_OPTIMIZATION}>")

# A static library names what it links, even privately, to those who link it.
if (NOT BUILD_SHARED_LIBS AND gatun_build_vtk)
  install(TARGETS gatunBuildFlags gatunSanitizers EXPORT Gatun)
endif ()
