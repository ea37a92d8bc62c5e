// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The library gtnFormats. It is apart from the program because netCDF and HDF5 load half a hundred
// other libraries.

#include "gtnFormats.h"

#include "vtkExodusIIReader.h"
#include "vtkHDFReader.h"
#include "vtkNew.h"

#if GTN_HAS_CGNS
#include "vtkCGNSReader.h"
#endif

namespace
{

vtkSmartPointer<vtkAlgorithm> MakeExodus(const std::string& file, bool sets)
{
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  // The mesh is what the element blocks hold; side sets and node sets repeat parts of it.
  for (const auto kind : { vtkExodusIIReader::SIDE_SET, vtkExodusIIReader::NODE_SET })
  {
    for (int i = 0; sets && i < reader->GetNumberOfObjects(kind); ++i)
    {
      reader->SetObjectStatus(kind, i, 1);
    }
    reader->SetAllArrayStatus(kind, sets ? 1 : 0);
  }
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  return reader;
}

#if GTN_HAS_CGNS
vtkSmartPointer<vtkAlgorithm> MakeCGNS(const std::string& file, bool sets)
{
  vtkNew<vtkCGNSReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetLoadBndPatch(sets);
  reader->UpdateInformation();
  reader->EnableAllBases();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  return reader;
}
#else
constexpr decltype(gtn::FormatReaders::MakeCGNS) MakeCGNS = nullptr;
#endif

vtkSmartPointer<vtkAlgorithm> MakeHDF(const std::string& file)
{
  vtkNew<vtkHDFReader> reader;
  reader->SetFileName(file.c_str());
  return reader;
}

} // anonymous namespace

extern "C" const gtn::FormatReaders gtnFormatReaders;
const gtn::FormatReaders gtnFormatReaders{ MakeExodus, MakeCGNS, MakeHDF };
