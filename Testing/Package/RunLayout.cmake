# Installs each component of the build into a folder of its own, as packages are made of them, and checks
# what is where.
cmake_minimum_required(VERSION 3.22)
include("${CMAKE_CURRENT_LIST_DIR}/gatunRun.cmake")

file(REMOVE_RECURSE "${TEMP}")
foreach (component IN LISTS COMPONENTS)
  run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${TEMP}/${component}" --config "${CONFIG}"
    --component "${component}")
endforeach ()
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${TEMP}/all" --config "${CONFIG}")

# holds(<component> <regex>...): each regex matches a file, and each file one of them.
function (holds component)
  file(GLOB_RECURSE files RELATIVE "${TEMP}/${component}" "${TEMP}/${component}/*")
  foreach (regex IN LISTS ARGN)
    set(found ${files})
    list(FILTER found INCLUDE REGEX "^${regex}$")
    if (NOT found)
      message(FATAL_ERROR "${component} has no ${regex}: ${files}")
    endif ()
    list(FILTER files EXCLUDE REGEX "^${regex}$")
  endforeach ()
  if (files)
    message(FATAL_ERROR "${component} also has ${files}")
  endif ()
endfunction ()

set(library "lib[^/]*(/[^/]*-linux-gnu)?")
holds(runtime
  "${library}/libvtkGatunCore\\.so\\.[0-9.]+"
  "${library}/libvtkGatunIO\\.so\\.[0-9.]+"
  "${library}/libvtkGatunFilters\\.so\\.[0-9.]+"
  "${library}/libvtkGatunRendering\\.so\\.[0-9.]+"
  "share/doc/Gatun/LICENSE")
holds(development
  "include/gatun/vtkGatunReader\\.h"
  "include/gatun/[A-Za-z/]*\\.h"
  "${library}/libvtkGatun(Core|IO|Filters|Rendering)\\.so"
  "${library}/cmake/gatun/GatunConfig(Version)?\\.cmake"
  "${library}/cmake/gatun/Gatun-[a-z-]*\\.cmake"
  "${library}/cmake/gatun/Find[A-Za-z]*\\.cmake"
  "${library}/vtk/hierarchy/Gatun/[A-Za-z-]*\\.txt")
holds(tools
  "bin/gtn"
  "${library}/gatun/libgtnImages\\.so"
  "${library}/gatun/libgtnFormats\\.so"
  "share/man/man1/gtn\\.1"
  "share/man/man1/gtn-[a-z-]*\\.1"
  "share/bash-completion/completions/gtn"
  "share/zsh/site-functions/_gtn")
holds(data
  "share/mime/packages/gatun\\.xml"
  "share/icons/hicolor/scalable/mimetypes/application-x-gatun-(mesh|volume)\\.svg")
if ("tetgen" IN_LIST COMPONENTS)
  holds(tetgen
    "${library}/libvtkGatunTetGen\\.so\\.[0-9.]+"
    "${library}/gatun/gatun-tetgen"
    "${library}/gatun/libgtnTetGen\\.so")
  holds(tetgen_development
    "include/gatun/vtkGatun(TetGenModule|Tetrahedralize)\\.h"
    "${library}/libvtkGatunTetGen\\.so"
    "${library}/cmake/gatun/GatunTetGen-[a-z-]*\\.cmake"
    "${library}/vtk/hierarchy/GatunTetGen/[A-Za-z-]*\\.txt")
endif ()
if ("python" IN_LIST COMPONENTS)
  holds(python
    "lib/python3.*/gatun/__init__\\.py"
    "lib/python3.*/gatun/[A-Za-z_]*\\.(py|typed)"
    "lib/python3.*/gatun/(__init__|vtkGatun(Filters|IO|Rendering))\\.pyi"
    "lib/python3.*/gatun/vtkGatun(Filters|IO|Rendering)[^/]*\\.so")
endif ()

if ("tetgen_python" IN_LIST COMPONENTS)
  holds(tetgen_python
    "lib/python3.*/gatun/vtkGatunTetGen[^/]*\\.so"
    "lib/python3.*/gatun/vtkGatunTetGen\\.pyi")
endif ()

# Nothing is in no component.
file(GLOB_RECURSE all RELATIVE "${TEMP}/all" "${TEMP}/all/*")
foreach (file IN LISTS all)
  set(found FALSE)
  foreach (component IN LISTS COMPONENTS)
    # A link to a library of another component leads nowhere.
    if (EXISTS "${TEMP}/${component}/${file}" OR IS_SYMLINK "${TEMP}/${component}/${file}")
      set(found TRUE)
    endif ()
  endforeach ()
  if (NOT found)
    message(FATAL_ERROR "${file} is in no component")
  endif ()
endforeach ()

# gtn without TetGen's library says what is missing.
file(COPY "${TEMP}/runtime/" "${TEMP}/tools/" DESTINATION "${TEMP}/without")
file(WRITE "${TEMP}/surface.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
execute_process(COMMAND "${TEMP}/without/bin/gtn" mesh "${TEMP}/surface.obj" "${TEMP}/mesh.gtn"
  RESULT_VARIABLE code
  ERROR_VARIABLE errors)
if (NOT code EQUAL 1 OR ("tetgen" IN_LIST COMPONENTS AND NOT errors MATCHES "libgtnTetGen"))
  message(FATAL_ERROR "exit ${code}: ${errors}")
endif ()

# With it, TetGen is in a program of its own, and there is no other way to run it.
if ("tetgen" IN_LIST COMPONENTS)
  file(COPY "${TEMP}/runtime/" "${TEMP}/tools/" "${TEMP}/tetgen/" DESTINATION "${TEMP}/with")
  run("${TEMP}/with/bin/gtn" mesh "${TEMP}/surface.obj" "${TEMP}/mesh.gtn")
  file(GLOB_RECURSE program "${TEMP}/with/*/gatun-tetgen")
  file(REMOVE "${program}" "${TEMP}/mesh.gtn")
  execute_process(COMMAND "${TEMP}/with/bin/gtn" mesh "${TEMP}/surface.obj" "${TEMP}/mesh.gtn"
    RESULT_VARIABLE code
    ERROR_VARIABLE errors)
  if (NOT code EQUAL 1 OR NOT errors MATCHES "gatun-tetgen cannot be started" OR EXISTS "${TEMP}/mesh.gtn")
    message(FATAL_ERROR "exit ${code}: ${errors}")
  endif ()
endif ()

# Nor does the Python package need it.
if ("python" IN_LIST COMPONENTS)
  file(COPY "${TEMP}/python/" DESTINATION "${TEMP}/without")
  file(GLOB packages "${TEMP}/without/lib/python3*/*-packages")
  set(ENV{PYTHONPATH} "${packages}")
  run("${PYTHON}" -c "
import gatun
names = dir(gatun)
assert {'read', 'vtkGatunReader', 'vtkGatunVolumeMapper'} <= set(names), names
assert 'vtkGatunTetrahedralize' not in names and not hasattr(gatun, 'vtkGatunTetrahedralize')
gatun.vtkGatunReader()")
endif ()
