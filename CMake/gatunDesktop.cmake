# Desktops: the types of the files, their icons, and, with the plugin, the program that opens them.
set(gatun_packaging_folder "${PROJECT_SOURCE_DIR}/Packaging")
if (GATUN_BUILD_PARAVIEW_PLUGIN)
  install(FILES "${gatun_packaging_folder}/gatun-paraview.desktop"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
endif ()
if (gatun_build_vtk)
  install(FILES "${gatun_packaging_folder}/gatun.xml"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages")
  install(
    FILES
      "${gatun_packaging_folder}/icons/application-x-gatun-mesh.svg"
      "${gatun_packaging_folder}/icons/application-x-gatun-volume.svg"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/mimetypes")
endif ()
