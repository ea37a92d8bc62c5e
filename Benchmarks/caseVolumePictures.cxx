// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// volume-pictures: whole pictures next to those of a voxel-by-voxel ray caster, Table 2 of the
// dissertation.

#include "benchCases.h"
#include "benchVolume.h"

#include "gatunParallel.h"

#include <algorithm>
#include <memory>

namespace bench
{
namespace
{
using gatun::HartleyOpacityModel;
using gatun::HartleyView;
using gatun::test::ReferenceVolume;

struct VolumePicturesOptions
{
  std::string File;
  std::vector<std::uint32_t> Blocks{ 2, 4, 8, 16, 32, 64 };
  std::vector<double> Rates{ 0 };
  double Opacity = 0.1;
  double Scale = 1;
};

/** Of each pixel: whether its ray meets the volume, the sum of the samples, the line integral, and
 * what is seen under the two laws. */
struct ReferencePicture
{
  struct Pixel
  {
    bool Met = false;
    double Samples = 0;
    double Line = 0;
    std::array<double, 4> Exponential{};
    std::array<double, 4> Linear{};
  };
  std::vector<Pixel> Pixels;
  std::size_t Met = 0;
  double Largest = 0;
};

ReferencePicture Cast(const ReferenceVolume& volume, const HartleyView& view,
  const gatun::HartleyShading& exponential, const gatun::HartleyShading& linear)
{
  ReferencePicture picture;
  picture.Pixels.resize(std::size_t{ view.Width } * view.Height);
  gatun::ParallelFor(view.Height,
    [&](std::size_t row)
    {
      for (unsigned column = 0; column < view.Width; ++column)
      {
        auto& pixel = picture.Pixels[row * view.Width + column];
        const auto point = gatun::test::GetPixel(view, column, static_cast<double>(row));
        const auto part = volume.Clip(point, view.Step);
        if (part.Begin < part.End)
        {
          pixel.Met = true;
          pixel.Samples = volume.SumSamples(point, view.Step);
          pixel.Line = volume.Integrate(point, view.Step);
          pixel.Exponential = volume.Cast(point, view.Step, exponential);
          pixel.Linear = volume.Cast(point, view.Step, linear);
        }
      }
    });
  for (const auto& pixel : picture.Pixels)
  {
    picture.Met += pixel.Met ? 1 : 0;
    picture.Largest = std::max(picture.Largest, pixel.Samples);
  }
  return picture;
}

/** Mean square and largest differences, of values from 0 to 255. */
class PixelDifference
{
public:
  void Add(double one, double other)
  {
    this->Squares += (one - other) * (one - other);
    this->Worst = std::max(this->Worst, std::abs(one - other));
    ++this->Count;
  }

  void Write(Json::Value& json, const char* name) const
  {
    json[name]["mse"] = this->Squares / static_cast<double>(this->Count);
    json[name]["worst"] = this->Worst;
  }

private:
  double Squares = 0;
  double Worst = 0;
  std::size_t Count = 0;
};

struct Shadings
{
  gatun::HartleyShading XRay;
  gatun::HartleyShading Exponential;
  gatun::HartleyShading Linear;
};

void Compare(Json::Value& json, const ReferencePicture& reference, const HartleyView& view,
  gatun::HartleyProjector& projector, const Shadings& shadings, double base)
{
  const gatun::HartleyImage xray = projector.Draw(view, shadings.XRay);
  const gatun::HartleyImage exponential = projector.Draw(view, shadings.Exponential);
  const gatun::HartleyImage linear = projector.Draw(view, shadings.Linear);
  PixelDifference samples, lines, gray, opacity, law, other;
  const double scale = 255 / reference.Largest;
  for (std::size_t i = 0; i < reference.Pixels.size(); ++i)
  {
    const auto& pixel = reference.Pixels[i];
    if (!pixel.Met)
    {
      continue;
    }
    const double sum = xray.Sums[i] - base * xray.Samples[i];
    samples.Add(scale * sum, scale * pixel.Samples);
    lines.Add(scale * sum, scale * pixel.Line);
    gray.Add(255.0 * exponential.Colors[i][0], 255 * pixel.Exponential[0]);
    opacity.Add(255.0 * exponential.Colors[i][3], 255 * pixel.Exponential[3]);
    // What equation 6 says of the line integral, without any blocks.
    law.Add(255.0 * exponential.Colors[i][3],
      255 * (1 - std::exp(-shadings.Exponential.Extinction * pixel.Line)));
    other.Add(255.0 * linear.Colors[i][0], 255 * pixel.Linear[0]);
  }
  samples.Write(json, "xraySamples");
  lines.Write(json, "xrayLines");
  gray.Write(json, "exponential");
  opacity.Write(json, "opacity");
  law.Write(json, "equation6");
  other.Write(json, "linear");
}

void PrintPictures(const VolumePicturesOptions& options)
{
  const Volume volume(options.File);
  const ReferenceVolume reference = volume.GetReference();
  const Shadings shadings{ {}, MakeGray(volume, HartleyOpacityModel::Exponential, options.Opacity),
    MakeGray(volume, HartleyOpacityModel::TransferFunction, options.Opacity) };
  const double length = std::sqrt(gatun::test::InnerProduct(
    { volume.GetSize()[0] + 1.0, volume.GetSize()[1] + 1.0, volume.GetSize()[2] + 1.0 },
    { volume.GetSize()[0] + 1.0, volume.GetSize()[1] + 1.0, volume.GetSize()[2] + 1.0 }));
  const auto pixels = static_cast<unsigned>(std::ceil(options.Scale * length));
  std::vector<HartleyView> views;
  std::vector<ReferencePicture> references;
  for (const Turns& turns : GetPaperTurns())
  {
    views.push_back(gatun::test::MakeTurnedView(volume.GetSize(), turns, pixels, options.Scale));
    references.push_back(Cast(reference, views.back(), shadings.Exponential, shadings.Linear));
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["pixels"] = static_cast<std::uint64_t>(pixels);
      json["opacity"] = options.Opacity;
      json["blocks"] = Json::arrayValue;
      for (const std::uint32_t block : options.Blocks)
      {
        for (const double rate : options.Rates)
        {
          const auto source = MakeSource(volume, block, rate);
          gatun::HartleyProjector projector(source);
          Json::Value blockJson;
          blockJson["block"] = static_cast<std::uint64_t>(block);
          blockJson["rate"] = rate;
          blockJson["views"] = Json::arrayValue;
          for (std::size_t i = 0; i < views.size(); ++i)
          {
            Json::Value viewJson;
            viewJson["met"] = static_cast<std::uint64_t>(references[i].Met);
            Compare(viewJson, references[i], views[i], projector, shadings, source->GetBase());
            blockJson["views"].append(viewJson);
          }
          json["blocks"].append(blockJson);
        }
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumePictures(CLI::App& app)
{
  auto options = std::make_shared<VolumePicturesOptions>();
  CLI::App* const command = app.add_subcommand(
    "volume-pictures", "Mean square errors of whole pictures against voxel-by-voxel ray casting");
  command->add_option("VOLUME", options->File, "A .vti or NIfTI file; head:SIZE, smooth:SIZE")
    ->required();
  command->add_option("--blocks", options->Blocks, "Voxels of a block; 0: all in one");
  command->add_option("--rates", options->Rates, "Bits a voxel; 0: not quantized");
  command->add_option("--opacity", options->Opacity, "Of a sample of the highest density")
    ->check(CLI::Range(0.0001, 0.9999));
  command->add_option("--scale", options->Scale, "Pixels a voxel")->check(CLI::Range(0.1, 16.0));
  command->callback([options] { PrintPictures(*options); });
}
}
