# The Python package gatun: the sources of Python/gatun beside the wrapped modules, and type stubs.
#
#   gatun_add_python_package(DESTINATION <folder> MODULES <wrapped module>...)
#
# DESTINATION is the folder of Python modules, from the build tree and from the prefix. MODULES are as
# vtk_module_wrap_python gives them, such as VTK::GatunIO. gatun_python_path is set to the folder in the
# build tree. The stubs of vtkGatunTetGen are in the install component of that module, which may be left
# out of an installation.
function (gatun_add_python_package)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "DESTINATION" "MODULES")
  set(source "${PROJECT_SOURCE_DIR}/Python")
  set(folder "${CMAKE_BINARY_DIR}/${arg_DESTINATION}/gatun")

  string(REPLACE "VTK::" "vtk" names "${arg_MODULES}")
  # Modules are searched in this order. VTK's rendering is loaded for classes that need it.
  foreach (name IN ITEMS vtkGatunFilters vtkGatunIO)
    if ("${name}" IN_LIST names)
      list(REMOVE_ITEM names "${name}")
      list(PREPEND names "${name}")
    endif ()
  endforeach ()
  list(TRANSFORM names REPLACE "(.+)" "    \"\\1\"," OUTPUT_VARIABLE gatun_python_modules)
  list(JOIN gatun_python_modules "\n" gatun_python_modules)
  configure_file("${source}/gatun/_build.py.in" "${folder}/_build.py" @ONLY)
  set(files "${folder}/_build.py")

  file(GLOB sources CONFIGURE_DEPENDS "${source}/gatun/*.py" "${source}/gatun/py.typed")
  foreach (file IN LISTS sources)
    get_filename_component(name "${file}" NAME)
    configure_file("${file}" "${folder}/${name}" COPYONLY)
    list(APPEND files "${folder}/${name}")
  endforeach ()

  # The stubs are made by loading the modules, which a program with sanitizers or for another machine
  # does not let Python do.
  if (NOT CMAKE_CROSSCOMPILING AND NOT GATUN_SANITIZE)
    set(stubs "${folder}/__init__.pyi")
    set(targets)
    set(headers)
    foreach (module IN LISTS arg_MODULES)
      string(REPLACE "VTK::" "" name "${module}")
      list(APPEND stubs "${folder}/vtk${name}.pyi")
      list(APPEND targets "vtk${name}Python")
    endforeach ()
    foreach (module IN LISTS gatun_module_files ITEMS "${PROJECT_SOURCE_DIR}/Filters/TetGen/vtk.module")
      get_filename_component(module "${module}" DIRECTORY)
      list(APPEND headers "${module}")
    endforeach ()
    add_custom_command(
      OUTPUT  ${stubs}
      COMMAND "${CMAKE_COMMAND}" -E env
              "PYTHONPATH=${CMAKE_BINARY_DIR}/${arg_DESTINATION}:$ENV{PYTHONPATH}"
              "PYTHONDONTWRITEBYTECODE=1"
              "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/CMake/generate_stubs.py" "${folder}" ${headers}
      DEPENDS "${PROJECT_SOURCE_DIR}/CMake/generate_stubs.py" ${files} ${targets}
      COMMENT "Making the type stubs of the package gatun"
      VERBATIM)
    add_custom_target(gatunPythonStubs ALL DEPENDS ${stubs})
    list(APPEND files ${stubs})
  endif ()

  set(tetgen_files ${files})
  list(FILTER tetgen_files INCLUDE REGEX "/vtkGatunTetGen\\.pyi$")
  list(FILTER files EXCLUDE REGEX "/vtkGatunTetGen\\.pyi$")
  install(FILES ${tetgen_files}
    DESTINATION "${arg_DESTINATION}/gatun"
    COMPONENT   tetgen_python)
  install(FILES ${files}
    DESTINATION "${arg_DESTINATION}/gatun"
    COMPONENT   python)
  set(gatun_python_path "${CMAKE_BINARY_DIR}/${arg_DESTINATION}" PARENT_SCOPE)
endfunction ()
