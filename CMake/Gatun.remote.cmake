# Gatun as a remote module of VTK. Put a copy of this file into the folder Remote of VTK's sources, and
# configure VTK with
#
#   -DVTK_MODULE_ENABLE_VTK_Gatun=YES -DGATUN_REPOSITORY=<URL or folder of the Git repository>
#
# VTK then clones the repository to Remote/Gatun and builds it with its own modules.
set(GATUN_REPOSITORY "" CACHE STRING "Git repository of Gatun: a URL or a folder")
set(GATUN_TAG "main" CACHE STRING "Branch, tag or commit of Gatun to build")

vtk_fetch_module(Gatun
  "Losslessly compressed unstructured meshes"
  GIT_REPOSITORY "${GATUN_REPOSITORY}"
  GIT_TAG        "${GATUN_TAG}")
