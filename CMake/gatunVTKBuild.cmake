# The build for a plain VTK: libraries, Python package, CMake package, the gtn program.

# All VTK modules that are linked here, also by tests and programs. VTK's package makes the targets of
# a module's own dependencies (MPI, X11) only for the components asked for.
set(gatun_vtk_components
  CommonCore
  CommonDataModel
  CommonExecutionModel
  CommonMath
  CommonMisc
  CommonSystem
  FiltersCore
  FiltersGeneral
  FiltersGeometry
  FiltersSources
  IOCore
  IOEnSight
  IOExodus
  IOGeometry
  IOHDF
  IOImage
  IOLegacy
  IOParallelXML
  IOXML
  IOXMLParser
  ParallelCore
  ImagingCore
  ParallelCore
  RenderingCore
  RenderingOpenGL2
  RenderingVolume
  RenderingVolumeOpenGL2
  TestingCore
  TestingRendering
  png)
if (GATUN_WRAP_PYTHON)
  list(APPEND gatun_vtk_components
    Python
    WrappingPythonCore
    WrappingTools)
endif ()
# VTK's Python modules belong to the Python that is installed with VTK, if there is one. The first
# Python in PATH may be another.
if (GATUN_WRAP_PYTHON AND NOT DEFINED Python3_EXECUTABLE AND NOT DEFINED Python3_ROOT_DIR)
  find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore)
  set(Python3_ROOT_DIR "${VTK_PREFIX_PATH}")
endif ()
find_package(VTK 9.1 REQUIRED
  COMPONENTS          ${gatun_vtk_components}
  OPTIONAL_COMPONENTS IOCGNSReader)

set(gatun_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/gatun")
set(gatun_headers_destination "${CMAKE_INSTALL_INCLUDEDIR}/gatun")
set(CMAKE_INSTALL_RPATH "$ORIGIN")

vtk_module_scan(
  MODULE_FILES      ${gatun_module_files}
  WANT_BY_DEFAULT   ON
  HIDE_MODULES_FROM_CACHE ON
  PROVIDES_MODULES  gatun_modules
  REQUIRES_MODULES  gatun_required_modules)

vtk_module_build(
  MODULES             ${gatun_modules}
  PACKAGE             Gatun
  VERSION             "${PROJECT_VERSION}"
  SOVERSION           "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
  INSTALL_EXPORT      Gatun
  INSTALL_HEADERS     ON
  HEADERS_DESTINATION "${gatun_headers_destination}"
  CMAKE_DESTINATION   "${gatun_cmake_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  ARCHIVE_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  UTILITY_TARGET      gatunBuildFlags
  TEST_DIRECTORY_NAME NONE)

#--------------------------------------------------------------------------------------------------
# Python: `from gatun.vtk import vtkGatunReader`, from the build tree as well as once installed.
if (GATUN_WRAP_PYTHON)
  include(gatunPython)
  gatun_add_python_package(
    MODULES             ${gatun_modules}
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endif ()

#--------------------------------------------------------------------------------------------------
# CMake package: `find_package(Gatun)`.
include(CMakePackageConfigHelpers)

vtk_module_export_find_packages(
  CMAKE_DESTINATION "${gatun_cmake_destination}"
  FILE_NAME         "Gatun-vtk-module-find-packages.cmake"
  MODULES           ${gatun_modules})

# What the installed libraries need from VTK, as component names.
set(gatun_required_components ${gatun_required_modules})
list(TRANSFORM gatun_required_components REPLACE "^VTK::" "")
list(JOIN gatun_required_components " " gatun_required_components)

configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/GatunConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${gatun_cmake_destination}/GatunConfig.cmake"
  INSTALL_DESTINATION "${gatun_cmake_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${gatun_cmake_destination}/GatunConfigVersion.cmake"
  VERSION       "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${gatun_cmake_destination}/GatunConfig.cmake"
    "${CMAKE_BINARY_DIR}/${gatun_cmake_destination}/GatunConfigVersion.cmake"
  DESTINATION "${gatun_cmake_destination}")
install(FILES LICENSE
  DESTINATION "${CMAKE_INSTALL_DOCDIR}")

#--------------------------------------------------------------------------------------------------
# Pages of the headers
include(gatunDoxygen)

#--------------------------------------------------------------------------------------------------
# Programs
add_subdirectory(Programs)
