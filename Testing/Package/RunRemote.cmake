# Builds the modules in the way of VTK's Remote folder: a project above them finds every vtk.module
# below Remote/, asks for VTK::Gatun and builds what that needs in one go.
include("${CMAKE_CURRENT_LIST_DIR}/gatunRun.cmake")

file(REMOVE_RECURSE "${TEMP}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/Remote/" DESTINATION "${TEMP}/source")
file(COPY "${SOURCE_DIR}/" DESTINATION "${TEMP}/source/Remote/Gatun"
  REGEX "/(build[^/]*|\\.git|\\.ci|Documentation|Data)$" EXCLUDE)
run("${CMAKE_COMMAND}"
  -S "${TEMP}/source"
  -B "${TEMP}/build"
  -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=Debug"
  "-DCMAKE_CXX_FLAGS_DEBUG=-O0"
  "-DCMAKE_C_COMPILER=${C_COMPILER}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  -DCMAKE_UNITY_BUILD=ON
  "-DVTK_DIR=${VTK_DIR}")
run("${CMAKE_COMMAND}" --build "${TEMP}/build")
