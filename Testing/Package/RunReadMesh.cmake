# Installs the build into an empty prefix, then configures, builds and runs the examples with nothing
# but that prefix.
include("${CMAKE_CURRENT_LIST_DIR}/gatunRun.cmake")

file(REMOVE_RECURSE "${TEMP}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${TEMP}/prefix" --config "${CONFIG}")
foreach (example IN ITEMS ReadMesh StreamPieces)
  run("${CMAKE_COMMAND}"
    -S "${SOURCE_DIR}/Examples/${example}"
    -B "${TEMP}/${example}"
    -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_PREFIX_PATH=${TEMP}/prefix"
    "-DVTK_DIR=${VTK_DIR}")
  run("${CMAKE_COMMAND}" --build "${TEMP}/${example}" --config "${CONFIG}")
endforeach ()

# No installed header may lead to a private library.
file(GLOB_RECURSE headers "${TEMP}/prefix/include/*")
foreach (header IN LISTS headers)
  file(STRINGS "${header}" bad REGEX "#[ \t]*include[ \t]*[<\"](glm/|OpenImageIO/|tetgen\\.h|zstd\\.h|xxhash\\.h)")
  if (bad)
    message(FATAL_ERROR "${header}: ${bad}")
  endif ()
endforeach ()

# The programs take a file, and fail where it cannot be read.
run("${TEMP}/prefix/bin/gtn" --version)
set(mesh "${SOURCE_DIR}/Testing/Data/Golden/v1.0/chunks.gtn")
foreach (example IN ITEMS ReadMesh StreamPieces)
  run("${TEMP}/${example}/${example}" "${mesh}")
  execute_process(COMMAND "${TEMP}/${example}/${example}" "${TEMP}/missing.gtn"
    RESULT_VARIABLE code
    OUTPUT_QUIET
    ERROR_QUIET)
  if (NOT code EQUAL 1)
    message(FATAL_ERROR "${example} on a missing file: exit ${code} in place of 1")
  endif ()
endforeach ()

if (PYTHON_DESTINATION)
  set(ENV{PYTHONPATH} "${TEMP}/prefix/${PYTHON_DESTINATION}")
  set(ENV{LD_LIBRARY_PATH} "")
  run("${PYTHON}" -c "from gatun import vtkGatunReader; print(vtkGatunReader.__module__)")
  execute_process(
    COMMAND "${PYTHON}" "${SOURCE_DIR}/Examples/ReadMesh/ReadMesh.py" "${TEMP}/missing.gtn"
    RESULT_VARIABLE code
    OUTPUT_QUIET
    ERROR_QUIET)
  if (NOT code EQUAL 1)
    message(FATAL_ERROR "ReadMesh.py on a missing file: exit ${code} in place of 1")
  endif ()
endif ()
