// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// volume-draw: a picture of a volume as a .png file, by Gatun or voxel by voxel.

#include "benchCases.h"
#include "benchVolume.h"

#include "gatunHartleyFile.h"
#include "gatunParallel.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace bench
{
namespace
{
using gatun::HartleyOpacityModel;

struct VolumeDrawOptions
{
  std::string File;
  std::string Picture;
  std::string Scratch;
  std::uint32_t Block = 8;
  double Rate = 0;
  std::string Law = "xray";
  double Opacity = 0.05;
  std::vector<double> Nodes; ///< density, red, green, blue, opacity, by ascending density
  std::vector<double> Turns{ 0.5, 0, 0.1 };
  double White = 0; ///< X-ray sum
  double Scale = 1;
  bool Voxels = false;
};

/** The nodes, evenly spaced as HartleyShading wants them. */
void SetTable(gatun::HartleyShading& shading, const std::vector<double>& nodes)
{
  const std::size_t count = nodes.size() / 5;
  const std::size_t entries = 1024;
  shading.First = nodes[0];
  shading.Last = nodes[5 * (count - 1)];
  shading.Table.assign(entries, {});
  std::size_t next = 1;
  for (std::size_t i = 0; i < entries; ++i)
  {
    const double density =
      shading.First + (shading.Last - shading.First) * static_cast<double>(i) / (entries - 1);
    while (next + 1 < count && nodes[5 * next] < density)
    {
      ++next;
    }
    const double* const low = &nodes[5 * (next - 1)];
    const double part = std::clamp((density - low[0]) / (low[5] - low[0]), 0.0, 1.0);
    for (std::size_t c = 0; c < 4; ++c)
    {
      shading.Table[i][c] = static_cast<float>((1 - part) * low[1 + c] + part * low[6 + c]);
    }
  }
}

gatun::HartleyImage Cast(
  const Volume& volume, const gatun::HartleyView& view, const gatun::HartleyShading& shading)
{
  const gatun::test::ReferenceVolume reference = volume.GetReference();
  gatun::HartleyImage picture;
  picture.Width = view.Width;
  picture.Height = view.Height;
  picture.Colors.resize(std::size_t{ view.Width } * view.Height);
  picture.Sums.resize(picture.Colors.size());
  gatun::ParallelFor(view.Height,
    [&](std::size_t row)
    {
      for (unsigned column = 0; column < view.Width; ++column)
      {
        const auto point = gatun::test::GetPixel(view, column, static_cast<double>(row));
        const std::size_t i = row * view.Width + column;
        picture.Sums[i] = static_cast<float>(reference.SumSamples(point, view.Step) +
          volume.GetLowest() * reference.IntegrateWeight(point, view.Step));
        if (shading.OpacityModel != HartleyOpacityModel::XRay)
        {
          const auto color = reference.Cast(point, view.Step, shading);
          std::copy(color.begin(), color.end(), picture.Colors[i].begin());
        }
      }
    });
  return picture;
}

void WritePicture(const gatun::HartleyImage& picture, HartleyOpacityModel law, double white,
  const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(picture.Width), static_cast<int>(picture.Height), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < picture.Colors.size(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double value =
        law == HartleyOpacityModel::XRay ? picture.Sums[i] / white : picture.Colors[i][c];
      *out++ = static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}

void DrawPicture(const VolumeDrawOptions& options)
{
  if (options.Nodes.size() % 5 != 0 || options.Nodes.size() == 5 || options.Turns.size() != 3)
  {
    throw Failure("--nodes takes fives, two at least, and --turns three numbers");
  }
  const Volume volume(options.File);
  gatun::HartleyShading shading = MakeGray(volume, GetOpacityModel(options.Law), options.Opacity);
  if (!options.Nodes.empty())
  {
    SetTable(shading, options.Nodes);
  }
  const gatun::HartleyView view =
    volume.MakeView({ options.Turns[0], options.Turns[1], options.Turns[2] },
      volume.GetPixels(options.Scale), options.Scale);
  gatun::HartleyImage picture;
  std::uint64_t bytes = 0;
  double error = 0;
  if (options.Voxels)
  {
    picture = Cast(volume, view, shading);
  }
  else
  {
    gatun::HartleyWriterOptions writing;
    writing.BlockSize = options.Block;
    writing.RateControl = MakeQuality(options.Rate);
    const auto written = gatun::WriteHartleyFile(options.Scratch, volume.GetInput(), writing);
    bytes = written.FileBytes;
    error = written.RMSError;
    gatun::HartleyProjector projector(std::make_shared<const gatun::HartleyFile>(options.Scratch));
    picture = projector.Draw(view, shading);
  }
  // Sums are there for X-rays only.
  const double largest = shading.OpacityModel == HartleyOpacityModel::XRay
    ? *std::max_element(picture.Sums.begin(), picture.Sums.end())
    : 0;
  WritePicture(
    picture, shading.OpacityModel, options.White > 0 ? options.White : largest, options.Picture);
  PrintJson(
    [&](Json::Value& json)
    {
      json["pixels"] = static_cast<std::uint64_t>(view.Width);
      json["bits"] =
        8 * static_cast<double>(bytes) / static_cast<double>(volume.GetNumberOfVoxels());
      json["psnr"] = GetPSNR(volume.GetRange(), error * error);
      json["white"] = largest;
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeDraw(CLI::App& app)
{
  auto options = std::make_shared<VolumeDrawOptions>();
  CLI::App* const command =
    app.add_subcommand("volume-draw", "A picture of a volume, as a .png file");
  command->add_option("VOLUME", options->File, "A .vti or NIfTI file; head:SIZE, smooth:SIZE")
    ->required();
  command->add_option("PICTURE", options->Picture, "The .png file")->required();
  command->add_option("SCRATCH", options->Scratch, "A .ghv file that may be written")->required();
  command->add_option("--block", options->Block, "Voxels of a block; 0: all in one");
  command->add_option("--rate", options->Rate, "Bits a voxel; 0: lossless");
  command->add_option("--law", options->Law, "How densities become colors")
    ->check(CLI::IsMember(GetLawNames()));
  command->add_option("--opacity", options->Opacity, "Of a sample of the highest density");
  command->add_option("--nodes", options->Nodes,
    "Density, red, green, blue and opacity, by ascending density; not gray, then");
  command->add_option("--turns", options->Turns, "Rotations about x, y and z, in units of pi");
  command->add_option("--white", options->White, "The X-ray sum that is white; 0: the largest");
  command->add_option("--scale", options->Scale, "Pixels a voxel")->check(CLI::Range(0.1, 16.0));
  command->add_flag("--voxels", options->Voxels, "Voxel by voxel, not from coefficients");
  command->callback([options] { DrawPicture(*options); });
}
}
