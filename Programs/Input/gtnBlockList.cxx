// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnBlockList.h"

#include "gtnFailure.h"
#include "gtnFileKind.h"
#include "gtnPartList.h"
#include "gtnReadable.h"
#include "gtnText.h"
#include "gtnXMLPieces.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace gtn
{
namespace
{

vtkSmartPointer<vtkDataObjectTree> MakeTree(std::string_view element)
{
  if (element == "Block")
  {
    return vtkSmartPointer<vtkMultiBlockDataSet>::New();
  }
  if (element == "Piece")
  {
    return vtkSmartPointer<vtkMultiPieceDataSet>::New();
  }
  return vtkSmartPointer<vtkPartitionedDataSet>::New();
}

// Follows the elements of a file as VTK's readers do.
class ListReader
{
public:
  ListReader(const std::string& file, const InputOptions& options)
    : File(file)
    , Options(options)
  {
  }

  BlockList Read()
  {
    BlockList list;
    list.Tree = this->ReadTree(this->File);
    if (this->Listed.empty())
    {
      throw Failure(this->File, "lists no files of blocks");
    }
    FindExisting(this->File, this->Listed, this->Options); // or names those that are missing
    list.Files = this->Files;
    list.Places = this->FindPlaces(list.Tree);
    return list;
  }

private:
  // The tree of a file, which may be in that of another one.
  vtkSmartPointer<vtkDataObjectTree> ReadTree(const std::string& file)
  {
    constexpr std::size_t mostLevels = 64;
    constexpr std::size_t mostLists = 1 << 16;
    if (this->Folders.size() >= mostLevels || ++this->Lists > mostLists)
    {
      throw Failure(file, "lists lists of blocks that list each other");
    }
    CheckReadable(file);
    CheckXMLType(file);
    vtkNew<vtkXMLDataParser> parser;
    vtkXMLDataElement* root = ParseXML(file, parser);
    this->Folders.push_back(std::filesystem::path(file).parent_path());
    vtkSmartPointer<vtkDataObjectTree> tree;
    for (int i = 0; root && i < root->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* element = root->GetNestedElement(i);
      const std::string_view name = element->GetName();
      if (name == "vtkMultiBlockDataSet")
      {
        tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      }
      else if (name == "vtkPartitionedDataSetCollection")
      {
        tree = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
      }
      if (tree)
      {
        this->Collect(element, tree);
        break;
      }
    }
    this->Folders.pop_back();
    if (!tree)
    {
      throw Failure(file, "is not a list of blocks");
    }
    return tree;
  }

  void Collect(vtkXMLDataElement* element, vtkDataObjectTree* tree)
  {
    unsigned next = 0;
    for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* nested = element->GetNestedElement(i);
      const std::string_view kind = nested->GetName();
      vtkSmartPointer<vtkDataObject> child;
      if (kind == "DataSet")
      {
        child = this->AddFile(nested);
      }
      else if (kind == "Block" || kind == "Piece" || kind == "Partitions")
      {
        const auto part = MakeTree(kind);
        this->Collect(nested, part);
        child = part;
      }
      else
      {
        continue; // such as field data
      }
      int index = static_cast<int>(next);
      nested->GetScalarAttribute("index", index);
      this->SetChild(tree, index, child, nested->GetAttribute("name"));
      next = static_cast<unsigned>(index) + 1;
    }
  }

  vtkSmartPointer<vtkDataObject> AddFile(vtkXMLDataElement* element)
  {
    const char* file = element->GetAttribute("file");
    if (!file)
    {
      return nullptr; // a block without data
    }
    const std::string path = (this->Folders.back() / file).string();
    if (IsBlockList(path) && std::filesystem::exists(path))
    {
      return this->ReadTree(path);
    }
    this->Listed.push_back(path);
    if (!std::filesystem::exists(path))
    {
      return nullptr; // a block without data, if it may be skipped
    }
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    this->Files.push_back(path);
    this->Grids.push_back(grid);
    return grid;
  }

  void SetChild(vtkDataObjectTree* tree, int index, vtkDataObject* child, const char* name)
  {
    constexpr int most = 1 << 24;
    if (index < 0 || index > most)
    {
      throw Failure(this->File, "has a block with the index " + std::to_string(index));
    }
    const auto number = static_cast<unsigned>(index);
    vtkInformation* info = nullptr;
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(tree))
    {
      blocks->SetBlock(number, child);
      info = blocks->GetMetaData(number);
    }
    else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(tree))
    {
      if (child && !vtkDataSet::SafeDownCast(child))
      {
        throw Failure(this->File, "has a list of blocks as a partition");
      }
      parts->SetPartition(number, child);
      info = parts->GetMetaData(number);
    }
    else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree))
    {
      auto* partitions = vtkPartitionedDataSet::SafeDownCast(child);
      if (!partitions)
      {
        throw Failure(this->File, "has a block outside of its partitions");
      }
      collection->SetPartitionedDataSet(number, partitions);
      info = collection->GetMetaData(number);
    }
    if (info && name)
    {
      info->Set(vtkCompositeDataSet::NAME(), name);
    }
  }

  std::vector<unsigned> FindPlaces(vtkDataObjectTree* tree) const
  {
    std::vector<unsigned> places(this->Grids.size());
    auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
    std::size_t found = 0;
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      const auto grid =
        std::find(this->Grids.begin(), this->Grids.end(), iterator->GetCurrentDataObject());
      places[static_cast<std::size_t>(grid - this->Grids.begin())] =
        iterator->GetCurrentFlatIndex();
      ++found;
    }
    if (found != places.size())
    {
      throw Failure(this->File, "has several blocks with the same index");
    }
    return places;
  }

  const std::string File;
  const InputOptions Options;
  std::vector<std::filesystem::path> Folders; // of the lists that are being read
  std::size_t Lists = 0;                      // that have been read
  std::vector<std::string> Listed;            // those that are missing included
  std::vector<std::string> Files;
  std::vector<vtkSmartPointer<vtkDataObject>> Grids;
};

} // anonymous namespace

//------------------------------------------------------------------------------
bool IsBlockList(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".vtm" || extension == ".vtmb" || extension == ".vtpc";
}

//------------------------------------------------------------------------------
BlockList ReadBlockList(const std::string& file, const InputOptions& options)
{
  return ListReader(file, options).Read();
}

//------------------------------------------------------------------------------
BlockList MakeBlockList(const std::string& file, std::size_t count)
{
  vtkNew<vtkMultiBlockDataSet> tree;
  BlockList list;
  for (std::size_t i = 0; i < count; ++i)
  {
    tree->SetBlock(static_cast<unsigned>(i), vtkSmartPointer<vtkUnstructuredGrid>::New());
    list.Files.push_back(file);
    list.Places.push_back(static_cast<unsigned>(i) + 1); // behind the tree itself
  }
  list.Tree = tree;
  return list;
}
}
