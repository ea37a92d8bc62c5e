// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPartList.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnText.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace gtn
{
namespace
{

// The element of a .pvtu or .pvtp file that lists the parts. parser: keeps it.
vtkXMLDataElement* ParsePartList(const std::string& file, vtkXMLDataParser* parser)
{
  const std::string extension = ExtensionOf(file);
  vtkXMLDataElement* root = ParseXML(file, parser);
  vtkXMLDataElement* list = root && root->GetName() && !std::strcmp(root->GetName(), "VTKFile")
    ? root->FindNestedElementWithName(extension == ".pvtu" ? "PUnstructuredGrid" : "PPolyData")
    : nullptr;
  if (!list)
  {
    throw Failure(file, "is not a " + extension + " file");
  }
  return list;
}

bool IsReal(int type)
{
  return type == VTK_FLOAT || type == VTK_DOUBLE;
}

// "point array 'u'".
std::string TitleOf(const XMLArrayForm& array)
{
  return fmt::format("{} array '{}'", array.Association == vtkDataObject::POINT ? "point" : "cell",
    MakePrintableLine(array.Name));
}

std::string KindOf(const XMLArrayForm& array)
{
  return array.Components == 1
    ? NameOfXMLType(array.Type)
    : fmt::format("{} with {} components", NameOfXMLType(array.Type), array.Components);
}

} // anonymous namespace

//------------------------------------------------------------------------------
bool IsPartList(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".pvtu" || extension == ".pvtp";
}

//------------------------------------------------------------------------------
std::vector<std::string> FindParts(const std::string& file, const InputOptions& options)
{
  if (!IsPartList(file))
  {
    return { file };
  }
  vtkNew<vtkXMLDataParser> parser;
  vtkXMLDataElement* list = ParsePartList(file, parser);
  std::vector<std::string> parts;
  for (int i = 0; i < list->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = list->GetNestedElement(i);
    if (!element->GetName() || std::strcmp(element->GetName(), "Piece") != 0)
    {
      continue;
    }
    const char* part = element->GetAttribute("Source");
    if (!part)
    {
      throw Failure(file, "has a piece without a file");
    }
    parts.push_back((std::filesystem::path(file).parent_path() / part).string());
  }
  if (parts.empty())
  {
    throw Failure(file, "lists no files");
  }
  return FindExisting(file, parts, options);
}

//------------------------------------------------------------------------------
std::vector<std::string> FindExisting(
  const std::string& list, const std::vector<std::string>& files, const InputOptions& options)
{
  std::vector<std::string> existing;
  std::vector<std::string> missing;
  for (const std::string& file : files)
  {
    std::error_code error;
    (std::filesystem::exists(file, error) ? existing : missing).push_back(file);
  }
  if (missing.empty())
  {
    return existing;
  }
  constexpr std::size_t enough = 8;
  std::vector<std::string> named(missing.begin(),
    missing.begin() + static_cast<std::ptrdiff_t>(std::min(enough, missing.size())));
  const std::string text = fmt::format("{} of {} files that it lists {} missing: {}{}",
    missing.size(), files.size(), missing.size() == 1 ? "is" : "are",
    MakePrintableLine(Join(named)), missing.size() > enough ? ", ..." : "");
  if (!options.SkipMissing)
  {
    throw Failure(list, text + "; gtn pack --skip-missing goes on without");
  }
  if (existing.empty())
  {
    throw Failure(list, text);
  }
  SayOnce(list, text, options.Quiet);
  return existing;
}

//------------------------------------------------------------------------------
PartForm::PartForm(
  const std::string& list, const std::vector<std::string>& files, const InputOptions& options)
  : List(list)
  , IsQuiet(options.Quiet)
{
  std::vector<Part> parts;
  for (const std::string& file : files)
  {
    Part part{ file, ReadXMLForm(file) };
    if (!part.Form.IsEmpty)
    {
      parts.push_back(std::move(part));
    }
  }
  if (parts.empty())
  {
    return;
  }
  this->Form.IsEmpty = false;
  this->MatchPoints(parts);
  this->MatchArrays(parts, options);
  if (!IsPartList(list))
  {
    return;
  }
  vtkNew<vtkXMLDataParser> parser;
  for (const XMLArrayForm& array : ReadListForm(ParsePartList(list, parser)).Arrays)
  {
    const XMLArrayForm* const own = FindSame(this->Form, array);
    const bool isGhosts = array.Name == vtkDataSetAttributes::GhostArrayName();
    if (!own && options.AllArrays && !isGhosts)
    {
      this->Warn("declares the " + TitleOf(array) + ", which no piece has");
    }
    else if (own && KindOf(*own) != KindOf(array))
    {
      this->Warn(fmt::format("declares the {} as {}; it is {} in the pieces", TitleOf(array),
        KindOf(array), KindOf(*own)));
    }
  }
}

//------------------------------------------------------------------------------
void PartForm::Warn(const std::string& what) const
{
  SayOnce(this->List, what, this->IsQuiet);
}

//------------------------------------------------------------------------------
void PartForm::MatchPoints(const std::vector<Part>& parts)
{
  this->Form.PointType = parts.front().Form.PointType;
  for (const Part& part : parts)
  {
    const int type = part.Form.PointType;
    if (type == this->Form.PointType)
    {
      continue;
    }
    if (!IsReal(type) || !IsReal(this->Form.PointType))
    {
      throw Failure(this->List,
        fmt::format("the points are {} in {} and {} in {}", NameOfXMLType(this->Form.PointType),
          parts.front().File, NameOfXMLType(type), part.File));
    }
    this->Warn("the points are Float32 in some pieces and Float64 in others; all become Float64");
    this->Form.PointType = VTK_DOUBLE;
    return;
  }
}

//------------------------------------------------------------------------------
void PartForm::MatchArrays(const std::vector<Part>& parts, const InputOptions& options)
{
  const auto isWanted = [&](const XMLArrayForm& array)
  {
    if (array.Name == vtkDataSetAttributes::GhostArrayName())
    {
      return false; // pieces without it have no ghosts
    }
    return options.AllArrays ||
      std::find(options.Arrays.begin(), options.Arrays.end(), array.Name) != options.Arrays.end();
  };
  for (const XMLArrayForm& array : parts.front().Form.Arrays)
  {
    if (isWanted(array))
    {
      this->MatchArray(parts, array);
    }
  }
  for (const Part& part : parts)
  {
    for (const XMLArrayForm& array : part.Form.Arrays)
    {
      if (isWanted(array) && !FindSame(this->Form, array))
      {
        throw Failure(this->List,
          fmt::format("the {} is in {}, but not in {}; choose others with --arrays", TitleOf(array),
            part.File, parts.front().File));
      }
    }
  }
}

//------------------------------------------------------------------------------
void PartForm::MatchArray(const std::vector<Part>& parts, XMLArrayForm array)
{
  bool differs = false;
  for (const Part& part : parts)
  {
    const XMLArrayForm* const other = FindSame(part.Form, array);
    if (!other)
    {
      throw Failure(this->List,
        fmt::format("the {} is in {}, but not in {}; choose others with --arrays", TitleOf(array),
          parts.front().File, part.File));
    }
    if (other->Components != array.Components ||
      (other->Type != array.Type && !(IsReal(other->Type) && IsReal(array.Type))))
    {
      throw Failure(this->List,
        fmt::format("the {} is {} in {}, and {} in {}; choose others with --arrays", TitleOf(array),
          KindOf(array), parts.front().File, KindOf(*other), part.File));
    }
    if (other->Type != array.Type)
    {
      differs = true;
      array.Type = VTK_DOUBLE;
    }
  }
  if (differs)
  {
    this->Warn("the " + TitleOf(array) +
      " is Float32 in some pieces and Float64 in others; all become Float64");
  }
  this->Form.Arrays.push_back(array);
}

//------------------------------------------------------------------------------
void PartForm::Apply(vtkDataSet* part) const
{
  auto* const set = vtkPointSet::SafeDownCast(part);
  vtkPoints* const points = set ? set->GetPoints() : nullptr;
  if (points && this->Form.PointType == VTK_DOUBLE && points->GetDataType() == VTK_FLOAT)
  {
    vtkNew<vtkPoints> real;
    real->SetDataTypeToDouble();
    real->GetData()->DeepCopy(points->GetData());
    real->GetData()->SetName(points->GetData()->GetName());
    set->SetPoints(real);
  }
  for (const XMLArrayForm& array : this->Form.Arrays)
  {
    vtkDataSetAttributes* data = part->GetAttributes(array.Association);
    vtkDataArray* const values = data->GetArray(array.Name.c_str());
    if (values && array.Type == VTK_DOUBLE && values->GetDataType() == VTK_FLOAT)
    {
      auto real = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_DOUBLE));
      real->DeepCopy(values);
      data->AddArray(real); // in its place
    }
  }
}
}
