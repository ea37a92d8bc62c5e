// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The library gtnFormats. It is apart from the program because netCDF and HDF5 load half a hundred
// other libraries.

#include "gtnFormats.h"

#include "vtkCharArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExodusIIReader.h"
#include "vtkFieldData.h"
#include "vtkHDFReader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#if GTN_HAS_CGNS
#include "vtkCGNSReader.h"
#endif

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace
{

/** Clears what VTK leaves unset behind the ends of strings. */
class ExodusReader : public vtkExodusIIReader
{
public:
  static ExodusReader* New();
  vtkTypeMacro(ExodusReader, vtkExodusIIReader);

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const int result = this->Superclass::RequestData(request, inputs, outputs);
    auto* const output = vtkCompositeDataSet::GetData(outputs);
    if (output)
    {
      ClearTexts(output->GetFieldData());
      const auto iterator = vtk::TakeSmartPointer(output->NewIterator());
      for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      {
        ClearTexts(iterator->GetCurrentDataObject()->GetFieldData());
      }
    }
    return result;
  }

private:
  static void ClearTexts(vtkFieldData* field)
  {
    for (const char* name : { "QA_Records", "Info_Records" })
    {
      auto* const texts = vtkArrayDownCast<vtkCharArray>(field->GetArray(name));
      const vtkIdType size = texts ? texts->GetNumberOfComponents() : 0;
      for (vtkIdType i = 0; texts && i < texts->GetNumberOfTuples(); ++i)
      {
        char* const text = texts->GetPointer(i * size);
        std::fill(std::find(text, text + size, '\0'), text + size, '\0');
      }
    }
  }
};
vtkStandardNewMacro(ExodusReader);

vtkSmartPointer<vtkAlgorithm> MakeExodus(const std::string& file, bool sets)
{
  vtkNew<ExodusReader> reader;
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

// The blocks and sets that are read, by type and index, in the order of the output.
std::vector<std::pair<int, int>> ListExodusBlocks(vtkExodusIIReader* reader)
{
  std::vector<std::pair<int, int>> blocks;
  for (const int type : { vtkExodusIIReader::ELEM_BLOCK, vtkExodusIIReader::FACE_BLOCK,
         vtkExodusIIReader::EDGE_BLOCK, vtkExodusIIReader::ELEM_SET, vtkExodusIIReader::SIDE_SET,
         vtkExodusIIReader::FACE_SET, vtkExodusIIReader::EDGE_SET, vtkExodusIIReader::NODE_SET })
  {
    for (int i = 0; i < reader->GetNumberOfObjects(type); ++i)
    {
      if (reader->GetObjectStatus(type, i) != 0)
      {
        blocks.emplace_back(type, i);
      }
    }
  }
  return blocks;
}

int CountExodusBlocks(vtkAlgorithm* reader)
{
  return static_cast<int>(ListExodusBlocks(vtkExodusIIReader::SafeDownCast(reader)).size());
}

std::uint64_t EstimateExodusBlock(vtkAlgorithm* reader)
{
  auto* exodus = vtkExodusIIReader::SafeDownCast(reader);
  const auto bytesOf = [exodus](int type)
  {
    std::uint64_t bytes = 0;
    for (int i = 0; i < exodus->GetNumberOfObjectArrays(type); ++i)
    {
      bytes += sizeof(double) *
        static_cast<std::uint64_t>(exodus->GetNumberOfObjectArrayComponents(type, i));
    }
    return bytes;
  };
  constexpr std::uint64_t corners = 8; // of hexahedra
  constexpr std::uint64_t ids = 3 * sizeof(vtkIdType);
  std::uint64_t largest = 0;
  for (const auto& [type, index] : ListExodusBlocks(exodus))
  {
    const int entries = exodus->GetNumberOfEntriesInObject(type, index);
    const auto cells = static_cast<std::uint64_t>(std::max(0, entries));
    const auto points =
      std::min(corners * cells, static_cast<std::uint64_t>(exodus->GetNumberOfNodes()));
    const std::uint64_t bytes = cells * (corners * sizeof(vtkIdType) + ids + bytesOf(type)) +
      points * (3 * sizeof(double) + ids + bytesOf(vtkExodusIIReader::NODAL));
    largest = std::max(largest, bytes);
  }
  return largest;
}

void SelectExodusBlock(vtkAlgorithm* reader, int number)
{
  auto* exodus = vtkExodusIIReader::SafeDownCast(reader);
  int i = 0;
  for (const auto& [type, index] : ListExodusBlocks(exodus))
  {
    exodus->SetObjectStatus(type, index, i++ == number ? 1 : 0);
  }
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
const gtn::FormatReaders gtnFormatReaders{ MakeExodus, CountExodusBlocks, EstimateExodusBlock,
  SelectExodusBlock, MakeCGNS, MakeHDF };
