# The ParaView plugin, and for a ParaView with a VTK of its own the module folders built against that.

if (NOT PARAVIEW_USE_QT AND NOT PARAVIEW_USE_PYTHON)
  message(STATUS "Gatun: this ParaView has neither a window nor Python; the plugin is built anyway.")
endif ()

paraview_plugin_scan(
  PLUGIN_FILES            "${CMAKE_CURRENT_SOURCE_DIR}/paraview_plugin/paraview.plugin"
  PROVIDES_PLUGINS        gatun_plugins
  REQUIRES_MODULES        gatun_plugin_required_modules
  ENABLE_BY_DEFAULT       ON
  HIDE_PLUGINS_FROM_CACHE ON)

# The plugin has libraries of its own in its folder, which no system searches.
set(CMAKE_SKIP_INSTALL_RPATH OFF)
paraview_plugin_build(
  RUNTIME_DESTINATION  "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME    gatun.plugins.xml
  INSTALL_HEADERS      OFF
  PLUGINS              ${gatun_plugins})

# `import gatun` in pvpython and pvbatch, whether the plugin is loaded or not.
if (NOT gatun_build_vtk AND GATUN_WRAP_PYTHON AND PARAVIEW_USE_PYTHON)
  set(gatun_modules VTK::GatunFilters VTK::GatunIO VTK::GatunRendering)
  if (GATUN_ENABLE_TETGEN)
    list(APPEND gatun_modules VTK::GatunTetGen)
  endif ()
  include(gatunPython)
  gatun_add_python_package(
    MODULES             ${gatun_modules}
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Gatun")
endif ()

# The loadable file, for tests and for people: this build's Gatun.so.
set(gatun_plugin_file
  "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Gatun/Gatun${CMAKE_SHARED_MODULE_SUFFIX}")
