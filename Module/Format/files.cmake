# Format: container, sections and tables, that is, what is on disk.
if (WIN32)
  set(system_sources gatunAtomicFileWindows.cxx gatunFileHandleWindows.cxx gatunWindowsNames.cxx)
else ()
  set(system_sources gatunAtomicFilePosix.cxx gatunFileHandlePosix.cxx)
endif ()

gatun_core_folder(Format
  INCLUDES
    Support
    Cells
    Coding
    Walk
  HEADERS
    gatunByteSource.h
    gatunFieldData.h
    gatunLayers.h
  PRIVATE_HEADERS
    gatunAtomicFile.h
    gatunCellMask.h
    gatunCellTable.h
    gatunCompress.h
    gatunContainer.h
    gatunExtents.h
    gatunFileHandle.h
    gatunFileSource.h
    gatunInputFile.h
    gatunLayerTable.h
    gatunMeshPages.h
    gatunMeshTable.h
    gatunMetaTable.h
    gatunOutputFile.h
    gatunSeriesTable.h
    gatunSpillSorter.h
    gatunStepPages.h
    gatunSurfaceTable.h
    gatunTableParts.h
    gatunTreeTable.h
    gatunWindowsNames.h
  SOURCES
    gatunAtomicFile.cxx
    gatunByteSource.cxx
    gatunCellMask.cxx
    gatunCellTable.cxx
    gatunCompress.cxx
    gatunContainer.cxx
    gatunExtents.cxx
    gatunFieldTable.cxx
    gatunFileSource.cxx
    gatunInputFile.cxx
    gatunLayerTable.cxx
    gatunMeshPages.cxx
    gatunMeshTable.cxx
    gatunMetaTable.cxx
    gatunOutputFile.cxx
    gatunSeriesTable.cxx
    gatunStepPages.cxx
    gatunSurfaceTable.cxx
    gatunTableParts.cxx
    gatunTreeTable.cxx
    ${system_sources})
