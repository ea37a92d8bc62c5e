// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnVolumeInput.h"

#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnParse.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnSettings.h"
#include "gtnSlices.h"
#include "gtnText.h"

#include "gatunVolumeDescription.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

namespace gtn
{
const char* const VolumeFormats = ".vti .vtk .nii .nii.gz .mha .mhd .nrrd .nhdr .slc .vtkhdf .ghv, "
                                  "or slices: .tif, .png (several, a "
                                  "folder of them, or 'name*.png')";

namespace
{

std::array<double, 3> ParseSpacing(const std::string& text)
{
  const auto spacing = ParseList<3>(text);
  if (!spacing ||
    !std::all_of(spacing->begin(), spacing->end(), [](double number) { return number > 0; }))
  {
    Refuse("--spacing", text, "three numbers above 0, as 0.5,0.5,2");
  }
  return *spacing;
}

bool AreSlices(const std::vector<std::string>& files)
{
  std::error_code error;
  return files.size() > 1 || IsSlice(files.front()) ||
    std::filesystem::is_directory(files.front(), error);
}

vtkSmartPointer<vtkImageData> ReadFile(
  const std::string& file, const Settings& settings, Progress& progress)
{
  CheckReadable(file);
  const vtkSmartPointer<vtkAlgorithm> reader = MakeVolumeReader(file);
  if (!reader)
  {
    throw Failure(
      file, std::string("no reader for this extension; there are those for ") + VolumeFormats);
  }
  progress.Watch(reader);
  reader->Update();
  CheckInterrupt();
  CheckMessages(file, settings.Quiet);
  vtkSmartPointer<vtkImageData> volume = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (!volume)
  {
    throw Failure(file, "does not hold a regular volume");
  }
  return volume;
}

void ChooseArray(vtkImageData* volume, const VolumeInputOptions& options)
{
  const std::string& file = options.Files.front();
  vtkPointData* const data = volume->GetPointData();
  if (volume->GetNumberOfPoints() == 0)
  {
    throw Failure(file, "holds an empty volume");
  }
  std::vector<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    names.push_back(MakePrintableLine(data->GetArrayName(i) ? data->GetArrayName(i) : ""));
  }
  vtkSmartPointer<vtkDataArray> array =
    options.Array.empty() ? data->GetScalars() : data->GetArray(options.Array.c_str());
  for (int i = 0; options.Array.empty() && !array && i < data->GetNumberOfArrays(); ++i)
  {
    array = data->GetArray(i);
  }
  const std::string there = names.empty() ? "none" : Join(names);
  if (!array)
  {
    throw Failure(file,
      options.Array.empty()
        ? fmt::format("has no array of numbers on the points; there are {}", there)
        : fmt::format("has no array '{}' on the points; there are {}",
            MakePrintableLine(options.Array), there));
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw Failure(file,
      fmt::format("the point array '{}' has {} components, and a volume has one; save one of them, "
                  "such as by Calculator of ParaView",
        MakePrintableLine(array->GetName() ? array->GetName() : ""),
        array->GetNumberOfComponents()));
  }
  data->Initialize();
  data->SetScalars(array);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeInput(CLI::App* command, VolumeInputOptions& options)
{
  command
    ->add_option(
      "--array", options.Array, "Point array (default: the active scalars, or else the first one)")
    ->option_text("NAME");
  command
    ->add_option_function<std::string>(
      "--spacing", [&options](const std::string& text) { options.Spacing = ParseSpacing(text); },
      "From one voxel to the next along x, y and z (default: what the file tells; 1,1,1 for "
      "slices)")
    ->option_text("X,Y,Z");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadVolume(
  const VolumeInputOptions& options, const Settings& settings)
{
  Progress progress("reading", settings.ShowProgress);
  std::vector<std::string> files = options.Files;
  if (files.size() == 1)
  {
    files = FindSlices(files.front());
  }
  else
  {
    files = SortByNumbers(files);
    for (const std::string& file : files)
    {
      if (!IsSlice(file))
      {
        throw Failure(file, std::string("of several files, each must be a slice: ") + SliceFormats);
      }
    }
  }
  vtkSmartPointer<vtkImageData> volume =
    AreSlices(files) ? ReadSlices(files, progress) : ReadFile(files.front(), settings, progress);
  ChooseArray(volume, options);
  if (options.Spacing)
  {
    volume->SetSpacing(options.Spacing->data());
  }
  return volume;
}

//------------------------------------------------------------------------------
std::string SizeOf(const std::array<std::uint32_t, 3>& size)
{
  return gatun::DescribeVoxels(size);
}
}
