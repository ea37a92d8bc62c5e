// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPly.h"

#include "gtnFailure.h"
#include "gtnPlyFile.h"
#include "gtnText.h"
#include "gtnWords.h"

#include "gatunCellCheck.h"
#include "gatunNewArray.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace gtn
{
namespace
{
using PlyNames = std::vector<std::string_view>;

/** Properties that are the components of one array. */
struct PlyGroup
{
  const char* Name;
  int Role;
  PlyNames Properties;
};

const std::vector<PlyGroup>& GetPlyGroups()
{
  using Roles = vtkDataSetAttributes;
  static const std::vector<PlyGroup> groups{ { "Normals", Roles::NORMALS, { "nx", "ny", "nz" } },
    { "RGBA", Roles::SCALARS, { "red", "green", "blue", "alpha" } },
    { "RGB", Roles::SCALARS, { "red", "green", "blue" } },
    { "TCoords", Roles::TCOORDS, { "u", "v" } }, { "TCoords", Roles::TCOORDS, { "s", "t" } },
    { "TCoords", Roles::TCOORDS, { "texture_u", "texture_v" } } };
  return groups;
}

/** The first name that is free: NAME, NAME (2) and so on. */
std::string FreeName(vtkDataSetAttributes* attributes, const std::string& name)
{
  std::string free = name;
  for (int i = 2; attributes->HasArray(free.c_str()); ++i)
  {
    free = fmt::format("{} ({})", name, i);
  }
  return free;
}

/** The id of a point; -1 for what cannot be one. */
vtkIdType ToPoint(double value)
{
  return value >= 0 && value <= std::numeric_limits<std::uint32_t>::max()
    ? static_cast<vtkIdType>(value)
    : -1;
}

/** Takes the values of the elements of one kind into arrays. */
class PlyColumns
{
public:
  explicit PlyColumns(const PlyElement& element)
    : Element(element)
    , Columns(element.Properties.size())
  {
  }

  /** Makes an array of these properties, if they are there, in no array yet, and of one type. With
   * isReal, they may have several types, and become float if all are, or else double. */
  vtkSmartPointer<vtkDataArray> Join(const PlyNames& names, bool isReal = false)
  {
    std::vector<std::size_t> places;
    std::set<int> types;
    for (const std::string_view name : names)
    {
      const auto& properties = this->Element.Properties;
      const auto found = std::find_if(properties.begin(), properties.end(),
        [&](const PlyProperty& property) { return property.Name == name; });
      const auto place = static_cast<std::size_t>(found - properties.begin());
      if (found == properties.end() || found->CountType != 0 || this->Columns[place].Array)
      {
        return nullptr;
      }
      places.push_back(place);
      types.insert(found->Type);
    }
    if (types.size() > 1 && !isReal)
    {
      return nullptr;
    }
    return this->Make(places,
      types.size() == 1 && (!isReal || types.count(VTK_FLOAT) == 1) ? *types.begin() : VTK_DOUBLE);
  }

  /** Makes arrays of all that are in none yet. */
  void AddAll(vtkDataSetAttributes* attributes)
  {
    for (const PlyGroup& group : GetPlyGroups())
    {
      if (const auto array = this->Join(group.Properties))
      {
        array->SetName(FreeName(attributes, group.Name).c_str());
        attributes->AddArray(array);
        if (!attributes->GetAbstractAttribute(group.Role))
        {
          attributes->SetActiveAttribute(array->GetName(), group.Role);
        }
      }
    }
    for (std::size_t i = 0; i < this->Columns.size(); ++i)
    {
      const PlyProperty& property = this->Element.Properties[i];
      if (property.CountType == 0 && !this->Columns[i].Array)
      {
        const auto array = this->Make({ i }, property.Type);
        array->SetName(FreeName(attributes, property.Name).c_str());
        attributes->AddArray(array);
      }
    }
  }

  void Set(std::size_t property, std::uint64_t number, double value) const
  {
    const Column& column = this->Columns[property];
    if (column.Array)
    {
      column.Array->SetComponent(static_cast<vtkIdType>(number), column.Component, value);
    }
  }

private:
  struct Column
  {
    vtkSmartPointer<vtkDataArray> Array;
    int Component = 0;
  };

  vtkSmartPointer<vtkDataArray> Make(const std::vector<std::size_t>& properties, int type)
  {
    auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    array->SetNumberOfComponents(static_cast<int>(properties.size()));
    gatun::SizeArray(array, static_cast<vtkIdType>(this->Element.Count));
    int component = 0;
    for (const std::size_t property : properties)
    {
      this->Columns[property] = { array, component++ };
    }
    return array;
  }

  const PlyElement& Element;
  std::vector<Column> Columns;
};

class PlyParser
{
public:
  using Report = std::function<bool(double)>;

  explicit PlyParser(std::string_view bytes)
    : Size(bytes.size())
    , File(bytes)
  {
  }

  /** Returns false if progress does, which is told the part that is done. */
  bool Read(const Report& progress)
  {
    for (const PlyElement& element : this->File.GetElements())
    {
      if (!this->ReadElement(element, progress))
      {
        return false;
      }
    }
    std::string_view rest = this->File.GetRest();
    if (!TakeWord(rest).empty())
    {
      if (this->File.IsText())
      {
        throw Failure("has more values than its header declares");
      }
      this->LeftOut.insert("bytes behind the last element");
    }
    return true;
  }

  vtkSmartPointer<vtkPolyData> GetSurface()
  {
    if (!this->Points || this->Points->GetNumberOfTuples() == 0)
    {
      throw Failure("has no points");
    }
    const auto faces = this->Faces.Make();
    const auto strips = this->Strips.Make();
    gatun::CheckPointIds(faces, this->Points->GetNumberOfTuples());
    gatun::CheckPointIds(strips, this->Points->GetNumberOfTuples());
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetData(this->Points);
    surface->SetPoints(points);
    surface->SetPolys(faces);
    surface->SetStrips(strips);
    surface->GetPointData()->ShallowCopy(this->OfPoints);
    if (strips->GetNumberOfCells() == 0)
    {
      surface->GetCellData()->ShallowCopy(this->OfFaces);
    }
    else if (this->OfFaces->GetNumberOfArrays() > 0)
    {
      this->LeftOut.insert("properties of faces, because there are strips, too");
    }
    return surface;
  }

  /** What the file has and is not read. */
  std::vector<std::string> GetLeftOut() const
  {
    return { this->LeftOut.begin(), this->LeftOut.end() };
  }

private:
  bool ReadElement(const PlyElement& element, const Report& progress)
  {
    PlyColumns columns(element);
    this->Prepare(element, columns);
    gatun::CellCollector* const cells = element.Name == "face" ? &this->Faces
      : element.Name == "tristrips"                            ? &this->Strips
                                                               : nullptr;
    const auto isCorners = [](const PlyProperty& property)
    { return property.Name == "vertex_indices" || property.Name == "vertex_index"; };
    const auto& properties = element.Properties;
    const auto corners = std::find_if(properties.begin(), properties.end(), isCorners);
    if (cells && element.Count > 0 && (corners == properties.end() || corners->CountType == 0))
    {
      throw Failure("has the element '" + element.Name + "' without the list 'vertex_indices'");
    }
    for (std::uint64_t i = 0; !properties.empty() && i < element.Count; ++i)
    {
      const auto left = static_cast<double>(this->File.GetRest().size());
      if (i % 4096 == 0 && !progress(1 - left / static_cast<double>(this->Size)))
      {
        return false;
      }
      for (std::size_t p = 0; p < properties.size(); ++p)
      {
        if (properties[p].CountType == 0)
        {
          columns.Set(p, i, this->File.Take(properties[p].Type));
        }
        else
        {
          this->ReadList(
            element, properties[p], cells && &properties[p] == &*corners ? cells : nullptr);
        }
      }
    }
    return true;
  }

  /** Makes the arrays of an element. */
  void Prepare(const PlyElement& element, PlyColumns& columns)
  {
    if (element.Name == "vertex")
    {
      this->Points = columns.Join({ "x", "y", "z" }, true);
      if (!this->Points)
      {
        throw Failure("has vertices without the properties x, y and z");
      }
      columns.AddAll(this->OfPoints);
    }
    else if (element.Name == "face")
    {
      columns.AddAll(this->OfFaces);
    }
    else if (element.Name != "tristrips")
    {
      this->LeftOut.insert("the element '" + MakePrintableLine(element.Name) + "'");
    }
    else if (element.Properties.size() > 1)
    {
      this->LeftOut.insert("properties of strips");
    }
  }

  /** cells: takes the values as points of cells, which -1 ends in strips; otherwise null. */
  void ReadList(const PlyElement& element, const PlyProperty& list, gatun::CellCollector* cells)
  {
    const std::uint64_t count = this->File.TakeCount(list);
    bool isOpen = cells == &this->Faces;
    for (std::uint64_t i = 0; i < count; ++i)
    {
      const double value = this->File.Take(list.Type);
      if (!cells)
      {
        continue;
      }
      isOpen = value != -1 || cells != &this->Strips;
      isOpen ? cells->AddPoint(ToPoint(value)) : cells->EndCell();
    }
    if (isOpen)
    {
      cells->EndCell();
    }
    if (!cells && count > 0)
    {
      this->LeftOut.insert(fmt::format("the list '{}' of the element '{}'",
        MakePrintableLine(list.Name), MakePrintableLine(element.Name)));
    }
  }

  const std::size_t Size;
  PlyFile File;
  vtkSmartPointer<vtkDataArray> Points;
  vtkNew<vtkPointData> OfPoints;
  vtkNew<vtkCellData> OfFaces;
  gatun::CellCollector Faces;
  gatun::CellCollector Strips;
  std::set<std::string> LeftOut;
};

std::string ReadAll(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(std::filesystem::file_size(file), '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
  {
    throw Failure(stream.eof() ? "cannot be read" : std::strerror(errno));
  }
  return bytes;
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadPly(const std::string& file,
  const std::function<bool(double)>& progress, std::vector<std::string>& leftOut)
{
  const std::string bytes = ReadAll(file);
  PlyParser parser(bytes);
  if (!parser.Read(progress))
  {
    return vtkSmartPointer<vtkPolyData>::New(); // aborted
  }
  auto surface = parser.GetSurface(); // which may leave out more
  leftOut = parser.GetLeftOut();
  return surface;
}
}
