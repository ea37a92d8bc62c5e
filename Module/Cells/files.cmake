# Cells: the shapes of cells, and the tetrahedra that they are drawn as.
gatun_core_folder(Cells
  INCLUDES
    Support
  PRIVATE_HEADERS
    gatunCellForms.h
    gatunCellGraph.h
    gatunCellList.h
    gatunCellShapes.h
    gatunFormMaker.h
    gatunShapeTable.h
    gatunSimplices.h
  SOURCES
    gatunCellForms.cxx
    gatunCellGraph.cxx
    gatunCellShapes.cxx
    gatunFormMaker.cxx
    gatunShapeTable.cxx)
