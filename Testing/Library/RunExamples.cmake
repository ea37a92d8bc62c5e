# Installs the library into an empty prefix, then builds and runs the examples in C and Fortran with nothing but
# that prefix, by CMake and by pkg-config.
include("${CMAKE_CURRENT_LIST_DIR}/../Package/gatunRun.cmake")

file(REMOVE_RECURSE "${TEMP}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${TEMP}/prefix" --component library)
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}/Examples/C" -B "${TEMP}/build" "-DCMAKE_PREFIX_PATH=${TEMP}/prefix")
run("${CMAKE_COMMAND}" --build "${TEMP}/build")

# expect(<regex of what it prints> <program> <argument>...)
function (expect output)
  execute_process(COMMAND ${ARGN}
    WORKING_DIRECTORY "${TEMP}"
    RESULT_VARIABLE code
    OUTPUT_VARIABLE printed
    ERROR_VARIABLE errors)
  if (NOT code EQUAL 0 OR NOT printed MATCHES "${output}")
    message(FATAL_ERROR "${ARGN}: exit ${code}, or not \"${output}\": ${printed}${errors}")
  endif ()
endfunction ()

expect("^4913 points, 4096 cells, step 3: equal\n$" "${TEMP}/build/solver" steps.gtn 4)
if (EXISTS "${TEMP}/build/solver_fortran")
  expect("^729 points, 5 steps\n$" "${TEMP}/build/solver_fortran" fortran.gtn)
endif ()
execute_process(COMMAND "${TEMP}/build/solver" missing/steps.gtn
  WORKING_DIRECTORY "${TEMP}" RESULT_VARIABLE code ERROR_VARIABLE errors)
if (NOT code EQUAL 1 OR NOT errors MATCHES "^solver: missing/steps.gtn: cannot write: No such file")
  message(FATAL_ERROR "exit ${code}: ${errors}")
endif ()

find_program(PKG_CONFIG pkg-config)
if (PKG_CONFIG)
  file(GLOB_RECURSE file "${TEMP}/prefix/*/gatun.pc")
  get_filename_component(folder "${file}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} "${folder}")
  # The prefix of the file is the one that was configured, not the one that this test installs to.
  execute_process(COMMAND "${PKG_CONFIG}" "--define-variable=prefix=${TEMP}/prefix" --cflags --libs gatun
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(cc "${SOURCE_DIR}/Examples/C/solver.c" -o "${TEMP}/solver" ${flags} -lm)
endif ()
