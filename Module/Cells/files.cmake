# Cells: the shapes of cells, and the tetrahedra that they are drawn as.
gatun_core_folder(Cells
  INCLUDES
    Support
  PRIVATE_HEADERS
    gatunCellList.h
    gatunCellShapes.h
    gatunSimplices.h
  SOURCES
    gatunCellShapes.cxx)
