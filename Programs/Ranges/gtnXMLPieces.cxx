// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnXMLPieces.h"

#include "gtnMessages.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

namespace gtn
{
vtkStandardNewMacro(XMLSurfaceReader);

namespace
{

std::vector<vtkXMLDataElement*> NestedNamed(vtkXMLDataElement* parent, std::string_view name)
{
  std::vector<vtkXMLDataElement*> found;
  for (int i = 0; parent && i < parent->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = parent->GetNestedElement(i);
    if (element->GetName() && element->GetName() == name)
    {
      found.push_back(element);
    }
  }
  return found;
}

// Whether a piece has neither points nor cells.
bool IsEmptyPiece(vtkXMLDataElement* piece)
{
  bool isCounted = false;
  for (const char* name : { "NumberOfPoints", "NumberOfCells", "NumberOfVerts", "NumberOfLines",
         "NumberOfStrips", "NumberOfPolys" })
  {
    vtkTypeInt64 count = 0;
    if (piece->GetScalarAttribute(name, count))
    {
      isCounted = true;
      if (count != 0)
      {
        return false;
      }
    }
  }
  return isCounted;
}

int TypeOf(vtkXMLDataElement* array)
{
  int type = 0;
  return array->GetWordTypeAttribute("type", type) ? type : 0;
}

void AddArrays(vtkXMLDataElement* data, int association, std::vector<XMLArrayForm>& arrays)
{
  for (int i = 0; data && i < data->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = data->GetNestedElement(i);
    const char* name = element->GetAttribute("Name");
    if (name)
    {
      XMLArrayForm& array = arrays.emplace_back();
      array.Association = association;
      array.Name = name;
      array.Type = TypeOf(element);
      element->GetScalarAttribute("NumberOfComponents", array.Components);
    }
  }
}

// Whether an array is there at a time step. Without a list of steps it is at all of them.
bool IsAtStep(vtkXMLDataElement* array, int step)
{
  const char* const listed = array->GetAttribute("TimeStep");
  if (!listed)
  {
    return true;
  }
  std::istringstream steps(listed);
  return std::find(std::istream_iterator<int>(steps), std::istream_iterator<int>(), step) !=
    std::istream_iterator<int>();
}

void RemoveOtherSteps(vtkXMLDataElement* piece, int step)
{
  for (int i = 0; i < piece->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* data = piece->GetNestedElement(i);
    for (int j = data->GetNumberOfNestedElements() - 1; j >= 0; --j)
    {
      if (!IsAtStep(data->GetNestedElement(j), step))
      {
        data->RemoveNestedElement(data->GetNestedElement(j));
      }
    }
  }
}

// prefix: "P" in a file that lists pieces, or nothing.
XMLForm ReadForm(vtkXMLDataElement* element, const std::string& prefix)
{
  XMLForm form;
  const auto find = [&](const char* name) -> vtkXMLDataElement*
  {
    const auto found = NestedNamed(element, prefix + name);
    return found.empty() ? nullptr : found.front();
  };
  vtkXMLDataElement* points = find("Points");
  form.PointType =
    points && points->GetNumberOfNestedElements() > 0 ? TypeOf(points->GetNestedElement(0)) : 0;
  AddArrays(find("PointData"), vtkDataObject::POINT, form.Arrays);
  AddArrays(find("CellData"), vtkDataObject::CELL, form.Arrays);
  return form;
}

// What differs between two pieces of a file that VTK's readers read as if it did not.
std::string FindDifference(const XMLForm& first, const XMLForm& other)
{
  if (first.PointType != 0 && other.PointType != 0 && first.PointType != other.PointType)
  {
    return "the points are " + NameOfXMLType(first.PointType) + " in one piece and " +
      NameOfXMLType(other.PointType) + " in another";
  }
  for (const XMLArrayForm& array : other.Arrays)
  {
    const XMLArrayForm* const same = FindSame(first, array);
    if (same && (same->Type != array.Type || same->Components != array.Components))
    {
      return "the array '" + MakePrintableLine(array.Name) + "' is " + NameOfXMLType(same->Type) +
        " x " + std::to_string(same->Components) + " in one piece and " +
        NameOfXMLType(array.Type) + " x " + std::to_string(array.Components) + " in another";
    }
  }
  return {};
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::string NameOfXMLType(int type)
{
  switch (type)
  {
    case VTK_FLOAT:
      return "Float32";
    case VTK_DOUBLE:
      return "Float64";
    case VTK_STRING:
      return "String";
    case VTK_BIT:
      return "Bit";
    case 0:
      return "of no known type";
    default:
      break;
  }
  const bool isSigned = vtkDataArray::GetDataTypeMin(type) < 0;
  return (isSigned ? "Int" : "UInt") + std::to_string(8 * vtkDataArray::GetDataTypeSize(type));
}

//------------------------------------------------------------------------------
vtkXMLDataElement* ParseXML(const std::string& file, vtkXMLDataParser* parser)
{
  CheckReadable(file);
  parser->SetFileName(file.c_str());
  parser->Parse();
  CheckMessages(file, true);
  return parser->GetRootElement();
}

//------------------------------------------------------------------------------
const XMLArrayForm* FindSame(const XMLForm& form, const XMLArrayForm& array)
{
  const auto found = std::find_if(form.Arrays.begin(), form.Arrays.end(),
    [&](const XMLArrayForm& other)
    { return other.Association == array.Association && other.Name == array.Name; });
  return found == form.Arrays.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
XMLForm ReadXMLForm(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  if (extension != ".vtu" && extension != ".vtp")
  {
    return {};
  }
  vtkNew<vtkXMLDataParser> parser;
  vtkXMLDataElement* root = ParseXML(file, parser);
  const auto meshes = NestedNamed(root, extension == ".vtu" ? "UnstructuredGrid" : "PolyData");
  const auto pieces = NestedNamed(meshes.empty() ? nullptr : meshes.front(), "Piece");
  const auto first = std::find_if_not(pieces.begin(), pieces.end(), IsEmptyPiece);
  if (first == pieces.end())
  {
    return {};
  }
  XMLForm form = ReadForm(*first, "");
  form.IsEmpty = false;
  return form;
}

//------------------------------------------------------------------------------
XMLForm ReadListForm(vtkXMLDataElement* list)
{
  return ReadForm(list, "P");
}

//------------------------------------------------------------------------------
int FindRequestedStep(vtkInformation* outInfo)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const double* const times = outInfo->Get(Pipeline::TIME_STEPS());
  const double* const end = times + outInfo->Length(Pipeline::TIME_STEPS());
  const auto* const found = std::find(times, end, outInfo->Get(Pipeline::UPDATE_TIME_STEP()));
  return found == end ? 0 : static_cast<int>(found - times);
}

//------------------------------------------------------------------------------
std::string PreparePieces(vtkXMLDataElement* mesh, int step)
{
  auto pieces = NestedNamed(mesh, "Piece");
  if (mesh->GetAttribute("TimeValues"))
  {
    for (vtkXMLDataElement* piece : pieces)
    {
      RemoveOtherSteps(piece, step);
    }
  }
  const auto filled = std::stable_partition(
    pieces.begin(), pieces.end(), [](vtkXMLDataElement* piece) { return !IsEmptyPiece(piece); });
  const bool isEmpty = filled == pieces.begin() && !pieces.empty();
  for (auto piece = isEmpty ? filled + 1 : filled; piece != pieces.end(); ++piece)
  {
    mesh->RemoveNestedElement(*piece);
  }
  if (isEmpty)
  {
    for (vtkXMLDataElement* points : NestedNamed(pieces.front(), "Points"))
    {
      pieces.front()->RemoveNestedElement(points);
    }
    vtkNew<vtkXMLDataElement> points;
    points->SetName("Points");
    vtkNew<vtkXMLDataElement> array;
    array->SetName("DataArray");
    array->SetAttribute("type", "Float32");
    array->SetAttribute("Name", "Points");
    array->SetAttribute("NumberOfComponents", "3");
    array->SetAttribute("format", "ascii");
    points->AddNestedElement(array);
    pieces.front()->AddNestedElement(points);
    return {};
  }
  const XMLForm first = pieces.empty() ? XMLForm() : ReadForm(pieces.front(), "");
  for (auto piece = pieces.begin(); piece != filled; ++piece)
  {
    const std::string difference = FindDifference(first, ReadForm(*piece, ""));
    if (!difference.empty())
    {
      return difference;
    }
  }
  return {};
}
}
