# Finds the C++ header of KissFFT, which works in any precision; systems have libraries of one or two only.
#
# Defines the target KissFFT::KissFFT and the variable KissFFT_FOUND.
find_path(KissFFT_INCLUDE_DIR
  NAMES         kissfft.hh
  PATH_SUFFIXES kissfft)
mark_as_advanced(KissFFT_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(KissFFT
  REQUIRED_VARS KissFFT_INCLUDE_DIR)

if (KissFFT_FOUND AND NOT TARGET KissFFT::KissFFT)
  add_library(KissFFT::KissFFT INTERFACE IMPORTED)
  target_include_directories(KissFFT::KissFFT SYSTEM INTERFACE "${KissFFT_INCLUDE_DIR}")
endif ()
