// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnXMLMesh.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnReadable.h"
#include "gtnText.h"
#include "gtnXMLPieces.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataCompressor.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace gtn
{
/** Reads everything but the points, cells and values. Gives the elements of the file. */
class XMLHeaderReader : public XMLPieceReader<vtkXMLUnstructuredGridReader>
{
public:
  static XMLHeaderReader* New();

  static vtkSmartPointer<XMLHeaderReader> Read(const std::string& file)
  {
    CheckReadable(file);
    auto reader = vtkSmartPointer<XMLHeaderReader>::New();
    reader->SetFileName(file.c_str());
    reader->Update();
    CheckMessages(file, true);
    return reader;
  }

  int CountPieces() const { return this->NumberOfPieces; }
  vtkIdType CountPoints(int piece) const { return this->NumberOfPoints[piece]; }
  vtkIdType CountCells(int piece) const { return this->NumberOfCells[piece]; }
  vtkXMLDataElement* GetPoints(int piece) const { return this->PointElements[piece]; }
  vtkXMLDataElement* GetCells(int piece) const { return this->CellElements[piece]; }
  vtkXMLDataElement* GetData(int piece, int association) const
  {
    return association == vtkDataObject::POINT ? this->PointDataElements[piece]
                                               : this->CellDataElements[piece];
  }

protected:
  void SetupOutputTotals() override
  {
    this->Superclass::SetupOutputTotals();
    this->TotalNumberOfPoints = 0;
    this->TotalNumberOfCells = 0;
  }
  int ReadPieceData() override { return 1; }
};

vtkStandardNewMacro(XMLHeaderReader);

struct XMLMesh::Piece
{
  std::uint64_t FirstPoint = 0; // of the mesh
  std::uint64_t FirstCell = 0;
  std::uint64_t Points = 0;
  std::uint64_t Cells = 0;
  std::unique_ptr<XMLArray> Coordinates;
  std::unique_ptr<XMLArray> Connectivity;
  std::unique_ptr<XMLArray> Offsets;
  std::unique_ptr<XMLArray> Types;
  std::unique_ptr<XMLFaces> Faces;                  // null if there are no polyhedra
  std::vector<std::unique_ptr<XMLArray>> Arrays[2]; // of points and cells
};

namespace
{

// The ids of gatun's writer have 32 bits.
constexpr std::uint64_t MostElements = std::numeric_limits<std::uint32_t>::max();

vtkXMLDataElement* FindArray(vtkXMLDataElement* parent, const char* name)
{
  for (int i = 0; parent && i < parent->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = parent->GetNestedElement(i);
    const char* other = element->GetAttribute("Name");
    if (!name || (other && !std::strcmp(other, name)))
    {
      return element;
    }
  }
  return nullptr;
}

vtkFieldData* DataOf(vtkUnstructuredGrid* grid, int association)
{
  return grid->GetAttributesAsFieldData(association);
}

} // anonymous namespace

//------------------------------------------------------------------------------
XMLSummary ReadXMLSummary(const std::string& file)
{
  const auto reader = XMLHeaderReader::Read(file);
  XMLSummary summary;
  for (int i = 0; i < reader->CountPieces(); ++i)
  {
    if (reader->CountPoints(i) < 0 || reader->CountCells(i) < 0)
    {
      throw Failure(file, "has a negative number of points or cells");
    }
    summary.Points += static_cast<std::uint64_t>(reader->CountPoints(i));
    summary.Cells += static_cast<std::uint64_t>(reader->CountCells(i));
  }
  summary.Grid = reader->GetOutput();
  try
  {
    summary.Corners = XMLMesh(file, nullptr, {}).CountCorners();
  }
  catch (const Failure&)
  {
    constexpr std::uint64_t ofHexahedron = 8;
    summary.Corners = ofHexahedron * summary.Cells;
  }
  return summary;
}

//------------------------------------------------------------------------------
std::uint64_t XMLMesh::CountCorners() const
{
  std::uint64_t count = 0;
  for (const Piece& piece : this->Pieces)
  {
    count += piece.Connectivity ? piece.Connectivity->GetSize() : 0;
    count += piece.Faces ? piece.Faces->GetSize() : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
XMLMesh::XMLMesh(const std::string& file, const std::vector<std::string>* arrays,
  const std::vector<std::string>& skip)
  : File(file)
{
  this->Reader = XMLHeaderReader::Read(file);
  if (this->Reader->GetNumberOfTimeSteps() > 0)
  {
    this->Refuse("has several time steps");
  }
  this->Template = this->Reader->GetOutput();
  const auto isIn = [](const std::vector<std::string>& names, const char* name)
  { return name && std::find(names.begin(), names.end(), name) != names.end(); };
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkFieldData* data = DataOf(this->Template, association);
    for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      const char* name = data->GetAbstractArray(i)->GetName();
      if ((arrays && !isIn(*arrays, name)) || isIn(skip, name))
      {
        data->RemoveArray(i);
      }
    }
  }

  vtkXMLDataParser* parser = this->Reader->GetXMLParser();
  vtkXMLDataElement* root = parser->GetRootElement();
  vtkXMLDataElement* appended = root->FindNestedElementWithName("AppendedData");
  if (!appended)
  {
    this->Refuse("has no appended data");
  }
  this->Data.File = file;
  this->Data.FileSize = std::filesystem::file_size(file);
  this->Changed = std::filesystem::last_write_time(file);
  this->Data.Stream.open(file, std::ios::binary);
  this->Data.Begin = static_cast<std::uint64_t>(parser->GetAppendedDataPosition());
  const char* encoding = appended->GetAttribute("encoding");
  this->Data.IsBase64 = !encoding || std::strcmp(encoding, "raw") != 0;
  const char* header = root->GetAttribute("header_type");
  this->Data.HeaderWord = header && !std::strcmp(header, "UInt64") ? 8 : 4;
  const char* order = root->GetAttribute("byte_order");
  this->Data.IsSwapped = order && !std::strcmp(order, "BigEndian");
  this->Data.Compressor = parser->GetCompressor();
  for (int i = 0; i < this->Reader->CountPieces(); ++i)
  {
    this->OpenPiece(i);
  }
  if (this->PointCount > MostElements || this->CellCount > MostElements)
  {
    throw Failure(file, "has more than 2^32 points or cells");
  }
}

//------------------------------------------------------------------------------
XMLMesh::~XMLMesh() = default;

//------------------------------------------------------------------------------
void XMLMesh::Refuse(const std::string& what) const
{
  throw Failure(this->File,
    what +
      ", so that it cannot be read in parts; this takes a file with appended data and one "
      "time step");
}

//------------------------------------------------------------------------------
// parent: the element around that of the array. name: null for the only array there. type: the one
// that it must have, or 0.
std::unique_ptr<XMLArray> XMLMesh::OpenArray(vtkXMLDataElement* parent, const char* name, int type)
{
  const std::string known = name ? name : "Points";
  vtkXMLDataElement* element = FindArray(parent, name);
  if (!element)
  {
    throw Failure(this->File, "a piece has no array '" + MakePrintableLine(known) + "'");
  }
  const char* format = element->GetAttribute("format");
  if (!format || std::strcmp(format, "appended") != 0)
  {
    this->Refuse(
      "has an array '" + MakePrintableLine(known) + "' that is not in its appended data");
  }
  unsigned long long offset = 0;
  int found = 0;
  if (!element->GetScalarAttribute("offset", offset) ||
    !element->GetWordTypeAttribute("type", found) || found == VTK_BIT ||
    vtkDataArray::GetDataTypeSize(found) == 0)
  {
    this->Refuse(
      "has an array '" + MakePrintableLine(known) + "' without an offset or of a type of its own");
  }
  if (type != 0 &&
    (vtkDataArray::GetDataTypeSize(found) != vtkDataArray::GetDataTypeSize(type) ||
      (found == VTK_FLOAT || found == VTK_DOUBLE) != (type == VTK_FLOAT || type == VTK_DOUBLE)))
  {
    throw Failure(this->File,
      "the array '" + MakePrintableLine(known) + "' has different types in different pieces");
  }
  return std::make_unique<XMLArray>(this->Data, offset, found, known);
}

//------------------------------------------------------------------------------
void XMLMesh::OpenPiece(int number)
{
  const XMLHeaderReader& reader = *this->Reader;
  Piece piece;
  piece.FirstPoint = this->PointCount;
  piece.FirstCell = this->CellCount;
  if (reader.CountPoints(number) < 0 || reader.CountCells(number) < 0)
  {
    throw Failure(this->File, "has a negative number of points or cells");
  }
  piece.Points = static_cast<std::uint64_t>(reader.CountPoints(number));
  piece.Cells = static_cast<std::uint64_t>(reader.CountCells(number));
  this->PointCount += piece.Points;
  this->CellCount += piece.Cells;
  if (piece.Points == 0 && piece.Cells == 0)
  {
    return;
  }
  vtkPoints* points = this->Template->GetPoints();
  piece.Coordinates =
    this->OpenArray(reader.GetPoints(number), nullptr, points ? points->GetDataType() : 0);
  vtkXMLDataElement* cells = reader.GetCells(number);
  if (piece.Cells > 0)
  {
    piece.Connectivity = this->OpenArray(cells, "connectivity", 0);
    piece.Offsets = this->OpenArray(cells, "offsets", 0);
    piece.Types = this->OpenArray(cells, "types", 0);
    for (const auto* array : { piece.Connectivity.get(), piece.Offsets.get() })
    {
      this->WideIds = this->WideIds || vtkDataArray::GetDataTypeSize(array->GetType()) == 8;
    }
  }
  piece.Faces = piece.Cells > 0 ? this->OpenFaces(cells, piece.FirstCell) : nullptr;
  this->WithPolyhedra = this->WithPolyhedra || piece.Faces;
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkFieldData* data = DataOf(this->Template, association);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (!array->GetName() || !vtkDataArray::SafeDownCast(array) ||
        !std::strcmp(array->GetName(), "vtkGhostLevels"))
      {
        this->Refuse("has an array without a name, without numbers, or with old ghost levels");
      }
      const std::uint64_t tuples = association == vtkDataObject::POINT ? piece.Points : piece.Cells;
      piece.Arrays[association].push_back(tuples == 0
          ? nullptr
          : this->OpenArray(
              reader.GetData(number, association), array->GetName(), array->GetDataType()));
    }
  }
  this->Pieces.push_back(std::move(piece));
}

//------------------------------------------------------------------------------
// The faces of polyhedra as version 2.3 has them, or as earlier ones do, or null.
std::unique_ptr<XMLFaces> XMLMesh::OpenFaces(vtkXMLDataElement* cells, std::uint64_t firstCell)
{
  const auto fail = [this, firstCell](std::uint64_t cell) { this->FailFaces(firstCell + cell); };
  const auto open = [this, cells](const char* name) { return this->OpenArray(cells, name, 0); };
  if (FindArray(cells, "face_connectivity"))
  {
    return XMLFaces::FromLists({ open("face_connectivity"), open("face_offsets"),
                                 open("polyhedron_to_faces"), open("polyhedron_offsets") },
      fail);
  }
  if (FindArray(cells, "faces") && FindArray(cells, "faceoffsets"))
  {
    return XMLFaces::FromStream(open("faces"), open("faceoffsets"), fail);
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void XMLMesh::FailFaces(std::uint64_t cell) const
{
  throw Failure(this->File, "the faces of cell " + std::to_string(cell) + " are wrong");
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* XMLMesh::GetTemplate(std::size_t) const
{
  return this->Template;
}

//------------------------------------------------------------------------------
void XMLMesh::CheckUnchanged() const
{
  std::error_code error;
  if (std::filesystem::file_size(this->File, error) != this->Data.FileSize || error ||
    std::filesystem::last_write_time(this->File, error) != this->Changed || error)
  {
    throw Failure(this->File, "has changed while it was read");
  }
}

//------------------------------------------------------------------------------
template <typename Find, typename Read>
void XMLMesh::ForEachPiece(
  bool isPoints, std::uint64_t begin, std::size_t count, Find&& find, Read&& read)
{
  for (Piece& piece : this->Pieces)
  {
    const std::uint64_t first = isPoints ? piece.FirstPoint : piece.FirstCell;
    const std::uint64_t end = first + (isPoints ? piece.Points : piece.Cells);
    const std::uint64_t from = std::max(begin, first);
    const std::uint64_t to = std::min(begin + count, end);
    if (from < to)
    {
      read(find(piece), from - first, static_cast<std::size_t>(to - from),
        static_cast<std::size_t>(from - begin));
    }
  }
}

//------------------------------------------------------------------------------
void XMLMesh::ReadPoints(std::uint64_t begin, std::size_t count, void* values)
{
  const auto find = [](Piece& piece) -> XMLArray& { return *piece.Coordinates; };
  const auto read = [&](XMLArray& array, std::uint64_t first, std::size_t tuples, std::size_t at)
  {
    const auto size = static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(array.GetType()));
    array.Read(3 * first, 3 * tuples, static_cast<std::uint8_t*>(values) + 3 * at * size);
  };
  this->ForEachPiece(true, begin, count, find, read);
}

//------------------------------------------------------------------------------
void XMLMesh::ReadArray(
  int association, int number, std::size_t, std::uint64_t begin, std::size_t count, void* values)
{
  vtkAbstractArray* array = DataOf(this->Template, association)->GetAbstractArray(number);
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  const auto size = static_cast<std::size_t>(array->GetDataTypeSize());
  const auto find = [&](Piece& piece) -> XMLArray&
  { return *piece.Arrays[association][static_cast<std::size_t>(number)]; };
  const auto read = [&](XMLArray& from, std::uint64_t first, std::size_t tuples, std::size_t at)
  {
    from.Read(components * first, components * tuples,
      static_cast<std::uint8_t*>(values) + components * at * size);
  };
  this->ForEachPiece(association == vtkDataObject::POINT, begin, count, find, read);
}

//------------------------------------------------------------------------------
// Reads the ends of cells, the first one being where the first cell begins. Returns the number of
// cells that are to be read at once.
std::size_t XMLMesh::CutCells(const Piece& piece, std::uint64_t begin, std::size_t count)
{
  constexpr std::int64_t mostPoints = 1 << 20;
  std::vector<std::int64_t>& ends = this->Ends;
  if (begin == 0)
  {
    piece.Offsets->ReadAs(0, count, ends);
    ends.insert(ends.begin(), 0);
  }
  else
  {
    piece.Offsets->ReadAs(begin - 1, count + 1, ends);
  }
  const auto most = static_cast<std::int64_t>(
    std::min<std::uint64_t>(piece.Connectivity->GetSize(), std::numeric_limits<int64_t>::max()));
  for (std::size_t i = 0; i <= count; ++i)
  {
    if (ends[i] < (i > 0 ? ends[i - 1] : 0) || ends[i] > most)
    {
      throw Failure(this->File,
        "the offsets of cell " + std::to_string(piece.FirstCell + begin + i - (i > 0)) +
          " are wrong");
    }
    if (i > 1 && ends[i] - ends[0] > mostPoints)
    {
      return i - 1;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void XMLMesh::ReadCells(std::uint64_t begin, std::size_t count, RangedCells& cells)
{
  cells = {};
  const auto found = std::find_if(this->Pieces.begin(), this->Pieces.end(),
    [begin](const Piece& piece)
    { return begin >= piece.FirstCell && begin - piece.FirstCell < piece.Cells; });
  if (found == this->Pieces.end() || count == 0)
  {
    return;
  }
  Piece& piece = *found;
  begin -= piece.FirstCell;
  count = static_cast<std::size_t>(std::min<std::uint64_t>(count, piece.Cells - begin));
  count = this->CutCells(piece, begin, count);
  const std::int64_t first = this->Ends.front();
  const auto points = static_cast<std::size_t>(this->Ends[count] - first);
  piece.Connectivity->ReadAs(static_cast<std::uint64_t>(first), points, this->Values);
  piece.Types->ReadAs(begin, count, this->Types);
  cells.Types.resize(count);
  cells.Sizes.resize(count);
  cells.Points.resize(points);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto name = [&] { return "cell " + std::to_string(piece.FirstCell + begin + i); };
    if (this->Types[i] < 0 || this->Types[i] > 255)
    {
      throw Failure(this->File, name() + " has a type that does not exist");
    }
    cells.Types[i] = static_cast<std::uint8_t>(this->Types[i]);
    cells.Sizes[i] = static_cast<std::uint32_t>(this->Ends[i + 1] - this->Ends[i]);
    for (auto p = static_cast<std::size_t>(this->Ends[i] - first);
         p < static_cast<std::size_t>(this->Ends[i + 1] - first); ++p)
    {
      const std::int64_t id = this->Values[p];
      if (id < 0 || static_cast<std::uint64_t>(id) >= piece.Points)
      {
        throw Failure(
          this->File, name() + " has the point " + std::to_string(id) + ", which does not exist");
      }
      cells.Points[p] =
        static_cast<std::uint32_t>(piece.FirstPoint + static_cast<std::uint64_t>(id));
    }
  }
  if (this->WithPolyhedra)
  {
    this->ReadFaces(piece, begin, count, cells);
  }
}

//------------------------------------------------------------------------------
void XMLMesh::ReadFaces(
  const Piece& piece, std::uint64_t begin, std::size_t count, RangedCells& cells)
{
  cells.FaceSizes.resize(count);
  if (!piece.Faces)
  {
    return;
  }
  std::vector<std::size_t> ends;
  piece.Faces->Read(begin, count, this->Values, ends);
  std::size_t from = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (ends[i] > from)
    {
      const std::size_t before = cells.Faces.size();
      this->AppendFaces(piece, begin + i, { this->Values.data() + from, ends[i] - from }, cells);
      cells.FaceSizes[i] = static_cast<std::uint32_t>(cells.Faces.size() - before);
      from = ends[i];
    }
    if (cells.Types[i] == VTK_POLYHEDRON && cells.FaceSizes[i] == 0)
    {
      throw Failure(this->File,
        "the polyhedron " + std::to_string(piece.FirstCell + begin + i) + " has no faces");
    }
  }
}

//------------------------------------------------------------------------------
// Checks the faces of a cell and appends them.
void XMLMesh::AppendFaces(const Piece& piece, std::uint64_t cell,
  std::span<const std::int64_t> values, RangedCells& cells) const
{
  std::size_t at = 0;
  const auto next = [&](std::uint64_t most)
  {
    if (at == values.size() || values[at] < 0 || static_cast<std::uint64_t>(values[at]) > most)
    {
      this->FailFaces(piece.FirstCell + cell);
    }
    return static_cast<std::uint32_t>(values[at++]);
  };
  const std::uint32_t faces = next(values.size());
  cells.Faces.push_back(faces);
  for (std::uint32_t f = 0; f < faces; ++f)
  {
    const std::uint32_t points = piece.Points > 0 ? next(values.size()) : next(0);
    cells.Faces.push_back(points);
    for (std::uint32_t p = 0; p < points; ++p)
    {
      cells.Faces.push_back(static_cast<std::uint32_t>(piece.FirstPoint + next(piece.Points - 1)));
    }
  }
  if (at != values.size())
  {
    this->FailFaces(piece.FirstCell + cell);
  }
}
}
