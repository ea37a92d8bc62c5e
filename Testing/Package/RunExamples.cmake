# Installs the build into an empty prefix, then builds and runs Examples/ with nothing but that
# prefix.
include("${CMAKE_CURRENT_LIST_DIR}/gatunRun.cmake")

file(REMOVE_RECURSE "${TEMP}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${TEMP}/prefix" --config "${CONFIG}")
run("${CMAKE_COMMAND}"
  -S "${SOURCE_DIR}/Examples"
  -B "${TEMP}/build"
  -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_C_COMPILER=${C_COMPILER}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_PREFIX_PATH=${TEMP}/prefix"
  "-DVTK_DIR=${VTK_DIR}")
run("${CMAKE_COMMAND}" --build "${TEMP}/build" --config "${CONFIG}")
run("${TEMP}/prefix/bin/gtn" --version)

# No installed header may lead to a private library.
file(GLOB_RECURSE headers "${TEMP}/prefix/include/*")
foreach (header IN LISTS headers)
  file(STRINGS "${header}" bad REGEX "#[ \t]*include[ \t]*[<\"](glm/|OpenImageIO/|tetgen\\.h|zstd\\.h|xxhash\\.h)")
  if (bad)
    message(FATAL_ERROR "${header}: ${bad}")
  endif ()
endforeach ()

# expect(<exit code> <regex of what it prints> <program> <argument>...)
function (expect exit output)
  list(JOIN ARGN " " text)
  message(STATUS "${text}")
  execute_process(COMMAND ${ARGN}
    WORKING_DIRECTORY "${TEMP}"
    RESULT_VARIABLE code
    OUTPUT_VARIABLE printed
    ERROR_VARIABLE errors)
  if (NOT code EQUAL exit OR NOT printed MATCHES "${output}")
    message(FATAL_ERROR "exit ${code}, not ${exit}, or not \"${output}\": ${printed}${errors}")
  endif ()
endfunction ()

# A cube of 16^3 times six tetrahedra.
expect(0 "" "${TEMP}/build/WriteArrays" mesh.gtn)
expect(0 "^4913 points, 24576 cells\n$" "${TEMP}/build/ReadMesh" mesh.gtn)
expect(1 "" "${TEMP}/build/ReadMesh" missing.gtn)
# Two triangles on each of 16^2 squares of six sides, whatever the number of pieces.
expect(0 "^3072 triangles\n$" "${TEMP}/build/StreamPieces" mesh.gtn 5)
expect(1 "" "${TEMP}/build/StreamPieces" missing.gtn)
expect(0 "^[0-9]+ triangles\n$" "${TEMP}/build/ContourFile" mesh.gtn wave 0.5 surface.vtp)
expect(0 "" "${TEMP}/build/DrawVolume" mesh.gtn volume.png)
file(SIZE "${TEMP}/volume.png" size)
if (size LESS 20000)
  message(FATAL_ERROR "DrawVolume made an image of ${size} bytes, in which there can be nothing")
endif ()

# The same mesh and values from any number of processes.
find_program(MPIEXEC NAMES mpiexec mpirun)
if (MPIEXEC AND EXISTS "${TEMP}/build/HeatSolver")
  foreach (processes IN ITEMS 1 2 3)
    expect(0 "^4913 points, 4096 cells, 4 steps\n$"
      "${MPIEXEC}" -n ${processes} "${TEMP}/build/HeatSolver" heat${processes}.gtn 16 12 4)
    expect(0 "^4913 points, 4096 cells, 1 steps\n$"
      "${MPIEXEC}" -n ${processes} "${TEMP}/build/HeatSolver" heat${processes}_%d.gtn 16 12 4)
    expect(0 "" "${TEMP}/prefix/bin/gtn" verify heat${processes}.gtn heat1.gtn)
    foreach (step IN ITEMS 0 3)
      expect(0 "" "${TEMP}/prefix/bin/gtn" verify heat${processes}_${step}.gtn heat1_${step}.gtn)
    endforeach ()
  endforeach ()
  expect(1 "" "${MPIEXEC}" -n 2 "${TEMP}/build/HeatSolver" missing/heat.gtn)
  if (EXISTS "${TEMP}/missing")
    message(FATAL_ERROR "HeatSolver made a folder")
  endif ()
endif ()

# TetGen is in a program of its own, and there is no other way to run it.
file(GLOB_RECURSE program "${TEMP}/prefix/*/gatun-tetgen")
if (program)
  file(WRITE "${TEMP}/surface.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
  expect(0 "" "${TEMP}/prefix/bin/gtn" mesh surface.obj filled.gtn)
  file(REMOVE "${program}" "${TEMP}/filled.gtn")
  execute_process(COMMAND "${TEMP}/prefix/bin/gtn" mesh surface.obj filled.gtn
    WORKING_DIRECTORY "${TEMP}"
    RESULT_VARIABLE   code
    ERROR_VARIABLE    errors)
  if (NOT code EQUAL 1 OR NOT errors MATCHES "gatun-tetgen cannot be started" OR EXISTS "${TEMP}/filled.gtn")
    message(FATAL_ERROR "exit ${code}: ${errors}")
  endif ()
endif ()

if (PYTHON_DESTINATION)
  set(ENV{PYTHONPATH} "${TEMP}/prefix/${PYTHON_DESTINATION}")
  set(ENV{LD_LIBRARY_PATH} "")
  expect(0 "4913 points, 24576 tetrahedra, volume 1\nwave: "
    "${PYTHON}" "${SOURCE_DIR}/Examples/MeshToNumPy.py" mesh.gtn)
  expect(1 "" "${PYTHON}" "${SOURCE_DIR}/Examples/MeshToNumPy.py" missing.gtn)
  expect(0 "velocity +float32 +1280x3 +equal"
    "${PYTHON}" "${SOURCE_DIR}/Examples/Python/numpy_round_trip.py" "${TEMP}")
  # The program of the same prefix. A semicolon would divide the argument.
  expect(0 "^4913\n$" "${PYTHON}" -c "print(__import__('gatun').info('mesh.gtn')['points'])")
  foreach (file IN ITEMS __init__.pyi vtk/__init__.pyi vtk/vtkGatunIO.pyi py.typed)
    if (NOT EXISTS "${TEMP}/prefix/${PYTHON_DESTINATION}/gatun/${file}")
      message(FATAL_ERROR "${file} is not installed")
    endif ()
  endforeach ()
endif ()
