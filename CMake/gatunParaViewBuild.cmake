# The build of the ParaView plugin: the same module folders, against ParaView's own VTK.

# Named, because all components would need the developer packages of all that ParaView's window uses. The
# optional ones bring targets that the others link.
find_package(ParaView 5.11 REQUIRED
  COMPONENTS          ProcessXML RemotingViews VTKExtensionsFiltersRendering VTKExtensionsIOCore WrapClientServer
  OPTIONAL_COMPONENTS PythonInitializer VTKExtensionsIOExodus VTKExtensionsIOGeneral)

if (NOT PARAVIEW_USE_QT AND NOT PARAVIEW_USE_PYTHON)
  message(STATUS "Gatun: this ParaView has neither a window nor Python; the plugin is built anyway.")
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
  INSTALL_HEADERS      OFF
  PLUGINS              ${gatun_plugins})

# `import gatun` in pvpython and pvbatch, whether the plugin is loaded or not.
if (GATUN_WRAP_PYTHON AND PARAVIEW_USE_PYTHON)
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
