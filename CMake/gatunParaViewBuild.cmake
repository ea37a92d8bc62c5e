# The build of the ParaView plugin: the same module folders, against ParaView's own VTK.

find_package(ParaView 5.11 REQUIRED)

if (NOT PARAVIEW_USE_QT AND NOT PARAVIEW_USE_PYTHON)
  message(STATUS "Gatun: this ParaView has neither a window nor Python; the plugin is built anyway.")
endif ()

if (GATUN_ENABLE_TETGEN)
  list(APPEND gatun_module_files
    "${CMAKE_CURRENT_SOURCE_DIR}/Filters/TetGen/vtk.module")
endif ()

paraview_plugin_scan(
  PLUGIN_FILES            "${CMAKE_CURRENT_SOURCE_DIR}/paraview_plugin/paraview.plugin"
  PROVIDES_PLUGINS        gatun_plugins
  REQUIRES_MODULES        gatun_plugin_required_modules
  ENABLE_BY_DEFAULT       ON
  HIDE_PLUGINS_FROM_CACHE ON)

paraview_plugin_build(
  RUNTIME_DESTINATION  "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME    gatun.plugins.xml
  PLUGINS_COMPONENT    plugin
  INSTALL_HEADERS      OFF
  PLUGINS              ${gatun_plugins})

# The loadable file, for tests and for people: this build's Gatun.so.
set(gatun_plugin_file
  "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Gatun/Gatun${CMAKE_SHARED_MODULE_SUFFIX}")
