// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnObj.h"

#include "gtnFailure.h"
#include "gtnFileKind.h"
#include "gtnText.h"
#include "gtnWords.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace gtn
{
namespace
{

class ObjParser
{
public:
  explicit ObjParser(const std::string& file)
    : File(file)
  {
    this->Points->SetDataTypeToDouble();
  }

  void ReadLine(std::string_view line, std::size_t number)
  {
    this->Number = number;
    line = line.substr(0, line.find('#'));
    const std::string_view what = TakeWord(line);
    if (what == "v")
    {
      this->ReadPoint(line);
    }
    else if (what == "f")
    {
      this->ReadFace(line);
    }
    else
    {
      this->LeaveOut(what);
    }
  }

  /** What the file has and is not read. */
  std::vector<std::string> GetLeftOut() const
  {
    return { this->LeftOut.begin(), this->LeftOut.end() };
  }

  vtkSmartPointer<vtkPolyData> GetSurface() const
  {
    if (this->Points->GetNumberOfPoints() == 0)
    {
      throw Failure(this->File, "has no points");
    }
    // Points may come behind the faces that use them.
    if (this->Largest > this->Points->GetNumberOfPoints())
    {
      this->FailForPoint(this->LargestLine, this->Largest);
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(this->Points);
    surface->SetPolys(this->Faces);
    return surface;
  }

private:
  [[noreturn]] void Fail(const std::string& what) const
  {
    throw Failure(this->File, fmt::format("line {}: {}", this->Number, what));
  }

  [[noreturn]] void FailForPoint(std::size_t number, vtkIdType point) const
  {
    throw Failure(this->File,
      fmt::format(
        "line {}: a face names point {} of {}", number, point, this->Points->GetNumberOfPoints()));
  }

  void LeaveOut(std::string_view what)
  {
    constexpr std::array<std::pair<std::string_view, const char*>, 8> known{ {
      { "vt", "texture coordinates" },
      { "vn", "normals" },
      { "l", "lines" },
      { "p", "points without faces" },
      { "g", "groups" },
      { "o", "groups" },
      { "usemtl", "materials" },
      { "cstype", "curves and curved surfaces" },
    } };
    const auto* const found = std::find_if(
      known.begin(), known.end(), [what](const auto& entry) { return entry.first == what; });
    if (found != known.end())
    {
      this->LeftOut.insert(found->second);
    }
  }

  void ReadPoint(std::string_view line)
  {
    double point[3];
    for (double& coordinate : point)
    {
      const std::string_view word = TakeWord(line);
      if (!ParseWord(word, coordinate))
      {
        this->Fail(word.empty() ? "a point has less than 3 coordinates"
                                : fmt::format("'{}' is not a coordinate", MakePrintableLine(word)));
      }
    }
    this->Points->InsertNextPoint(point);
    TakeWord(line); // a weight, or the first part of a color
    if (!TakeWord(line).empty())
    {
      this->LeftOut.insert("colors");
    }
  }

  // Of 7/2/5, 7//5 and the like, 7 is the point; negative ones count from the last point so far.
  void ReadFace(std::string_view line)
  {
    this->Corners.clear();
    for (std::string_view word = TakeWord(line); !word.empty(); word = TakeWord(line))
    {
      const vtkIdType points = this->Points->GetNumberOfPoints();
      vtkIdType index = 0;
      if (!ParseWord(word.substr(0, word.find('/')), index))
      {
        this->Fail(fmt::format("'{}' is not a corner of a face", MakePrintableLine(word)));
      }
      if (index == 0 || index < -points)
      {
        this->FailForPoint(this->Number, index);
      }
      if (index > this->Largest)
      {
        this->Largest = index;
        this->LargestLine = this->Number;
      }
      this->Corners.push_back(index > 0 ? index - 1 : points + index);
    }
    if (this->Corners.size() < 3)
    {
      this->Fail("a face has less than 3 corners");
    }
    this->Faces->InsertNextCell(static_cast<vtkIdType>(this->Corners.size()), this->Corners.data());
  }

  const std::string File;
  std::size_t Number = 0;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Faces;
  std::vector<vtkIdType> Corners;
  std::set<std::string> LeftOut;
  vtkIdType Largest = 0; // index of a point
  std::size_t LargestLine = 0;
};

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadObj(const std::string& file,
  const std::function<bool(double)>& progress, std::vector<std::string>& leftOut)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    throw Failure(file, std::strerror(errno));
  }
  if (IsWideText(file))
  {
    throw Failure(file, "is text in UTF-16; save it as ASCII or UTF-8");
  }
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  ObjParser parser(file);
  double bytes = 0;
  std::size_t number = 0;
  std::string line;
  for (std::string part; std::getline(stream, part);)
  {
    ++number;
    bytes += static_cast<double>(part.size()) + 1;
    if (number % 4096 == 0 && !progress(bytes / size))
    {
      return vtkSmartPointer<vtkPolyData>::New(); // aborted
    }
    if (part.ends_with('\r'))
    {
      part.pop_back();
    }
    line += part;
    if (line.ends_with('\\'))
    {
      // The next one continues it.
      line.back() = ' ';
      continue;
    }
    parser.ReadLine(line, number);
    line.clear();
  }
  parser.ReadLine(line, number);
  if (stream.bad())
  {
    throw Failure(file, "cannot be read");
  }
  leftOut = parser.GetLeftOut();
  return parser.GetSurface();
}
}
