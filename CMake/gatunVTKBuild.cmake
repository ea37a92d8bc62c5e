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
  IOPLY
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
  jsoncpp
  png
  kissfft)
if (GATUN_CORE_ONLY)
  set(gatun_vtk_components CommonCore kissfft)
endif ()
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
# Libraries of packages are in the folders of the system.
set(CMAKE_INSTALL_RPATH "$ORIGIN")
if (GATUN_PACKAGING)
  set(CMAKE_INSTALL_RPATH "")
endif ()

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

# The library around TetGen has a CMake package and install components of its own, so that it need not be
# installed along with the others.
set(gatun_tetgen_modules)
if (GATUN_ENABLE_TETGEN)
  vtk_module_scan(
    MODULE_FILES      "${CMAKE_CURRENT_SOURCE_DIR}/Filters/TetGen/vtk.module"
    WANT_BY_DEFAULT   ON
    HIDE_MODULES_FROM_CACHE ON
    PROVIDES_MODULES  gatun_tetgen_modules
    REQUIRES_MODULES  gatun_tetgen_required_modules)
  vtk_module_build(
    MODULES             ${gatun_tetgen_modules}
    PACKAGE             GatunTetGen
    VERSION             "${PROJECT_VERSION}"
    SOVERSION           "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
    INSTALL_EXPORT      GatunTetGen
    INSTALL_HEADERS     ON
    HEADERS_DESTINATION "${gatun_headers_destination}"
    CMAKE_DESTINATION   "${gatun_cmake_destination}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    ARCHIVE_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
    TARGETS_COMPONENT   tetgen
    HEADERS_COMPONENT   tetgen_development
    UTILITY_TARGET      gatunBuildFlags
    TEST_DIRECTORY_NAME NONE)
  list(APPEND gatun_required_modules ${gatun_tetgen_required_modules})
  list(REMOVE_DUPLICATES gatun_required_modules)
endif ()

#--------------------------------------------------------------------------------------------------
# Python: `from gatun import vtkGatunReader`, from the build tree as well as once installed.
if (GATUN_WRAP_PYTHON)
  vtk_module_python_default_destination(gatun_python_destination)
  include(gatunPython)

  vtk_module_wrap_python(
    MODULES             ${gatun_modules}
    TARGET              GatunPython
    WRAPPED_MODULES     gatun_wrapped_modules
    PYTHON_PACKAGE      gatun
    MODULE_DESTINATION  "${gatun_python_destination}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    CMAKE_DESTINATION   "${gatun_cmake_destination}"
    UTILITY_TARGET      gatunSanitizers
    BUILD_STATIC        OFF
    INSTALL_HEADERS     OFF)
  set(gatun_wrapped_tetgen_modules)
  if (GATUN_ENABLE_TETGEN)
    vtk_module_wrap_python(
      MODULES             ${gatun_tetgen_modules}
      TARGET              GatunTetGenPython
      WRAPPED_MODULES     gatun_wrapped_tetgen_modules
      PYTHON_PACKAGE      gatun
      MODULE_DESTINATION  "${gatun_python_destination}"
      LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
      CMAKE_DESTINATION   "${gatun_cmake_destination}"
      COMPONENT           tetgen_python
      UTILITY_TARGET      gatunSanitizers
      BUILD_STATIC        OFF
      INSTALL_HEADERS     OFF)
  endif ()

  # The modules would look for the libraries in a path of their own, which are in those of the system.
  if (GATUN_PACKAGING)
    get_directory_property(targets BUILDSYSTEM_TARGETS)
    foreach (target IN LISTS targets)
      get_target_property(type "${target}" TYPE)
      if (type STREQUAL "MODULE_LIBRARY")
        set_target_properties("${target}" PROPERTIES INSTALL_RPATH "")
      endif ()
    endforeach ()
  endif ()

  gatun_add_python_package(
    DESTINATION "${gatun_python_destination}"
    MODULES     ${gatun_wrapped_modules} ${gatun_wrapped_tetgen_modules})
endif ()

#--------------------------------------------------------------------------------------------------
# CMake package: `find_package(Gatun)`.
include(CMakePackageConfigHelpers)

vtk_module_export_find_packages(
  CMAKE_DESTINATION "${gatun_cmake_destination}"
  FILE_NAME         "Gatun-vtk-module-find-packages.cmake"
  MODULES           ${gatun_modules})
if (GATUN_ENABLE_TETGEN)
  vtk_module_export_find_packages(
    CMAKE_DESTINATION "${gatun_cmake_destination}"
    FILE_NAME         "GatunTetGen-vtk-module-find-packages.cmake"
    COMPONENT         tetgen_development
    MODULES           ${gatun_tetgen_modules})
endif ()

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
    "${CMAKE_CURRENT_SOURCE_DIR}/CMake/FindxxHash.cmake"
  DESTINATION "${gatun_cmake_destination}"
  COMPONENT   development)
# Packages have it in the form that Debian wants.
if (NOT GATUN_PACKAGING)
  install(FILES LICENSE
    DESTINATION "${CMAKE_INSTALL_DOCDIR}"
    COMPONENT   runtime)
endif ()

#--------------------------------------------------------------------------------------------------
# Pages of the headers
if (NOT GATUN_CORE_ONLY)
  include(gatunDoxygen)
endif ()

#--------------------------------------------------------------------------------------------------
# Programs
if (NOT GATUN_CORE_ONLY)
  add_subdirectory(Programs)
endif ()
