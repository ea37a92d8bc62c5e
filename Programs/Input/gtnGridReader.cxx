// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnGridReader.h"

#include "gtnXMLPieces.h"

#include "gatunCellArrays.h"
#include "gatunFaceStream.h"
#include "gatunNewArray.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace gtn
{
namespace
{
// VTK 9.4 keeps the faces of polyhedra as version 2.3 does, and reads both.
template <typename Grid>
constexpr bool KnowsFaceLists = requires(Grid* grid)
{
  grid->GetPolyhedronFaces();
};
}

/** Reads the faces of version 2.3 after all else. */
class GridReader : public XMLPieceReader<vtkXMLUnstructuredGridReader>
{
public:
  static GridReader* New();
  vtkTypeMacro(GridReader, vtkXMLUnstructuredGridReader);

protected:
  void ReadXMLData() override
  {
    this->Values.clear();
    this->Locations.clear();
    this->Superclass::ReadXMLData();
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->GetCurrentOutput());
    if (!this->Values.empty() && grid &&
      grid->GetNumberOfCells() == static_cast<vtkIdType>(this->Locations.size()))
    {
      gatun::SetCells(grid, gatun::GetCellTypes(grid), grid->GetCells(),
        { gatun::MakeArray<vtkIdTypeArray>(this->Values),
          gatun::MakeArray<vtkIdTypeArray>(this->Locations) });
    }
  }

  int ReadPieceData() override
  {
    if (this->Superclass::ReadPieceData() == 0)
    {
      return 0;
    }
    vtkXMLDataElement* const cells = this->CellElements[this->Piece];
    const vtkIdType count = this->NumberOfCells[this->Piece];
    this->Locations.resize(static_cast<std::size_t>(this->StartCell + count), -1);
    if (KnowsFaceLists<vtkUnstructuredGrid> || !cells || count == 0 ||
      !this->FindDataArrayWithName(cells, "face_connectivity"))
    {
      return 1;
    }
    Lists lists;
    if (!this->ReadLists(cells, count, lists) || !this->AppendFaces(lists))
    {
      vtkErrorMacro("The faces of polyhedra in piece " << this->Piece << " are wrong.");
      this->DataError = 1;
      return 0;
    }
    return 1;
  }

private:
  using Integers = std::vector<vtkIdType>;

  /** The arrays of a piece. */
  struct Lists
  {
    Integers Points;
    Integers PointEnds;
    Integers Faces;
    Integers FaceEnds;
  };

  bool ReadIntegers(vtkXMLDataElement* cells, const char* name, vtkIdType count, Integers& integers)
  {
    // No compression of VTK makes a byte out of less than this.
    constexpr std::uintmax_t mostTimes = 1100;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(this->GetFileName(), error);
    vtkXMLDataElement* const element = this->FindDataArrayWithName(cells, name);
    if (!element || error || count < 0 || static_cast<std::uintmax_t>(count) / mostTimes > size)
    {
      return false;
    }
    const auto array = vtk::TakeSmartPointer(this->CreateArray(element));
    auto* const numbers = vtkDataArray::SafeDownCast(array);
    if (!numbers || numbers->GetNumberOfComponents() != 1)
    {
      return false;
    }
    gatun::SizeArray(numbers, count);
    integers.resize(static_cast<std::size_t>(count));
    if (count > 0 && this->ReadArrayValues(element, 0, numbers, 0, count) == 0)
    {
      return false;
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      integers[static_cast<std::size_t>(i)] = static_cast<vtkIdType>(numbers->GetComponent(i, 0));
    }
    return true;
  }

  static bool AreEnds(const Integers& ends)
  {
    return ends.empty() || (ends.front() >= 0 && std::is_sorted(ends.begin(), ends.end()));
  }

  /** Reads the arrays, whose sizes follow from each other. */
  bool ReadLists(vtkXMLDataElement* cells, vtkIdType count, Lists& lists)
  {
    const auto last = [](const Integers& ends) { return ends.empty() ? 0 : ends.back(); };
    if (!this->ReadIntegers(cells, "polyhedron_offsets", count, lists.FaceEnds) ||
      !AreEnds(lists.FaceEnds) ||
      !this->ReadIntegers(cells, "polyhedron_to_faces", last(lists.FaceEnds), lists.Faces))
    {
      return false;
    }
    const auto [least, most] = std::minmax_element(lists.Faces.begin(), lists.Faces.end());
    const bool isEmpty = lists.Faces.empty();
    return (isEmpty || *least >= 0) &&
      this->ReadIntegers(cells, "face_offsets", isEmpty ? 0 : *most + 1, lists.PointEnds) &&
      AreEnds(lists.PointEnds) &&
      this->ReadIntegers(cells, "face_connectivity", last(lists.PointEnds), lists.Points);
  }

  /** Appends the faces of all cells of the piece. */
  bool AppendFaces(const Lists& lists)
  {
    // Few values of a file must not become many: a face is in two cells.
    constexpr std::size_t mostTimes = 16;
    const std::size_t most =
      this->Values.size() + mostTimes * (lists.Points.size() + lists.Faces.size());
    const vtkIdType points = this->GetNumberOfPointsInPiece(this->Piece);
    auto face = lists.Faces.begin();
    for (std::size_t cell = 0; cell < lists.FaceEnds.size(); ++cell)
    {
      const auto end = lists.Faces.begin() + lists.FaceEnds[cell];
      if (face == end)
      {
        continue;
      }
      this->Locations[static_cast<std::size_t>(this->StartCell) + cell] =
        static_cast<vtkIdType>(this->Values.size());
      this->Values.push_back(end - face);
      for (; face != end; ++face)
      {
        const auto number = static_cast<std::size_t>(*face);
        const vtkIdType from = number > 0 ? lists.PointEnds[number - 1] : 0;
        const vtkIdType to = lists.PointEnds[number];
        if (this->Values.size() + static_cast<std::size_t>(to - from) >= most)
        {
          return false;
        }
        this->Values.push_back(to - from);
        for (vtkIdType i = from; i < to; ++i)
        {
          const vtkIdType id = lists.Points[static_cast<std::size_t>(i)];
          if (id < 0 || id >= points)
          {
            return false;
          }
          this->Values.push_back(this->StartPoint + id);
        }
      }
    }
    return true;
  }

  // The faces of all cells so far, as gatun::FaceStream has them.
  Integers Values;
  Integers Locations;
};

vtkStandardNewMacro(GridReader);

//------------------------------------------------------------------------------
vtkSmartPointer<vtkXMLReader> MakeGridReader(const std::string& file)
{
  auto reader = vtkSmartPointer<GridReader>::New();
  reader->SetFileName(file.c_str());
  return reader;
}
}
