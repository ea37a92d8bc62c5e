// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The library gtnFormats. It is apart from the program because netCDF and HDF5 load half a hundred
// other libraries.

#include "gtnFormats.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCharArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExodusIIReader.h"
#include "vtkFieldData.h"
#include "vtkHDFReader.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#if GTN_HAS_CGNS
#include "vtkCGNSReader.h"
#endif

#if __has_include("vtkHDFWriter.h") // since VTK 9.4
#include "vtkHDFWriter.h"
#define GTN_WRITES_HDF 1
#else
#define GTN_WRITES_HDF 0
#endif

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{

/** Whether the numbers of elements and nodes of a file are other than 1, 2, 3 and so on. */
struct NumberMaps
{
  bool OfElements = false;
  bool OfNodes = false;
};

bool AreCounted(vtkDataArray* ids, vtkIdType& last)
{
  bool areCounted = true;
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfValues(); ++i)
  {
    areCounted = areCounted && ids->GetVariantValue(i).ToTypeInt64() == ++last;
  }
  return areCounted;
}

/** Calls a function with each block of an output. */
template <typename Visit>
void ForEachBlock(vtkCompositeDataSet* blocks, const Visit& visit)
{
  auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto* const block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      visit(block);
    }
  }
}

constexpr const char* ElementIds = "GlobalElementId";
constexpr const char* NodeIds = "GlobalNodeId";

/** A reader of one block, without arrays. */
void ReadBlock(vtkExodusIIReader* reader, int number)
{
  for (int i = 0; i < reader->GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++i)
  {
    reader->SetObjectStatus(vtkExodusIIReader::ELEM_BLOCK, i, i == number ? 1 : 0);
  }
  reader->Update();
}

/** The points of all cells of an output, one after the other. */
vtkDataArray* GetCorners(vtkExodusIIReader* reader, vtkDataSet*& grid)
{
  vtkCellArray* cells = nullptr;
  ForEachBlock(reader->GetOutput(),
    [&](vtkDataSet* block)
    {
      auto* const found = vtkUnstructuredGrid::SafeDownCast(block);
      grid = block;
      cells = found ? found->GetCells() : nullptr;
    });
  return cells ? cells->GetConnectivityArray() : nullptr;
}

/** Reads the mesh block by block: with the numbers of elements and nodes, and with the places of
 * nodes in the file. VTK 9.1 fails if it is asked for both at once. */
NumberMaps FindMaps(const std::string& file)
{
  NumberMaps maps;
  vtkNew<vtkExodusIIReader> numbered;
  numbered->GenerateGlobalElementIdArrayOn();
  numbered->GenerateGlobalNodeIdArrayOn();
  vtkNew<vtkExodusIIReader> plain;
  plain->SetSqueezePoints(false);
  for (vtkExodusIIReader* reader : { numbered.Get(), plain.Get() })
  {
    reader->SetFileName(file.c_str());
    reader->UpdateInformation();
  }
  vtkIdType last = 0;
  for (int i = 0; i < numbered->GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++i)
  {
    ReadBlock(numbered, i);
    ReadBlock(plain, i);
    vtkDataSet* grid = nullptr;
    vtkDataSet* other = nullptr;
    vtkDataArray* const points = GetCorners(numbered, grid);
    vtkDataArray* const places = GetCorners(plain, other);
    if (!points || !places || points->GetNumberOfValues() != places->GetNumberOfValues())
    {
      continue; // an empty block
    }
    maps.OfElements =
      !AreCounted(grid->GetCellData()->GetArray(ElementIds), last) || maps.OfElements;
    auto* const ids = vtkIdTypeArray::SafeDownCast(grid->GetPointData()->GetArray(NodeIds));
    for (vtkIdType k = 0; ids && k < points->GetNumberOfValues() && !maps.OfNodes; ++k)
    {
      const vtkIdType id = ids->GetValue(static_cast<vtkIdType>(points->GetComponent(k, 0)));
      maps.OfNodes = id != static_cast<vtkIdType>(places->GetComponent(k, 0)) + 1;
    }
  }
  return maps;
}

/** The same, but once for each file. */
const NumberMaps& GetMaps(const std::string& file)
{
  static std::map<std::string, NumberMaps> known;
  const auto found = known.find(file);
  return found != known.end() ? found->second : known.emplace(file, FindMaps(file)).first->second;
}

/** Keeps the numbers of elements and nodes as arrays, if they tell something, and of the global
 * variables the values of the time step. VTK's reader has these at all steps. Clears what it leaves
 * unset behind the ends of strings. */
class ExodusReader : public vtkExodusIIReader
{
public:
  static ExodusReader* New();
  vtkTypeMacro(ExodusReader, vtkExodusIIReader);

  void SetMaps(const NumberMaps& maps)
  {
    this->Maps = maps;
    this->SetGenerateGlobalElementIdArray(maps.OfElements);
    this->SetGenerateGlobalNodeIdArray(maps.OfNodes);
  }

protected:
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    const int result = this->Superclass::RequestData(request, inputVector, outputVector);
    auto* const blocks = vtkCompositeDataSet::GetData(outputVector);
    vtkInformation* const info = outputVector->GetInformationObject(0);
    if (result != 0 && blocks)
    {
      ClearTexts(blocks->GetFieldData());
      ForEachBlock(blocks,
        [&](vtkDataSet* block)
        {
          KeepNumbers(block->GetCellData(), "PedigreeElementId");
          KeepNumbers(block->GetPointData(), "PedigreeNodeId");
          ClearTexts(block->GetFieldData());
          this->KeepStep(block->GetFieldData(), info);
        });
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

  // Global ids would join the points of blocks. They stay as arrays with their names.
  static void KeepNumbers(vtkDataSetAttributes* attributes, const char* copy)
  {
    attributes->RemoveArray(copy);
    attributes->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
    attributes->SetActiveAttribute(-1, vtkDataSetAttributes::PEDIGREEIDS);
  }

  void KeepStep(vtkFieldData* field, vtkInformation* info)
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    const int steps = info->Has(Pipeline::TIME_STEPS()) ? info->Length(Pipeline::TIME_STEPS()) : 0;
    const double* const times = steps > 0 ? info->Get(Pipeline::TIME_STEPS()) : nullptr;
    vtkIdType step = 0;
    if (steps > 0 && info->Has(Pipeline::UPDATE_TIME_STEP()))
    {
      step =
        std::upper_bound(times, times + steps, info->Get(Pipeline::UPDATE_TIME_STEP())) - times;
      step = std::max<vtkIdType>(step - 1, 0);
    }
    for (int i = 0; i < this->GetNumberOfObjectArrays(GLOBAL); ++i)
    {
      const char* const name = this->GetObjectArrayName(GLOBAL, i);
      vtkDataArray* const all = field->GetArray(name);
      if (all && all->GetNumberOfTuples() == steps && steps > 0)
      {
        auto one = vtk::TakeSmartPointer(all->NewInstance());
        one->SetName(name);
        one->SetNumberOfComponents(all->GetNumberOfComponents());
        one->InsertNextTuple(step, all);
        field->AddArray(one); // in its place
      }
    }
  }

  NumberMaps Maps;
};

vtkStandardNewMacro(ExodusReader);

vtkSmartPointer<vtkAlgorithm> MakeExodus(const std::string& file, bool sets)
{
  vtkNew<ExodusReader> reader;
  reader->SetFileName(file.c_str());
  reader->ApplyDisplacementsOff(); // coordinates are those of the file
  reader->SetMaps(GetMaps(file));
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::GLOBAL, 1);
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

void ListExodusSets(vtkAlgorithm* reader, std::vector<std::string>& names)
{
  auto* const exodus = vtkExodusIIReader::SafeDownCast(reader);
  for (const auto kind : { vtkExodusIIReader::SIDE_SET, vtkExodusIIReader::NODE_SET })
  {
    for (int i = 0; i < exodus->GetNumberOfObjects(kind); ++i)
    {
      names.emplace_back(exodus->GetObjectName(kind, i));
    }
  }
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
constexpr decltype(gtn::FormatFunctions::MakeCGNS) MakeCGNS = nullptr;
#endif

/** The reader adds the time to the field data, where the pipeline has it already. */
class HDFReader : public vtkHDFReader
{
public:
  static HDFReader* New();
  vtkTypeMacro(HDFReader, vtkHDFReader);

protected:
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    const int done = this->vtkHDFReader::RequestData(request, inputVector, outputVector);
    vtkDataObject* const output = vtkDataObject::GetData(outputVector);
    vtkInformation* const info = outputVector->GetInformationObject(0);
    if (done && output && info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
    {
      output->GetFieldData()->RemoveArray("Time");
    }
    return done;
  }
};

vtkStandardNewMacro(HDFReader);

vtkSmartPointer<vtkAlgorithm> MakeHDF(const std::string& file)
{
  vtkNew<HDFReader> reader;
  reader->SetFileName(file.c_str());
  return reader;
}

#if GTN_WRITES_HDF
bool WriteHDF(vtkAlgorithm* source, const std::string& file, bool compress)
{
  constexpr int level = 4; // that HDF5 has by default
  vtkNew<vtkHDFWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->SetCompressionLevel(compress ? level : 0);
  return writer->Write() != 0;
}
#else
constexpr decltype(gtn::FormatFunctions::WriteHDF) WriteHDF = nullptr;
#endif

} // anonymous namespace

extern "C" const gtn::FormatFunctions gtnFormatFunctions;
const gtn::FormatFunctions gtnFormatFunctions{ MakeExodus, ListExodusSets, CountExodusBlocks,
  EstimateExodusBlock, SelectExodusBlock, MakeCGNS, MakeHDF, WriteHDF };
