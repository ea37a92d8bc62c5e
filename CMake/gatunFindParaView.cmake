# Finds ParaView, and sets gatun_build_vtk to whether it uses the VTK of the system.

# Named, because all components would need the developer packages of all that ParaView's window uses. The
# optional ones bring targets that the others link.
find_package(ParaView 5.11 REQUIRED
  COMPONENTS          ProcessXML RemotingViews VTKExtensionsFiltersRendering VTKExtensionsIOCore WrapClientServer
  OPTIONAL_COMPONENTS PythonInitializer VTKExtensionsIOExodus VTKExtensionsIOGeneral)

# The package of ParaView's own VTK is in the folder of its package.
get_filename_component(gatun_paraview_package "${ParaView_CONFIG}" DIRECTORY)
get_filename_component(gatun_paraview_package "${gatun_paraview_package}" REALPATH)
get_filename_component(gatun_vtk_package "${VTK_DIR}" REALPATH)
string(FIND "${gatun_vtk_package}/" "${gatun_paraview_package}/" gatun_position)
if (gatun_position EQUAL 0)
  set(gatun_build_vtk OFF)
else ()
  message(STATUS "Gatun: ParaView ${ParaView_VERSION} uses VTK ${VTK_VERSION} of the system; one build for both")
endif ()
