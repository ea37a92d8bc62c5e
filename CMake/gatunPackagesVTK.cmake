# The packages of the VTK build; see gatunPackaging.cmake.
set(gatun_library_package "libgatun${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(gatun_same_version "(= ${gatun_package_version})")
gatun_next_version("${VTK_VERSION}" gatun_next_vtk)
# Programs that link the libraries need this version of them.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")

gatun_package(runtime
  NAME        "${gatun_library_package}"
  SECTION     libs
  SHARED
  SUMMARY     "losslessly compressed meshes for VTK - libraries"
  DESCRIPTION "This package has the shared libraries."
  OVERRIDES
    "# The libraries have one version and are used together, as those of VTK are."
    "${gatun_library_package}: package-name-doesnt-match-sonames")

gatun_package(development
  NAME        libgatun-dev
  SECTION     libdevel
  SUMMARY     "losslessly compressed meshes for VTK - development files"
  DESCRIPTION "This package has the headers and the CMake package Gatun."
  DEPENDS     "${gatun_library_package} ${gatun_same_version}"
              "libvtk9-dev (>= ${VTK_VERSION})"
              "libvtk9-dev (<< ${gatun_next_vtk})")

gatun_package(data
  NAME        gatun-data
  SECTION     science
  ALL
  SUMMARY     "losslessly compressed meshes for VTK - types of files"
  DESCRIPTION "This package tells desktops the types of these files, with icons.")

gatun_package(tools
  NAME        gatun
  SECTION     science
  SUMMARY     "losslessly compressed meshes - program"
  DESCRIPTION "This package has the program gtn, which packs, checks, draws, contours and simplifies meshes and volumes on the command line, \
its manual pages, and completion for bash and zsh."
  DEPENDS     "${gatun_library_package} ${gatun_same_version}"
              "gatun-data ${gatun_same_version}"
  SUGGESTS    gatun-tetgen paraview-gatun)

if (GATUN_ENABLE_TETGEN)
  set(gatun_about_tetgen
    "TetGen, and this package with the program that links it, is under the GNU Affero General Public License, unlike the rest of Gatun.")
  gatun_package(tetgen
    NAME        gatun-tetgen
    SECTION     science
    LICENSE     tetgen
    SHARED
    SUMMARY     "losslessly compressed meshes for VTK - tetrahedra by TetGen"
    DESCRIPTION "This package fills surfaces with tetrahedra: gtn mesh, the library vtkGatunTetGen, and the program gatun-tetgen, which both start."
                "${gatun_about_tetgen}"
    SUGGESTS    gatun python3-gatun-tetgen
    OVERRIDES
      "# The library, what gtn loads of it and the program that they start are one package, which the user chooses for its license."
      "gatun-tetgen: package-name-doesnt-match-sonames")
  gatun_package(tetgen_development
    NAME        gatun-tetgen-dev
    SECTION     libdevel
    LICENSE     tetgen
    SUMMARY     "losslessly compressed meshes for VTK - TetGen, development files"
    DESCRIPTION "This package has the header of vtkGatunTetGen, and adds it to the CMake package Gatun."
                "${gatun_about_tetgen}"
    DEPENDS     "gatun-tetgen ${gatun_same_version}"
                "libgatun-dev ${gatun_same_version}")
endif ()

if (GATUN_WRAP_PYTHON)
  math(EXPR gatun_next_minor "${Python3_VERSION_MINOR} + 1")
  set(gatun_python_depends
    "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}~)"
    "python3 (<< ${Python3_VERSION_MAJOR}.${gatun_next_minor})")
  gatun_package(python
    NAME        python3-gatun
    SECTION     python
    SUMMARY     "losslessly compressed meshes for VTK - Python package"
    DESCRIPTION "This package has short functions for files, images and arrays of NumPy, and the classes for Python's VTK."
    DEPENDS     "${gatun_library_package} ${gatun_same_version}"
                ${gatun_python_depends}
                python3-numpy
                "python3-vtk9 (>= ${VTK_VERSION})" "python3-vtk9 (<< ${gatun_next_vtk})"
    SUGGESTS    gatun python3-gatun-tetgen
    CONTROL     "${gatun_packaging_folder}/debian/python/postinst"
                "${gatun_packaging_folder}/debian/python/prerm")
  if (GATUN_ENABLE_TETGEN)
    gatun_package(tetgen_python
      NAME        python3-gatun-tetgen
      SECTION     python
      LICENSE     tetgen
      SUMMARY     "losslessly compressed meshes for VTK - TetGen, Python module"
      DESCRIPTION "This package adds the class vtkGatunTetrahedralize to the Python package gatun."
                  "${gatun_about_tetgen}"
      DEPENDS     "gatun-tetgen ${gatun_same_version}"
                  "python3-gatun ${gatun_same_version}"
                  ${gatun_python_depends})
  endif ()
endif ()
