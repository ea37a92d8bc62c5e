// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnFileList.h"

#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnReadable.h"
#include "gtnText.h"
#include "gtnXMLPieces.h"

#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

namespace gtn
{
namespace
{

// The files of each time. Their names are relative to the list.
class Steps
{
public:
  explicit Steps(const std::string& file)
    : File(file)
    , Folder(std::filesystem::path(file).parent_path())
  {
  }

  void Add(double time, const std::string& part)
  {
    if (!std::isfinite(time))
    {
      throw Failure(this->File, "has a time that is not finite");
    }
    this->Files[time].push_back((this->Folder / part).string());
  }

  std::vector<SeriesStep> Get() const
  {
    if (this->Files.empty())
    {
      throw Failure(this->File, "lists no files");
    }
    std::vector<SeriesStep> list;
    for (const auto& [time, files] : this->Files)
    {
      list.push_back({ time, files });
    }
    return list;
  }

private:
  const std::string File;
  const std::filesystem::path Folder;
  std::map<double, std::vector<std::string>> Files;
};

std::vector<SeriesStep> ReadCollection(const std::string& file)
{
  vtkNew<vtkXMLDataParser> parser;
  vtkXMLDataElement* root = ParseXML(file, parser);
  vtkXMLDataElement* collection =
    root && root->GetName() && !std::strcmp(root->GetName(), "VTKFile")
    ? root->FindNestedElementWithName("Collection")
    : nullptr;
  if (!collection)
  {
    throw Failure(file, "is not a .pvd file");
  }

  Steps steps(file);
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = collection->GetNestedElement(i);
    if (!element->GetName() || std::strcmp(element->GetName(), "DataSet") != 0)
    {
      continue;
    }
    const char* part = element->GetAttribute("file");
    if (!part)
    {
      throw Failure(file, "has an entry without a file");
    }
    double time = 0;
    element->GetScalarAttribute("timestep", time);
    steps.Add(time, part);
  }
  return steps.Get();
}

std::vector<SeriesStep> ReadSeries(const std::string& file)
{
  CheckReadable(file);
  Json::Value root;
  std::string reason; // the message below is enough
  if (!ParseJson(file, root, reason) || !root.isObject() || !root["files"].isArray())
  {
    throw Failure(file, "is not a .series file");
  }
  Steps steps(file);
  for (const Json::Value& entry : root["files"])
  {
    if (!entry.isObject() || !entry["name"].isString())
    {
      throw Failure(file, "has an entry without a file");
    }
    if (!entry["time"].isNumeric())
    {
      throw Failure(file, "has an entry without a time");
    }
    steps.Add(entry["time"].asDouble(), entry["name"].asString());
  }
  return steps.Get();
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::vector<double> TimesOf(const std::vector<SeriesStep>& steps)
{
  std::vector<double> times;
  for (const SeriesStep& step : steps)
  {
    times.push_back(step.Time);
  }
  return times;
}

//------------------------------------------------------------------------------
bool IsFileList(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".pvd" || extension == ".series";
}

//------------------------------------------------------------------------------
std::vector<SeriesStep> ReadFileList(const std::string& file)
{
  return ExtensionOf(file) == ".pvd" ? ReadCollection(file) : ReadSeries(file);
}
}
