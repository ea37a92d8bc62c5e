# Cells: the shapes of cells, and the tetrahedra that they are drawn as.
gatun_core_folder(Cells
  INCLUDES
    Support
  PRIVATE_HEADERS
    gatunCellShapes.h
    gatunSimplices.h
  SOURCES
    gatunCellShapes.cxx)
