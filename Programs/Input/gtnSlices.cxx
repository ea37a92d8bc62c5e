// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSlices.h"

#include "gtnFailure.h"
#include "gtnImageFile.h"
#include "gtnImageLibrary.h"
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

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace gtn
{
const char* const SliceFormats = ".tif .tiff .png";

namespace
{

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

// The digits at the beginning, without leading zeros; the text then begins behind them.
std::string_view TakeNumber(std::string_view& text)
{
  std::size_t end = 0;
  while (end < text.size() && IsDigit(text[end]))
  {
    ++end;
  }
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  while (digits.size() > 1 && digits.front() == '0')
  {
    digits.remove_prefix(1);
  }
  return digits;
}

// Whether a name is as a pattern with * and ? has it.
bool Fits(std::string_view name, std::string_view pattern)
{
  std::size_t i = 0;
  std::size_t j = 0;
  std::size_t star = pattern.npos; // the last one, and what it stands for so far
  std::size_t from = 0;
  while (i < name.size())
  {
    if (j < pattern.size() && pattern[j] == '*')
    {
      star = j++;
      from = i;
    }
    else if (j < pattern.size() && (pattern[j] == '?' || pattern[j] == name[i]))
    {
      ++i;
      ++j;
    }
    else if (star != pattern.npos)
    {
      j = star + 1;
      i = ++from;
    }
    else
    {
      return false;
    }
  }
  return pattern.substr(j).find_first_not_of('*') == pattern.npos;
}

// Collects slices, of whatever file, into one volume.
class Stack
{
public:
  explicit Stack(std::size_t files)
    : Files(files)
  {
  }

  void Add(const std::string& file, const Slice& slice)
  {
    if (slice.Channels != 1)
    {
      throw Failure(file,
        fmt::format("is a picture of {} channels, and slices have one; make it grey beforehand",
          slice.Channels));
    }
    if (this->First.empty())
    {
      this->First = file;
      this->Shape = slice;
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
        fmt::format("has values of type {}, unlike {} with {}", NameOf(slice.Type), this->First,
          NameOf(this->Shape.Type)));
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
  Slice Shape;
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
bool IsBefore(const std::string& one, const std::string& other)
{
  std::string_view a = one;
  std::string_view b = other;
  while (!a.empty() && !b.empty())
  {
    if (IsDigit(a.front()) && IsDigit(b.front()))
    {
      const std::string_view x = TakeNumber(a);
      const std::string_view y = TakeNumber(b);
      if (x != y)
      {
        return x.size() != y.size() ? x.size() < y.size() : x < y;
      }
      continue;
    }
    if (a.front() != b.front())
    {
      return a.front() < b.front();
    }
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  // Those that differ in leading zeros only have an order, too.
  return a.empty() && b.empty() ? one < other : a.empty();
}

//------------------------------------------------------------------------------
std::vector<std::string> FindSlices(const std::string& folderOrPattern)
{
  const std::filesystem::path path(folderOrPattern);
  std::error_code error;
  const bool isFolder = std::filesystem::is_directory(path, error);
  const std::string pattern = isFolder ? "*" : path.filename().string();
  if (!isFolder &&
    (pattern.find_first_of("*?") == pattern.npos || std::filesystem::exists(path, error)))
  {
    return { folderOrPattern };
  }
  const std::filesystem::path folder = isFolder ? path : path.parent_path();
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(
         folder.empty() ? std::filesystem::path(".") : folder, error))
  {
    const std::string name = entry.path().filename().string();
    if (IsSlice(name) && Fits(name, pattern) && !entry.is_directory(error))
    {
      files.push_back((folder / name).string());
    }
  }
  if (error)
  {
    throw Failure(folderOrPattern, error.message());
  }
  if (files.empty())
  {
    throw Failure(
      folderOrPattern, fmt::format("{} no slices ({})", isFolder ? "has" : "fits", SliceFormats));
  }
  std::sort(files.begin(), files.end(), IsBefore);
  return files;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadSlices(const std::vector<std::string>& files, Progress& progress)
{
  static auto* const read = FindImageFunction<ReadSlicesFunction>(ReadSlicesName);
  Stack stack(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const std::string& file = files[i];
    CheckReadable(file);
    std::string reason;
    const auto take = [&](const Slice& slice)
    {
      stack.Add(file, slice);
      progress(static_cast<double>(i) / static_cast<double>(files.size()));
      CheckInterrupt();
      return true;
    };
    if (!read(file, take, reason))
    {
      FailForImage(file, file, reason, "cannot be read");
    }
  }
  return stack.Finish();
}

//------------------------------------------------------------------------------
bool HasNumber(const std::string& name)
{
  const std::size_t place = name.find('%');
  if (place == name.npos)
  {
    return false;
  }
  std::size_t end = place + 1;
  while (end < name.size() && end < place + 3 && IsDigit(name[end]))
  {
    ++end;
  }
  if (end >= name.size() || name[end] != 'd' || name.find('%', end) != name.npos)
  {
    throw UsageError(
      name + ": % must be that of one %d, or of one as %04d, for the slice's number");
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::string> NameSlices(const std::string& name, int count)
{
  const std::size_t place = name.find('%');
  const std::size_t end = name.find('d', place);
  std::size_t digits = 0;
  for (std::size_t i = place + 1; i < end; ++i)
  {
    digits = 10 * digits + static_cast<std::size_t>(name[i] - '0');
  }
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    names.push_back(
      fmt::format("{}{:0{}}{}", name.substr(0, place), i, digits, name.substr(end + 1)));
  }
  return names;
}

//------------------------------------------------------------------------------
void WriteSlices(vtkImageData* volume, const std::vector<std::string>& files, Progress& progress)
{
  static auto* const write = FindImageFunction<WriteSliceFunction>(WriteSliceName);
  const gatun::BridgedArray values =
    gatun::Bridge(volume->GetPointData()->GetScalars(), gatun::Association::Point);
  Slice slice;
  slice.Width = volume->GetDimensions()[0];
  slice.Height = volume->GetDimensions()[1];
  slice.Type = values.Description.Type;
  const bool isPng = ExtensionOf(files.front()) == ".png";
  if (isPng && slice.Type != gatun::ScalarType::UInt8 && slice.Type != gatun::ScalarType::UInt16)
  {
    throw Failure(files.front(),
      fmt::format(".png files hold values of type uint8 or uint16, and these are {}; .tif files "
                  "hold them",
        NameOf(slice.Type)));
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
    TemporaryFile temporary(files[i]);
    std::string reason;
    if (!write(slice, temporary.GetName(), reason))
    {
      FailForImage(files[i], temporary.GetName(), reason, "cannot be written");
    }
    temporary.Commit();
    progress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    CheckInterrupt();
  }
}
}
