# Cells: the shapes of cells, and the tetrahedra that they are drawn as.
gatun_core_folder(Cells
  INCLUDES
    Support
  PRIVATE_HEADERS
    gatunCellGraph.h
    gatunCellList.h
    gatunCellShapes.h
    gatunCellSplitter.h
    gatunShapeTable.h
    gatunSimplices.h
  SOURCES
    gatunCellGraph.cxx
    gatunCellShapes.cxx
    gatunShapeTable.cxx)
