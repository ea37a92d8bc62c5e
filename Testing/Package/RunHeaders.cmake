# Installs the build into an empty prefix, then compiles every installed header by itself, with nothing
# but that prefix.
include("${CMAKE_CURRENT_LIST_DIR}/gatunRun.cmake")

file(REMOVE_RECURSE "${TEMP}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${TEMP}/prefix" --config "${CONFIG}")
run("${CMAKE_COMMAND}"
  -S "${CMAKE_CURRENT_LIST_DIR}/Headers"
  -B "${TEMP}/build"
  -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_C_COMPILER=${C_COMPILER}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_PREFIX_PATH=${TEMP}/prefix"
  "-DINCLUDE_DIR=${TEMP}/prefix/${HEADERS_DESTINATION}"
  "-DVTK_DIR=${VTK_DIR}")
run("${CMAKE_COMMAND}" --build "${TEMP}/build" --config "${CONFIG}")
