// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSlices.h"

#include "gtnFailure.h"
#include "gtnImageFile.h"
#include "gtnInput.h"
#include "gtnNames.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "gatunArrayBridge.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSortFileNames.h"
#include "vtkStringArray.h"

#include <fmt/core.h>

#include <glob.h>

#include <cstring>
#include <filesystem>
#include <regex>

namespace gtn
{
const char* const SliceFormats = ".tif .tiff .png";

namespace
{

// One %d, or one with at most two digits in between.
const std::regex NumberedName("([^%]*)%([0-9]{0,2})d([^%]*)");

// Collects the slices of all files into one volume.
class Stack
{
public:
  explicit Stack(std::size_t files)
    : Files(files)
  {
  }

  void Add(const std::string& file, const Image& slice)
  {
    if (slice.Channels.size() != 1)
    {
      throw Failure(file,
        fmt::format("is an image of {} channels, and slices have one; convert it to gray first",
          slice.Channels.size()));
    }
    if (this->First.empty())
    {
      this->First = file;
      this->Shape = { slice.Width, slice.Height, {}, slice.Type };
      // A lone file may have many.
      this->Values.reserve(this->Files * gatun::SizeOf(slice.Type) *
        static_cast<std::size_t>(slice.Width) * static_cast<std::size_t>(slice.Height));
    }
    if (slice.Width != this->Shape.Width || slice.Height != this->Shape.Height)
    {
      throw Failure(file,
        fmt::format("has {} x {} pixels, unlike {} with {} x {}", slice.Width, slice.Height,
          this->First, this->Shape.Width, this->Shape.Height));
    }
    if (slice.Type != this->Shape.Type)
    {
      throw Failure(file,
        fmt::format("has values of type {}, unlike {} with {}", NameOfType(slice.Type), this->First,
          NameOfType(this->Shape.Type)));
    }
    const std::size_t row = gatun::SizeOf(slice.Type) * static_cast<std::size_t>(this->Shape.Width);
    const auto* const from = static_cast<const unsigned char*>(slice.Values);
    for (auto y = static_cast<std::size_t>(this->Shape.Height); y-- > 0;)
    {
      this->Values.insert(this->Values.end(), from + y * row, from + (y + 1) * row);
    }
    ++this->Slices;
  }

  vtkSmartPointer<vtkImageData> Finish()
  {
    auto volume = vtkSmartPointer<vtkImageData>::New();
    volume->SetDimensions(this->Shape.Width, this->Shape.Height, this->Slices);
    gatun::ArrayDescription description;
    description.Name = "values";
    description.Type = this->Shape.Type;
    gatun::ArrayFiller filler(description, volume->GetNumberOfPoints());
    if (!this->Values.empty())
    {
      std::memcpy(filler.GetBuffer(), this->Values.data(), this->Values.size());
    }
    volume->GetPointData()->SetScalars(filler.Finish());
    return volume;
  }

private:
  const std::size_t Files;
  std::string First;
  Image Shape;
  std::vector<unsigned char> Values;
  int Slices = 0;
};

} // anonymous namespace

//------------------------------------------------------------------------------
bool IsSlice(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".tif" || extension == ".tiff" || extension == ".png";
}

//------------------------------------------------------------------------------
std::vector<std::string> SortByNumbers(const std::vector<std::string>& files)
{
  vtkNew<vtkStringArray> names;
  for (const std::string& file : files)
  {
    names->InsertNextValue(file);
  }
  vtkNew<vtkSortFileNames> sort;
  sort->NumericSortOn();
  sort->SetInputFileNames(names);
  vtkStringArray* const sorted = sort->GetFileNames();
  return { sorted->GetPointer(0), sorted->GetPointer(0) + sorted->GetNumberOfValues() };
}

//------------------------------------------------------------------------------
std::vector<std::string> FindSlices(const std::string& folderOrPattern)
{
  std::error_code error;
  const bool isFolder = std::filesystem::is_directory(folderOrPattern, error);
  std::vector<std::string> files;
  if (isFolder)
  {
    for (const auto& entry : std::filesystem::directory_iterator(folderOrPattern, error))
    {
      files.push_back(entry.path().string());
    }
    if (error)
    {
      throw Failure(folderOrPattern, error.message());
    }
  }
  else if (IsAddress(folderOrPattern) ||
    folderOrPattern.find_first_of("*?[") == std::string::npos ||
    std::filesystem::exists(folderOrPattern, error))
  {
    return { folderOrPattern };
  }
  else
  {
    glob_t found{};
    ::glob(folderOrPattern.c_str(), 0, nullptr, &found);
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    ::globfree(&found);
  }
  std::erase_if(files,
    [&error](const std::string& file)
    { return !IsSlice(file) || std::filesystem::is_directory(file, error); });
  if (files.empty())
  {
    throw Failure(
      folderOrPattern, fmt::format("{} no slices ({})", isFolder ? "has" : "fits", SliceFormats));
  }
  return SortByNumbers(files);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadSlices(const std::vector<std::string>& files, Progress& progress)
{
  Stack stack(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    CheckReadable(files[i]);
    ReadImageFile(files[i],
      [&](const Image& slice)
      {
        stack.Add(files[i], slice);
        progress(static_cast<double>(i) / static_cast<double>(files.size()));
        CheckInterrupt();
        return true;
      });
  }
  return stack.Finish();
}

//------------------------------------------------------------------------------
bool HasNumber(const std::string& name)
{
  if (name.find('%') == std::string::npos)
  {
    return false;
  }
  if (!std::regex_match(name, NumberedName))
  {
    throw UsageError(
      name + ": % must be that of one %d, or of one as %04d, for the number of the slice");
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::string> NameSlices(const std::string& name, int count)
{
  std::smatch parts;
  std::regex_match(name, parts, NumberedName);
  const int digits = parts[2].length() > 0 ? std::stoi(parts[2]) : 0;
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    names.push_back(fmt::format("{}{:0{}}{}", parts[1].str(), i, digits, parts[3].str()));
  }
  return names;
}

//------------------------------------------------------------------------------
void WriteSlices(vtkImageData* volume, const std::vector<std::string>& files, Progress& progress)
{
  const gatun::BridgedArray values =
    gatun::Bridge(volume->GetPointData()->GetScalars(), gatun::Association::Point);
  Image slice{ volume->GetDimensions()[0], volume->GetDimensions()[1], { "Y" },
    values.Description.Type };
  if (ExtensionOf(files.front()) == ".png" && slice.Type != gatun::ScalarType::UInt8 &&
    slice.Type != gatun::ScalarType::UInt16)
  {
    throw Failure(files.front(),
      fmt::format("values of type {} do not fit into .png files, which take uint8 and uint16; use "
                  ".tif files",
        NameOfType(slice.Type)));
  }
  const std::size_t row = gatun::SizeOf(slice.Type) * static_cast<std::size_t>(slice.Width);
  std::vector<unsigned char> turned(row * static_cast<std::size_t>(slice.Height));
  slice.Values = turned.data();
  const auto* from = static_cast<const unsigned char*>(values.Values);
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    for (auto y = static_cast<std::size_t>(slice.Height); y-- > 0; from += row)
    {
      std::memcpy(turned.data() + y * row, from, row);
    }
    WriteImageFile(slice, files[i]);
    progress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    CheckInterrupt();
  }
}
}
