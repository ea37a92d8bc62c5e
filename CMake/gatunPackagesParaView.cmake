# The package of the ParaView build; see gatunPackaging.cmake. All of it is in the component of the
# plugin.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Gatun")

set(gatun_installed_plugin
  "${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Gatun/Gatun${CMAKE_SHARED_MODULE_SUFFIX}")

# ParaView's window takes plugins to load from its settings, all other programs from a file that a variable
# of the environment names.
string(REPLACE "/" "\\" paraview_key "${CMAKE_INSTALL_PREFIX}/bin/paraview")
string(REGEX REPLACE "^.(.*)" "\\1" paraview_key "${paraview_key}")
set(settings "ParaView${ParaView_VERSION}.ini")
configure_file("${gatun_packaging_folder}/ParaView.ini.in" "${CMAKE_BINARY_DIR}/packaging/${settings}" @ONLY)
configure_file("${gatun_packaging_folder}/paraview.plugins.xml.in"
  "${CMAKE_BINARY_DIR}/packaging/paraview.plugins.xml" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/packaging/${settings}"
  DESTINATION "/etc/xdg/ParaView"
  COMPONENT   plugin)
install(FILES "${CMAKE_BINARY_DIR}/packaging/paraview.plugins.xml"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/gatun"
  COMPONENT   plugin)
file(WRITE "${CMAKE_BINARY_DIR}/packaging/conffiles" "/etc/xdg/ParaView/${settings}\n")

gatun_next_version("${ParaView_VERSION}" gatun_next_paraview)
gatun_package(plugin
  NAME        paraview-gatun
  SECTION     science
  SUMMARY     "losslessly compressed meshes for ParaView"
  DESCRIPTION "This package has the plugin for ParaView, which loads it at its start. File > Open reads these files; \
filters and representations draw meshes that are larger than memory."
  DEPENDS     "paraview (>= ${ParaView_VERSION})" "paraview (<< ${gatun_next_paraview})"
              "gatun-data (= ${gatun_package_version})"
  SUGGESTS    gatun
  CONTROL     "${CMAKE_BINARY_DIR}/packaging/conffiles"
  OVERRIDES
    "# The plugin finds its own libraries in its folder, and ParaView's in theirs, as ParaView's plugins do."
    "paraview-gatun: custom-library-search-path *"
    "# The command is in the package paraview, which this one needs."
    "paraview-gatun: desktop-command-not-in-package paraview *")
