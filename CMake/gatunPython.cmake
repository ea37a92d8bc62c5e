# The Python package gatun: the sources of Python/gatun, the wrapped modules, and type stubs.
#
#   gatun_add_python_package(MODULES <module>... LIBRARY_DESTINATION <folder>)
#
# MODULES are those to wrap, such as VTK::GatunIO, and LIBRARY_DESTINATION is where their libraries are
# installed. Sets gatun_python_destination, the folder of Python modules below the prefix, and
# gatun_python_path, the same in the build tree. A wrapped module fits one VTK and is in a folder named after
# it, so that the modules of the VTK build and of the ParaView build can be installed together.
function (gatun_add_python_package)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "LIBRARY_DESTINATION" "MODULES")
  set(source "${PROJECT_SOURCE_DIR}/Python")
  set(folder "${CMAKE_BINARY_DIR}/${VTK_PYTHONPATH}/gatun")
  set(destination "${VTK_PYTHONPATH}/gatun")

  vtk_module_wrap_python(
    MODULES             ${arg_MODULES}
    TARGET              GatunPython
    WRAPPED_MODULES     wrapped
    PYTHON_PACKAGE      gatun.vtk
    MODULE_DESTINATION  "${destination}/vtk/vtk${VTK_VERSION}"
    LIBRARY_DESTINATION "${arg_LIBRARY_DESTINATION}"
    CMAKE_DESTINATION   "${CMAKE_INSTALL_LIBDIR}/cmake/gatun"
    UTILITY_TARGET      gatunSanitizers
    BUILD_STATIC        OFF
    INSTALL_HEADERS     OFF)

  string(REPLACE "VTK::" "vtk" names "${wrapped}")
  # Modules are searched in this order. VTK's rendering is loaded for classes that need it.
  foreach (name IN ITEMS vtkGatunFilters vtkGatunIO)
    if ("${name}" IN_LIST names)
      list(REMOVE_ITEM names "${name}")
      list(PREPEND names "${name}")
    endif ()
  endforeach ()
  list(TRANSFORM names REPLACE "(.+)" "    \"\\1\"," OUTPUT_VARIABLE gatun_python_modules)
  list(JOIN gatun_python_modules "\n" gatun_python_modules)
  file(RELATIVE_PATH gatun_python_library "/${destination}" "/${CMAKE_INSTALL_LIBDIR}/libgatun.so.0")
  configure_file("${source}/gatun/_build.py.in" "${folder}/_build.py" @ONLY)
  set(files "${folder}/_build.py")

  file(GLOB sources CONFIGURE_DEPENDS "${source}/gatun/*.py" "${source}/gatun/py.typed")
  foreach (file IN LISTS sources)
    get_filename_component(name "${file}" NAME)
    configure_file("${file}" "${folder}/${name}" COPYONLY)
    list(APPEND files "${folder}/${name}")
  endforeach ()
  configure_file("${source}/gatun/vtk/__init__.py" "${folder}/vtk/__init__.py" COPYONLY)
  set(vtk_files "${folder}/vtk/__init__.py")

  # ParaView's plugin is beside the package.
  configure_file("${source}/gatun_paraview.py" "${folder}/../gatun_paraview.py" COPYONLY)
  install(FILES "${source}/gatun_paraview.py"
    DESTINATION "${VTK_PYTHONPATH}")

  # Other packages find the entry points of the package in its metadata: PyVista reads and saves files with them.
  set(metadata "gatun-${PROJECT_VERSION}.dist-info")
  configure_file("${source}/gatun.dist-info/METADATA.in" "${folder}/../${metadata}/METADATA" @ONLY)
  configure_file("${source}/gatun.dist-info/entry_points.txt" "${folder}/../${metadata}/entry_points.txt" COPYONLY)
  install(FILES "${folder}/../${metadata}/METADATA" "${folder}/../${metadata}/entry_points.txt"
    DESTINATION "${VTK_PYTHONPATH}/${metadata}")

  # The stubs are made by loading the modules, which a program with sanitizers or for another machine
  # does not let Python do, nor a ParaView outside the folders of the system.
  if (NOT CMAKE_CROSSCOMPILING AND NOT GATUN_SANITIZE AND gatun_build_vtk)
    set(stubs "${folder}/__init__.pyi" "${folder}/vtk/__init__.pyi")
    set(targets)
    set(headers)
    foreach (module IN LISTS wrapped)
      string(REPLACE "VTK::" "" name "${module}")
      list(APPEND stubs "${folder}/vtk/vtk${name}.pyi")
      list(APPEND targets "vtk${name}Python")
    endforeach ()
    foreach (module IN LISTS gatun_module_files)
      get_filename_component(module "${module}" DIRECTORY)
      list(APPEND headers "${module}")
    endforeach ()
    add_custom_command(
      OUTPUT  ${stubs}
      COMMAND "${CMAKE_COMMAND}" -E env
              "PYTHONPATH=${CMAKE_BINARY_DIR}/${VTK_PYTHONPATH}:$ENV{PYTHONPATH}"
              "PYTHONDONTWRITEBYTECODE=1"
              "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/CMake/generate_stubs.py" "${folder}" ${headers}
      DEPENDS "${PROJECT_SOURCE_DIR}/CMake/generate_stubs.py" ${files} ${vtk_files} ${targets}
      COMMENT "Making the type stubs of the package gatun"
      VERBATIM)
    add_custom_target(gatunPythonStubs ALL DEPENDS ${stubs})
    list(POP_FRONT stubs package_stub)
    list(APPEND files "${package_stub}")
    list(APPEND vtk_files ${stubs})
  endif ()

  install(FILES ${files}
    DESTINATION "${destination}")
  install(FILES ${vtk_files}
    DESTINATION "${destination}/vtk")
  set(gatun_python_destination "${VTK_PYTHONPATH}" PARENT_SCOPE)
  set(gatun_python_path "${CMAKE_BINARY_DIR}/${VTK_PYTHONPATH}" PARENT_SCOPE)
endfunction ()
