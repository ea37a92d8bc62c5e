# Helpers to add tests. Every test gets a name "<folder>.<test>", at least one of the labels
#
#   unit       seconds, no window, no network
#   image      draws; needs a display
#   cli        runs the gtn program
#   paraview   runs pvbatch or pvpython with the plugin
#   fuzz       decoders on hostile input
#   package    installs, and builds a consumer of the installed files
#
# and, in addition to one of these,
#
#   data       reads large real meshes; skipped without GATUN_DATA_DIR
#   long       more than half a minute, or rarely broken by a change: not in a usual run of setup.sh test
#
# Exit code 125 counts as skipped. Tests get these variables in the environment:
#
#   GATUN_TEST_NAME   the name of the test
#   GATUN_TEST_DATA   Testing/Data of the sources
#   GATUN_TEST_TEMP   a folder to write into
#   GATUN_DATA_DIR, GATUN_CELLS_DIR
#                     folders of large real meshes, set by the user or not at all; a test that
#                     needs them skips itself without

include(gatunUnity)

set(GATUN_TEST_DATA "${PROJECT_SOURCE_DIR}/Testing/Data")
set(GATUN_TEST_TEMP "${PROJECT_BINARY_DIR}/Testing/Temporary/gatun")
file(MAKE_DIRECTORY "${GATUN_TEST_TEMP}")

# Open MPI 4 and 5 refuse root, and more processes than processors, unless told otherwise.
set(gatun_mpi_environment
  "OMPI_ALLOW_RUN_AS_ROOT=1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"
  "OMPI_MCA_btl_vader_single_copy_mechanism=none"
  "OMPI_MCA_rmaps_base_oversubscribe=1"
  "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe")

set(gatun_test_labels unit image cli paraview fuzz package data long)

# A test fails if it prints one of these, unless it is added with EXPECT_ERRORS: messages of VTK, leaked
# VTK objects, a failed image comparison, an uncaught Python exception.
set(gatun_test_fail_regex
  "(\n|^)ERROR: "
  "ERR\\|"
  "instance(s)? still around"
  "Failed Image Test"
  "ImageNotFound"
  "Traceback \\(most recent call last\\)")

set(GATUN_TEST_PREFIX "" CACHE STRING "Prepended to the names of all tests")
mark_as_advanced(GATUN_TEST_PREFIX)

# Prefix of the test names of the current folder: "io." in Testing/IO.
macro (_gatun_test_prefix)
  get_filename_component(prefix "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  string(TOLOWER "${GATUN_TEST_PREFIX}${prefix}." prefix)
endmacro ()

function (_gatun_check_labels)
  if (NOT ARGN)
    message(FATAL_ERROR "A test needs one of the labels ${gatun_test_labels}.")
  endif ()
  foreach (label IN LISTS ARGN)
    if (NOT label IN_LIST gatun_test_labels)
      message(FATAL_ERROR "Unknown test label ${label}; there are ${gatun_test_labels}.")
    endif ()
  endforeach ()
endfunction ()

# Any command:
#
#   gatun_add_test(NAME <name> COMMAND <program> <argument>... LABELS <label>...
#     [TIMEOUT <seconds>] [PROCESSORS <n>] [ENVIRONMENT <variable>=<value>...]
#     [DEPENDS <test>...] [EXPECT_ERRORS])
#
# TIMEOUT is 300 unless it is given; with ThreadSanitizer, ten times as much. The name is used as it
# is. EXPECT_ERRORS: error messages on the output do not fail the test.
function (gatun_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg
    "EXPECT_ERRORS"
    "NAME;TIMEOUT;PROCESSORS"
    "COMMAND;LABELS;ENVIRONMENT;DEPENDS")
  if (arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "gatun_add_test does not know ${arg_UNPARSED_ARGUMENTS}.")
  endif ()
  _gatun_check_labels(${arg_LABELS})
  if (NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif ()
  if (GATUN_SANITIZE MATCHES "thread")
    math(EXPR arg_TIMEOUT "10 * ${arg_TIMEOUT}")
  endif ()
  if (NOT arg_PROCESSORS)
    set(arg_PROCESSORS 1)
  endif ()

  set(environment
    "GATUN_TEST_NAME=${arg_NAME}"
    "GATUN_TEST_DATA=${GATUN_TEST_DATA}"
    "GATUN_TEST_TEMP=${GATUN_TEST_TEMP}"
    ${arg_ENVIRONMENT})
  add_test(NAME "${arg_NAME}"
    COMMAND           ${arg_COMMAND}
    WORKING_DIRECTORY "${GATUN_TEST_TEMP}")
  set_tests_properties("${arg_NAME}" PROPERTIES
    LABELS           "${arg_LABELS}"
    TIMEOUT          "${arg_TIMEOUT}"
    PROCESSORS       "${arg_PROCESSORS}"
    SKIP_RETURN_CODE 125
    DEPENDS          "${arg_DEPENDS}"
    ENVIRONMENT      "${environment}")
  if (NOT arg_EXPECT_ERRORS)
    set_tests_properties("${arg_NAME}" PROPERTIES
      FAIL_REGULAR_EXPRESSION "${gatun_test_fail_regex}")
  endif ()
endfunction ()

# GoogleTest on the core, its private functions included (see gatunCoreInternals):
#
#   gatun_add_core_tests(<program> SOURCES <file>... [LINK <target>...])
#
# Each TEST() is a test of its own, with label unit; with sanitizers, where each start of the program
# takes about a second, they run in sixteen processes. Paths come as the macros GATUN_TEST_DATA and
# GATUN_TEST_TEMP.
function (gatun_add_core_tests program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
  _gatun_test_prefix()
  find_package(GTest REQUIRED)
  include(GoogleTest)
  add_executable("${program}" ${arg_SOURCES})
  gatun_set_unity_groups("${program}" ${arg_SOURCES})
  target_link_libraries("${program}"
    PRIVATE
      gatunCoreInternals
      ${arg_LINK}
      gatunTestFlags
      GTest::gtest_main)
  target_compile_definitions("${program}"
    PRIVATE
      "GATUN_TEST_DATA=\"${GATUN_TEST_DATA}\""
      "GATUN_TEST_TEMP=\"${GATUN_TEST_TEMP}\"")
  if (GATUN_SANITIZE)
    set(filter "*")
    if (GATUN_SANITIZE MATCHES "thread")
      # Tests that damage thousands of files take hours with ThreadSanitizer. The other sanitizers run
      # them.
      set(filter "-Hostile*:*EveryFlipped*:*EveryTruncat*:*OfADamagedFile*:KilledWriter.*")
    endif ()
    foreach (shard RANGE 15)
      gatun_add_test(
        NAME        "${prefix}${program}-${shard}"
        COMMAND     "${program}" --gtest_brief=1
        LABELS      unit
        TIMEOUT     900
        ENVIRONMENT "GTEST_FILTER=${filter}" GTEST_TOTAL_SHARDS=16 "GTEST_SHARD_INDEX=${shard}")
    endforeach ()
    return ()
  endif ()
  gtest_discover_tests("${program}"
    TEST_PREFIX       "${prefix}"
    WORKING_DIRECTORY "${GATUN_TEST_TEMP}"
    DISCOVERY_MODE    PRE_TEST
    DISCOVERY_TIMEOUT 60
    PROPERTIES
      LABELS  unit
      TIMEOUT 300)
endfunction ()

# Tests in VTK's manner, each a file Test<What>.cxx with a function int Test<What>(int, char*[]):
#
#   gatun_add_vtk_tests(<program> SOURCES <file>... LINK <VTK module>...
#     [RENDERING] [EXPECT_ERRORS] [LABELS <label>...] [ENVIRONMENT <variable>=<value>...])
#
# They get -D Testing/Data and -T <folder to write into>. With RENDERING, VTK's rendering
# factories are loaded, the label is image instead of unit, and -V names the baseline
# Testing/Data/Baseline/Test<What>.png for vtkRegressionTestImage (alternates: _1, _2, ...).
function (gatun_add_vtk_tests program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "RENDERING;EXPECT_ERRORS" "" "SOURCES;LINK;LABELS;ENVIRONMENT")
  _gatun_test_prefix()
  set(driver_header vtkTestDriver.h)
  set(driver_link VTK::TestingCore)
  if (arg_RENDERING)
    set(driver_header vtkTestingObjectFactory.h)
    set(driver_link VTK::TestingRendering VTK::RenderingOpenGL2)
    # NaN and infinity are data like any other here.
    set(DISABLE_FLOATING_POINT_EXCEPTIONS TRUE)
    set(_vtk_build_TEST_OUTPUT_DIRECTORY "${GATUN_TEST_TEMP}")
    include("${VTK_DIR}/vtkTestingRenderingDriver.cmake")
  else ()
    include("${VTK_DIR}/vtkTestingDriver.cmake")
  endif ()

  create_test_sourcelist(sources "${program}.cxx" ${arg_SOURCES}
    EXTRA_INCLUDE "${driver_header}")
  add_executable("${program}" ${sources})
  target_link_libraries("${program}"
    PRIVATE
      ${arg_LINK}
      ${driver_link}
      gatunBuildFlags)
  vtk_module_autoinit(TARGETS "${program}" MODULES ${arg_LINK} ${driver_link})

  if (NOT arg_LABELS)
    set(arg_LABELS unit)
    if (arg_RENDERING)
      set(arg_LABELS image)
    endif ()
  endif ()
  set(expect_errors)
  if (arg_EXPECT_ERRORS)
    set(expect_errors EXPECT_ERRORS)
  endif ()
  foreach (source IN LISTS arg_SOURCES)
    get_filename_component(test "${source}" NAME_WE)
    set(baseline)
    if (arg_RENDERING)
      set(baseline -V "${GATUN_TEST_DATA}/Baseline/${test}.png")
    endif ()
    gatun_add_test(
      NAME    "${prefix}${test}"
      COMMAND "${program}" "${test}" -D "${GATUN_TEST_DATA}" -T "${GATUN_TEST_TEMP}" ${baseline}
      LABELS  ${arg_LABELS}
      ENVIRONMENT ${arg_ENVIRONMENT}
      ${expect_errors})
  endforeach ()
endfunction ()

# A Python program that imports gatun and vtkmodules, run by the interpreter of the VTK found:
#
#   gatun_add_python_test(<file>.py [NAME <name>] [ARGS <argument>...] [LABELS <label>...]
#     [EXPECT_ERRORS] [TIMEOUT <seconds>] [RANKS <n>])
#
# The test is named after the file and has the label unit unless others are given; without Python
# wrapping there is no such test. With RANKS, so many MPI processes run it, and -np<n> is appended to the
# name; without mpiexec there is no such test.
function (gatun_add_python_test file)
  cmake_parse_arguments(PARSE_ARGV 1 arg "EXPECT_ERRORS" "NAME;TIMEOUT;RANKS" "ARGS;LABELS")
  if (NOT GATUN_WRAP_PYTHON)
    return ()
  endif ()
  _gatun_test_prefix()
  if (NOT arg_LABELS)
    set(arg_LABELS unit)
  endif ()
  set(rest)
  if (arg_EXPECT_ERRORS)
    list(APPEND rest EXPECT_ERRORS)
  endif ()
  if (arg_TIMEOUT)
    list(APPEND rest TIMEOUT "${arg_TIMEOUT}")
  endif ()
  set(test "${arg_NAME}")
  if (NOT test)
    get_filename_component(test "${file}" NAME_WE)
  endif ()
  set(launch)
  if (arg_RANKS)
    find_program(MPIEXEC_EXECUTABLE NAMES mpiexec mpirun)
    if (NOT MPIEXEC_EXECUTABLE)
      return ()
    endif ()
    set(launch "${MPIEXEC_EXECUTABLE}" -np "${arg_RANKS}")
    string(APPEND test "-np${arg_RANKS}")
    list(APPEND rest PROCESSORS "${arg_RANKS}")
    if (arg_RANKS GREATER 2)
      list(APPEND arg_LABELS long)
    endif ()
  endif ()
  gatun_add_test(
    NAME        "${prefix}${test}"
    COMMAND     ${launch} "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${file}" ${arg_ARGS}
    LABELS      ${arg_LABELS}
    ENVIRONMENT
      "PYTHONPATH=${gatun_python_path}:${CMAKE_CURRENT_SOURCE_DIR}:${PROJECT_SOURCE_DIR}/Testing/IO:${PROJECT_SOURCE_DIR}/Testing/Filters"
      "PYTHONDONTWRITEBYTECODE=1"
      "GATUN_TEST_GTN=$<TARGET_FILE:gtn>"
      "GATUN_LIBRARY=$<TARGET_FILE:gatun>"
      ${gatun_mpi_environment}
    ${rest})
endfunction ()

# One call of the gtn program, in GATUN_TEST_TEMP:
#
#   gatun_add_cli_test(NAME <name> [ARGS <argument>...] [EXIT <code>]
#     [STDOUT <regex>] [STDERR <regex>] [DEPENDS <test>...] [LABELS <label>...])
#
# EXIT is 0 unless given; STDOUT and STDERR must match where given. DEPENDS orders tests (by their
# full names, "cli.<name>"), so that one may use a file that another made.
function (gatun_add_cli_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;EXIT;STDOUT;STDERR" "ARGS;DEPENDS;LABELS")
  _gatun_test_prefix()
  if (NOT arg_EXIT)
    set(arg_EXIT 0)
  endif ()
  gatun_add_test(
    NAME    "${prefix}${arg_NAME}"
    COMMAND "${CMAKE_COMMAND}"
            "-DEXIT=${arg_EXIT}"
            "-DSTDOUT=${arg_STDOUT}"
            "-DSTDERR=${arg_STDERR}"
            -P "${PROJECT_SOURCE_DIR}/CMake/gatunRunCli.cmake"
            -- "$<TARGET_FILE:gtn>" ${arg_ARGS}
    LABELS  cli ${arg_LABELS}
    DEPENDS ${arg_DEPENDS}
    EXPECT_ERRORS)
endfunction ()

# A Python program for ParaView, in the ParaView build only:
#
#   gatun_add_pvbatch_test(<file>.py [RANKS <n>...] [ARGS <argument>...] [LABELS <label>...]
#     [TIMEOUT <seconds>] [EXPECT_ERRORS] [PVPYTHON] [SYMMETRIC])
#
# One test for each number of MPI ranks (1 unless given). The environment variable GATUN_PLUGIN
# names the plugin to load. PVPYTHON runs pvpython in place of pvbatch. With SYMMETRIC, all ranks run
# the program, as those of a simulation do. The label paraview is always there.
function (gatun_add_pvbatch_test file)
  cmake_parse_arguments(PARSE_ARGV 1 arg "EXPECT_ERRORS;PVPYTHON;SYMMETRIC" "TIMEOUT" "RANKS;ARGS;LABELS")
  _gatun_test_prefix()
  get_filename_component(test "${file}" NAME_WE)
  if (NOT arg_RANKS)
    set(arg_RANKS 1)
  endif ()
  set(program "${GATUN_PVBATCH}")
  if (arg_PVPYTHON)
    set(program "${GATUN_PVPYTHON}")
    string(APPEND test "-pvpython")
  elseif (arg_SYMMETRIC)
    list(APPEND program --sym)
  endif ()
  set(rest)
  if (arg_EXPECT_ERRORS)
    list(APPEND rest EXPECT_ERRORS)
  endif ()
  if (arg_TIMEOUT)
    list(APPEND rest TIMEOUT "${arg_TIMEOUT}")
  endif ()
  foreach (ranks IN LISTS arg_RANKS)
    set(name "${prefix}${test}")
    set(launch)
    set(labels paraview ${arg_LABELS})
    if (ranks GREATER 1)
      string(APPEND name "-np${ranks}")
      set(launch "${MPIEXEC_EXECUTABLE}" -np ${ranks})
    endif ()
    if (ranks GREATER 2)
      list(APPEND labels long)
    endif ()
    gatun_add_test(
      NAME        "${name}"
      COMMAND     ${launch} ${program} "${CMAKE_CURRENT_SOURCE_DIR}/${file}" ${arg_ARGS}
      LABELS      ${labels}
      PROCESSORS  "${ranks}"
      ENVIRONMENT "GATUN_PLUGIN=${gatun_plugin_file}"
                  "GATUN_RANKS=${ranks}"
                  ${gatun_paraview_environment}
      ${rest})
  endforeach ()
endfunction ()

# A fuzz target, a file with LLVMFuzzerTestOneInput():
#
#   gatun_add_fuzz_target(<name> SOURCES <file>... [LINK <target>...] CORPUS <archive>)
#
# The build unpacks the archive into the folder Corpus/<name> of the build tree. In every build the
# test fuzz.<name> runs the target on its inputs. With GATUN_BUILD_FUZZERS there is also the libFuzzer
# program fuzz-<name>, which fuzz.<name>-short runs for some seconds; the target fuzzers builds them all.
function (gatun_add_fuzz_target name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CORPUS" "SOURCES;LINK")
  _gatun_test_prefix()

  set(archive "${CMAKE_CURRENT_SOURCE_DIR}/${arg_CORPUS}")
  set(corpus "${CMAKE_CURRENT_BINARY_DIR}/Corpus/${name}")
  add_custom_command(
    OUTPUT  "${corpus}.stamp"
    COMMAND "${CMAKE_COMMAND}" -E rm -rf "${corpus}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${corpus}"
    COMMAND "${CMAKE_COMMAND}" -E chdir "${corpus}" "${CMAKE_COMMAND}" -E tar xf "${archive}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${corpus}.stamp"
    DEPENDS "${archive}"
    COMMENT "Unpacking ${arg_CORPUS}"
    VERBATIM)

  add_executable("fuzz-regression-${name}"
    ${arg_SOURCES}
    $<TARGET_OBJECTS:gatunFuzzRegression>
    "${corpus}.stamp")
  target_link_libraries("fuzz-regression-${name}" PRIVATE gatunFuzzSupport ${arg_LINK} gatunTestFlags)
  gatun_add_test(
    NAME    "${prefix}${name}"
    COMMAND "fuzz-regression-${name}" "${corpus}"
    LABELS  fuzz)

  if (GATUN_BUILD_FUZZERS)
    add_executable("fuzz-${name}" ${arg_SOURCES})
    target_link_libraries("fuzz-${name}" PRIVATE gatunFuzzSupport ${arg_LINK} gatunTestFlags)
    target_link_options("fuzz-${name}" PRIVATE -fsanitize=fuzzer)
    add_dependencies("fuzz-${name}" "fuzz-regression-${name}")
    if (NOT TARGET fuzzers)
      add_custom_target(fuzzers)
    endif ()
    add_dependencies(fuzzers "fuzz-${name}")
    set(found "${GATUN_TEST_TEMP}/fuzz-${name}")
    file(MAKE_DIRECTORY "${found}")
    gatun_add_test(
      NAME    "${prefix}${name}-short"
      COMMAND "fuzz-${name}" -max_total_time=20 "-artifact_prefix=${found}-" "${found}" "${corpus}"
      LABELS  fuzz)
  endif ()
endfunction ()

# The objects of the core as a static library with threads of their own, for tests of private functions: a
# shared library shows its public functions only. Do not link it together with VTK::GatunCore or a module that
# uses it.
function (gatun_add_core_internals)
  include(gatunJsonCpp)
  include(gatunZstd)
  find_package(glm REQUIRED)
  find_package(Threads REQUIRED)
  add_library(gatunCoreInternals STATIC EXCLUDE_FROM_ALL
    "${PROJECT_SOURCE_DIR}/Module/Support/gatunThreadsStandard.cxx"
    $<TARGET_OBJECTS:gatunObjects>)
  target_compile_features(gatunCoreInternals PUBLIC cxx_std_20)
  target_include_directories(gatunCoreInternals PUBLIC
    $<TARGET_PROPERTY:gatunObjects,INTERFACE_INCLUDE_DIRECTORIES>)
  target_link_libraries(gatunCoreInternals
    PUBLIC
      glm::glm
      JsonCpp::JsonCpp
      Threads::Threads
      ${gatun_libraries}
    PRIVATE gatunBuildFlags)

  # The C interface on top.
  add_library(gatunInterfaceInternals STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:gatunInterface>)
  set_target_properties(gatunInterfaceInternals PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(gatunInterfaceInternals PUBLIC "${PROJECT_SOURCE_DIR}/Library")
  target_link_libraries(gatunInterfaceInternals PUBLIC gatunCoreInternals)
endfunction ()
