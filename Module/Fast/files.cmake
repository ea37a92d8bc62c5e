# Fast: the fast coder, of tetrahedra in the order of a tree and of values by what is around them.
gatun_core_folder(Fast
  INCLUDES
    Support
    Coding
  PRIVATE_HEADERS
    gatunFaceTable.h
    gatunGateValues.h
    gatunNumberStream.h
    gatunPackedBytes.h
    gatunTetTree.h
    gatunTreeEncoder.h
    gatunTreeSymbols.h
  SOURCES
    gatunGateValues.cxx
    gatunPackedBytes.cxx
    gatunTreeDecoder.cxx
    gatunTreeEncoder.cxx)
