# The core, which knows nothing of VTK: seventeen folders, each with a files.cmake, and the object library
# gatunObjects of their sources. VTK's module and the library without VTK are made of it. Both include this file;
# the first one makes the target.
#
# Sets headers, experimental_headers, private_headers and folders, relative to this folder, and gatun_libraries,
# what whoever uses the objects has to link.

# The core uses the vector types of GCC and clang.
if (NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  message(FATAL_ERROR "Gatun needs GCC or clang.")
endif ()

list(PREPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}/../CMake")
set(headers)
set(experimental_headers)
set(private_headers)
set(sources)
set(folders)

# gatun_core_folder(<folder> [INCLUDES <folder>...] [HEADERS <file>...]
#   [EXPERIMENTAL_HEADERS <file>...] [PRIVATE_HEADERS <file>...] SOURCES <file>...)
#
# HEADERS are installed and stable. EXPERIMENTAL_HEADERS are installed in a subfolder of their own
# and may change with every release. PRIVATE_HEADERS are not installed; GLM and other private
# libraries may appear there only. Utilities/check_includes.py holds a folder to its INCLUDES.
macro (gatun_core_folder folder)
  cmake_parse_arguments(arg "" ""
    "INCLUDES;HEADERS;EXPERIMENTAL_HEADERS;PRIVATE_HEADERS;SOURCES" ${ARGN})
  foreach (list IN ITEMS HEADERS EXPERIMENTAL_HEADERS PRIVATE_HEADERS SOURCES)
    list(TRANSFORM arg_${list} PREPEND "${folder}/")
  endforeach ()
  list(APPEND headers ${arg_HEADERS})
  list(APPEND experimental_headers ${arg_EXPERIMENTAL_HEADERS})
  list(APPEND private_headers ${arg_PRIVATE_HEADERS})
  list(APPEND sources ${arg_SOURCES})
  list(APPEND folders "${folder}")
endmacro ()

# Each may include those before it that it names.
foreach (name IN ITEMS
    Support Cells Coding Fast Walk Values Format Merge Parts Mesh Read Write Surface Rays Detail Hartley Describe)
  include("${CMAKE_CURRENT_LIST_DIR}/${name}/files.cmake")
endforeach ()

find_package(KissFFT REQUIRED) # headers only, as the next two, so that nobody else needs them
find_package(xxHash REQUIRED)
find_package(glm REQUIRED)
include(gatunJsonCpp)
include(gatunZstd)
list(APPEND gatun_libraries JsonCpp::JsonCpp)

if (TARGET gatunObjects)
  return ()
endif ()

include(gatunUnity)
list(TRANSFORM sources PREPEND "${CMAKE_CURRENT_LIST_DIR}/")

# gatun_set_options(<options> <source>...)
function (gatun_set_options options)
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/")
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${options}")
endfunction ()

# The loops of ray caster and projector, compiled for all processors and for those with AVX2 or AVX-512. Their
# results may differ in the last bits. errno and the floating-point flags are not used.
set(ray_options -O3 -ffp-contract=fast -fno-math-errno -fno-trapping-math -Wno-psabi)
gatun_set_options("${ray_options}"
  Hartley/gatunHartleyKernelPortable.cxx
  Rays/gatunRayKernelPortable.cxx)

# Least squares in lanes for the prediction of values. All versions give the same numbers.
set(lane_options -O3 -Wno-psabi)
gatun_set_options("${lane_options}"
  Values/gatunBlockNeighbors.cxx
  Values/gatunCellNeighbors.cxx
  Values/gatunNeighborLists.cxx
  Values/gatunQuadraticLanesPortable.cxx)

if (CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64")
  gatun_set_options("${ray_options};-mavx2;-mfma;-mf16c"
    Hartley/gatunHartleyKernelAVX2.cxx
    Rays/gatunRayKernelAVX2.cxx)
  gatun_set_options("${ray_options};-mavx2;-mfma;-mavx512f;-mavx512vl;-mavx512dq;-mavx512bw"
    Rays/gatunRayKernelAVX512.cxx)
  gatun_set_options("${lane_options};-mavx2"
    Values/gatunQuadraticLanesAVX2.cxx)
endif ()

# Where little time is spent, so that the library is small.
gatun_set_options(-Os
  Describe/gatunDescription.cxx
  Describe/gatunDescriptionText.cxx
  Describe/gatunLayerDescription.cxx
  Describe/gatunMeshDescription.cxx
  Describe/gatunVolumeDescription.cxx
  Format/gatunAtomicFile.cxx
  Format/gatunExtents.cxx
  Format/gatunFieldTable.cxx
  Format/gatunLayerTable.cxx
  Format/gatunOutputFile.cxx
  Format/gatunSeriesTable.cxx
  Format/gatunSurfaceTable.cxx
  Merge/gatunDependencyCheck.cxx
  Merge/gatunDependencyCodec.cxx
  Merge/gatunMergeCodec.cxx
  Merge/gatunMergeInputCheck.cxx
  Merge/gatunMergeRanks.cxx
  Merge/gatunMergeTree.cxx
  Merge/gatunSimplifyTarget.cxx
  Parts/gatunBrickBuilder.cxx
  Parts/gatunBrickDivision.cxx
  Parts/gatunBrickFile.cxx
  Parts/gatunBrickGroup.cxx
  Parts/gatunPartMerges.cxx
  Read/gatunBoundaryCheck.cxx
  Read/gatunFileReaderBoundary.cxx
  Read/gatunFileReaderLayers.cxx
  Read/gatunFileReaderSeries.cxx
  Read/gatunFileReaderTree.cxx
  Read/gatunSharedFile.cxx
  Read/gatunVerifyFile.cxx
  Write/gatunBaseMesh.cxx
  Write/gatunBoundaryMerge.cxx
  Write/gatunBoundaryMesh.cxx
  Write/gatunCellSubset.cxx
  Write/gatunFileWriter.cxx
  Write/gatunFileWriterSeries.cxx
  Write/gatunFileWriterTree.cxx
  Write/gatunMeshMerges.cxx
  Write/gatunPartAgreement.cxx
  Write/gatunPartAssembly.cxx
  Write/gatunPartExchange.cxx
  Write/gatunPartSurface.cxx
  Write/gatunPartSurvey.cxx
  Write/gatunPartLevels.cxx
  Write/gatunPartTree.cxx
  Write/gatunPartValues.cxx
  Write/gatunPartWriter.cxx
  Write/gatunPointNumbers.cxx
  Write/gatunStepTables.cxx
  Write/gatunTreeParts.cxx
  Write/gatunTreeSection.cxx
  Write/gatunWriterCheck.cxx
  Write/gatunWriterPart.cxx
  Write/gatunWriterState.cxx)

add_library(gatunObjects OBJECT ${sources})
gatun_set_unity_groups(gatunObjects ${sources})
target_compile_features(gatunObjects PUBLIC cxx_std_20)
set_target_properties(gatunObjects PROPERTIES
  CXX_EXTENSIONS            OFF
  CXX_VISIBILITY_PRESET     hidden
  VISIBILITY_INLINES_HIDDEN ON
  POSITION_INDEPENDENT_CODE ON)
# Coordinates and ranks must be the same, bit for bit, on every machine and with every compiler. errno
# is not used after a square root. Functions in sections of their own: the library without VTK leaves out those
# that nothing calls.
target_compile_options(gatunObjects PRIVATE
  -ffp-contract=off -fno-fast-math -fno-math-errno -ffunction-sections -Wpedantic)
foreach (folder IN LISTS folders)
  target_include_directories(gatunObjects PUBLIC "${CMAKE_CURRENT_LIST_DIR}/${folder}")
endforeach ()
target_link_libraries(gatunObjects
  PUBLIC  glm::glm
  PRIVATE KissFFT::KissFFT xxHash::xxHash ${gatun_libraries} $<TARGET_NAME_IF_EXISTS:gatunBuildFlags>)
