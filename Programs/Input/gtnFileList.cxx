// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnFileList.h"

#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnMessages.h"
#include "gtnReadable.h"
#include "gtnText.h"
#include "gtnWords.h"
#include "gtnXMLPieces.h"

#include "vtkNew.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <fmt/core.h>

#include <algorithm>
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

  // time: as the list has it. Throws Failure if it is not a number as a whole.
  void Add(std::string time, const std::string& part)
  {
    const std::string given = time;
    time.erase(0, std::min(time.find_first_not_of(" \t\r\n"), time.size()));
    time.erase(time.find_last_not_of(" \t\r\n") + 1);
    std::replace_if(
      time.begin(), time.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e'); // of Fortran
    double number = 0;
    if (!ParseWord(time, number) || !std::isfinite(number))
    {
      throw Failure(this->File,
        fmt::format("the entry of {} has the time '{}', which is not a finite number",
          MakePrintableLine(part), MakePrintableLine(given)));
    }
    this->Add(number, part);
  }

  void Add(double time, const std::string& part)
  {
    std::vector<std::string>& files = this->Files[time + 0.]; // -0 is 0
    const std::string file = (this->Folder / part).lexically_normal().string();
    if (std::find(files.begin(), files.end(), file) == files.end())
    {
      files.push_back(file);
    }
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
  std::string timed; // an entry with a time, and one without
  std::string untimed;
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
    const char* const time = element->GetAttribute("timestep");
    (time ? timed : untimed) = part;
    if (!timed.empty() && !untimed.empty())
    {
      throw Failure(file,
        fmt::format("the entry of {} has no time, and that of {} has one",
          MakePrintableLine(untimed), MakePrintableLine(timed)));
    }
    steps.Add(std::string(time ? time : "0"), part);
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
      throw Failure(
        file, "the entry of " + MakePrintableLine(entry["name"].asString()) + " has no time");
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
std::string DescribeUnequal(const std::vector<SeriesStep>& steps)
{
  const auto other = std::find_if(steps.begin(), steps.end(),
    [&](const SeriesStep& step) { return step.Files.size() != steps.front().Files.size(); });
  if (other == steps.end())
  {
    return {};
  }
  const auto [fewer, more] = std::minmax(steps.front(), *other,
    [](const SeriesStep& a, const SeriesStep& b) { return a.Files.size() < b.Files.size(); });
  return fmt::format("{} files at time {}, and {} at time {}", more.Files.size(),
    DescribeNumber(more.Time), fewer.Files.size(), DescribeNumber(fewer.Time));
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
