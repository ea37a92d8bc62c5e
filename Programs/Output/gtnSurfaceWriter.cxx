// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSurfaceWriter.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnText.h"
#include "gtnWriteGatun.h"

#include "gatunSurfaceCells.h"
#include "gatunSurfaceTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSTLWriter.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleStrip.h"
#include "vtkXMLPolyDataWriter.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace gtn
{
const char* const SurfaceFormats = ".gtn .vtp .vtk .stl .ply .obj";

namespace
{
/** Tells the types of its cells from its lists. VTK crashes, as it does for the types of all cells,
 * if a polygon or strip has less than 3 corners. */
class ListedSurface : public vtkPolyData
{
public:
  static ListedSurface* New();
  vtkTypeMacro(ListedSurface, vtkPolyData);

  void GetCellTypes(vtkCellTypes* types) override { this->ListTypes(types); }
  virtual void GetDistinctCellTypes(vtkCellTypes* types) { this->ListTypes(types); } // VTK 9.6

private:
  void ListTypes(vtkCellTypes* types)
  {
    std::set<unsigned char> found;
    std::size_t list = 0;
    for (vtkCellArray* const cells :
      { this->GetVerts(), this->GetLines(), this->GetPolys(), this->GetStrips() })
    {
      for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
      {
        found.insert(
          gatun::GetSurfaceCell(static_cast<gatun::SurfaceList>(list), cells->GetCellSize(i)));
      }
      ++list;
    }
    types->Reset();
    for (const unsigned char type : found)
    {
      types->InsertNextType(type);
    }
  }
};
vtkStandardNewMacro(ListedSurface);

void Report(Progress& progress, vtkIdType done, vtkIdType count)
{
  if (done % 4096 == 0)
  {
    progress(static_cast<double>(done) / static_cast<double>(count));
    CheckInterrupt();
  }
}

void WriteVtp(
  vtkPolyData* surface, const std::string& file, Compressor compressor, Progress& progress)
{
  vtkNew<ListedSurface> listed;
  listed->ShallowCopy(surface);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(listed);
  writer->SetFileName(file.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  SetCompressor(writer, compressor);
  progress.Watch(writer);
  const bool good = writer->Write() != 0;
  CheckInterrupt();
  CheckWritten(writer, good, file);
}

void WriteLegacySurface(vtkPolyData* surface, const std::string& file, Progress& progress)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  writer->SetFileTypeToBinary();
  progress.Watch(writer);
  const bool good = writer->Write() != 0;
  CheckInterrupt();
  CheckWritten(writer, good, file);
}

void WriteStl(vtkPolyData* surface, const std::string& file, Progress& progress)
{
  if (surface->GetNumberOfPolys() > std::numeric_limits<std::uint32_t>::max())
  {
    throw Failure("has too many triangles for an .stl file");
  }
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  writer->SetFileTypeToBinary();
  writer->SetHeader("made by Gatun");
  progress.Watch(writer);
  const bool good = writer->Write() != 0;
  CheckInterrupt();
  CheckWritten(writer, good, file);
}

template <typename T>
void Append(std::string& bytes, T value)
{
  const auto place = bytes.size();
  bytes.resize(place + sizeof value);
  std::memcpy(bytes.data() + place, &value, sizeof value);
}

// Not by vtkPLYWriter, which does not look whether the disk is full, and knows no normals.
void WritePly(vtkPolyData* surface, const std::string& file, Progress& progress)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  const vtkIdType count = surface->GetNumberOfPolys();
  if (points > std::numeric_limits<std::int32_t>::max())
  {
    throw Failure("has too many points for a .ply file");
  }
  vtkDataArray* const normals = surface->GetPointData()->GetNormals();
  const bool isLarge =
    surface->GetPolys()->GetMaxCellSize() > std::numeric_limits<std::uint8_t>::max();
  std::string bytes = fmt::format("ply\nformat binary_{}_endian 1.0\ncomment made by Gatun\n"
                                  "element vertex {}\n"
                                  "property float x\nproperty float y\nproperty float z\n{}"
                                  "element face {}\n"
                                  "property list {} int vertex_indices\nend_header\n",
    std::endian::native == std::endian::little ? "little" : "big", points,
    normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "", count,
    isLarge ? "uint" : "uchar");
  for (vtkIdType i = 0; i < points; ++i)
  {
    for (vtkDataArray* const tuples : { surface->GetPoints()->GetData(), normals })
    {
      for (int c = 0; tuples && c < 3; ++c)
      {
        Append(bytes, static_cast<float>(tuples->GetComponent(i, c)));
      }
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    Report(progress, i, count);
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    surface->GetPolys()->GetCellAtId(i, size, corners);
    isLarge ? Append(bytes, static_cast<std::uint32_t>(size))
            : Append(bytes, static_cast<std::uint8_t>(size));
    for (vtkIdType k = 0; k < size; ++k)
    {
      Append(bytes, static_cast<std::int32_t>(corners[k]));
    }
  }
  WriteBytes(file, bytes);
}

// Not by vtkOBJWriter, which writes six digits, and does not look whether the disk is full.
void WriteObj(vtkPolyData* surface, const std::string& file, Progress& progress)
{
  fmt::memory_buffer text;
  const auto to = std::back_inserter(text);
  const auto write = [&](const char* what, vtkDataArray* tuples)
  {
    for (vtkIdType i = 0; tuples && i < tuples->GetNumberOfTuples(); ++i)
    {
      double tuple[3];
      tuples->GetTuple(i, tuple);
      if (tuples->GetDataType() == VTK_FLOAT)
      {
        // The shortest that give the same float again.
        fmt::format_to(to, "{} {} {} {}\n", what, static_cast<float>(tuple[0]),
          static_cast<float>(tuple[1]), static_cast<float>(tuple[2]));
      }
      else
      {
        fmt::format_to(to, "{} {} {} {}\n", what, tuple[0], tuple[1], tuple[2]);
      }
    }
  };
  vtkDataArray* const normals = surface->GetPointData()->GetNormals();
  fmt::format_to(to, "# made by Gatun\n");
  write("v", surface->GetPoints()->GetData());
  write("vn", normals);
  const vtkIdType count = surface->GetNumberOfPolys();
  for (vtkIdType i = 0; i < count; ++i)
  {
    Report(progress, i, count);
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    surface->GetPolys()->GetCellAtId(i, size, corners);
    if (size < 3)
    {
      continue;
    }
    fmt::format_to(to, "f");
    for (vtkIdType k = 0; k < size; ++k)
    {
      normals ? fmt::format_to(to, " {0}//{0}", corners[k] + 1)
              : fmt::format_to(to, " {}", corners[k] + 1);
    }
    fmt::format_to(to, "\n");
  }
  WriteBytes(file, { text.data(), text.size() });
}

//------------------------------------------------------------------------------
/** A surface whose strips are triangles, and with triangles only also its polygons. Formats that
 * need it hold no vertices, lines and arrays of cells. */
vtkSmartPointer<vtkPolyData> Divide(vtkPolyData* surface, bool trianglesOnly)
{
  vtkNew<vtkPolyData> divided;
  divided->SetPoints(surface->GetPoints());
  divided->GetPointData()->ShallowCopy(surface->GetPointData());
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(surface->GetPolys());
  vtkCellArray* const strips = surface->GetStrips();
  for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    strips->GetCellAtId(i, size, corners);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), corners, polygons);
  }
  divided->SetPolys(polygons);
  return trianglesOnly ? gatun::MakeTriangleSurface(divided)
                       : vtkSmartPointer<vtkPolyData>(divided);
}

void AddCount(std::vector<std::string>& list, vtkIdType count, const char* what)
{
  if (count > 0)
  {
    list.push_back(fmt::format("{} {}", GroupDigits(static_cast<std::uint64_t>(count)), what));
  }
}
}

//------------------------------------------------------------------------------
SurfaceFormat GetSurfaceFormat(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  if (extension == ".vtp" || extension == ".gtn" || extension == ".vtk")
  {
    return { true, true, true, true, true, true };
  }
  if (extension == ".obj")
  {
    return { true, false, false, true, true, false };
  }
  if (extension == ".ply")
  {
    return { true, false, false, true, false, true };
  }
  if (extension == ".stl")
  {
    return {};
  }
  throw UsageError(file + ": the name must end in .gtn, .vtp, .vtk, .stl, .ply or .obj");
}

//------------------------------------------------------------------------------
// VTK's lists may have such, and formats of triangles and faces cannot.
vtkIdType CountDegenerate(vtkCellArray* cells)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    count += cells->GetCellSize(i) < 3 ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
std::string ListLost(vtkPolyData* surface, const std::string& file)
{
  const SurfaceFormat format = GetSurfaceFormat(file);
  std::vector<std::string> lost;
  if (!format.Arrays)
  {
    AddCount(lost, surface->GetNumberOfVerts(), "vertices");
    AddCount(lost, surface->GetNumberOfLines(), "lines");
    AddCount(lost,
      (format.Degenerate ? 0 : CountDegenerate(surface->GetPolys())) +
        CountDegenerate(surface->GetStrips()),
      "polygons and strips of less than 3 corners");
    const bool hasNormals = format.Normals && surface->GetPointData()->GetNormals();
    AddCount(lost,
      surface->GetPointData()->GetNumberOfArrays() + surface->GetCellData()->GetNumberOfArrays() +
        surface->GetFieldData()->GetNumberOfArrays() - (hasNormals ? 1 : 0),
      "arrays");
  }
  if (!format.Double && surface->GetNumberOfPoints() > 0 &&
    surface->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    lost.emplace_back("double precision");
  }
  return Join(lost);
}

//------------------------------------------------------------------------------
void WriteSurface(
  vtkPolyData* surface, const std::string& file, Progress& progress, Compressor compressor)
{
  const std::string extension = ExtensionOf(file);
  if (extension == ".gtn")
  {
    WriteGatun(surface, file, progress);
    return;
  }
  const SurfaceFormat format = GetSurfaceFormat(file);
  vtkNew<vtkPolyData> whole;
  whole->ShallowCopy(format.Strips ? surface : Divide(surface, !format.Polygons).Get());
  if (!whole->GetPoints())
  {
    whole->SetPoints(vtkNew<vtkPoints>()); // without any, VTK's writers and readers complain
  }
  TemporaryFile temporary(file);
  try
  {
    if (extension == ".vtp")
    {
      WriteVtp(whole, temporary.GetName(), compressor, progress);
    }
    else
    {
      const auto write = extension == ".vtk" ? WriteLegacySurface
        : extension == ".stl"                ? WriteStl
        : extension == ".ply"                ? WritePly
                                             : WriteObj;
      write(whole, temporary.GetName(), progress);
    }
  }
  catch (const Failure& failure)
  {
    TakeErrors();
    throw Failure(file, failure.what());
  }
  CheckMessages(file, true);
  temporary.Commit();
}
}
