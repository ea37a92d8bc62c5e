// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume render: renders a volume from its Hartley coefficients.

#include "gtnFailure.h"
#include "gtnImageOptions.h"
#include "gtnOptions.h"
#include "gtnParse.h"
#include "gtnProgress.h"
#include "gtnText.h"
#include "gtnTurntable.h"
#include "gtnVolume.h"
#include "gtnVolumeOptions.h"
#include "gtnVolumeSource.h"

#include "vtkHartleyProjection.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

namespace gtn
{
namespace
{

constexpr std::array<const char*, 3> Laws{ "xray", "exponential", "transfer" };
static_assert(vtkHartleyProjection::LAW_XRAY == 0 && vtkHartleyProjection::LAW_EXPONENTIAL == 1 &&
  vtkHartleyProjection::LAW_TRANSFER_FUNCTION == 2);
constexpr std::array<const char*, 3> Methods{ "automatic", "basis", "slice" };
constexpr std::array<const char*, 2> Kernels{ "kaiser-bessel", "trilinear" };

struct Options : ImageOptions
{
  VolumeInputOptions Input;
  CompressionOptions Compression;
  int Law = vtkHartleyProjection::LAW_TRANSFER_FUNCTION;
  std::optional<double> Extinction;
  std::optional<double> Zero;
  std::optional<gatun::Range> Window;
  double SampleDistance = 0;
  int Method = 0;
  int Kernel = 0;
  double Padding = 2;
  int Memory = 1024;
};

void Check(const Options& options)
{
  if ((options.Extinction || options.Zero) && options.Law != vtkHartleyProjection::LAW_EXPONENTIAL)
  {
    throw UsageError("--extinction and --zero are for --law exponential");
  }
  if (options.Window && options.Law != vtkHartleyProjection::LAW_XRAY)
  {
    throw UsageError("--window is for --law xray");
  }
}

void SetUp(vtkHartleyProjection* projection, const Options& options, const VolumeSource& source)
{
  source.Connect(projection);
  options.Compression.Apply(projection);
  projection->SetSize(options.Width, options.Height);
  projection->SetLaw(options.Law);
  projection->SetExtinction(options.Extinction.value_or(0));
  projection->SetUseZero(options.Zero.has_value());
  projection->SetZero(options.Zero.value_or(0));
  if (options.Window)
  {
    projection->SetWindow(options.Window->Min, options.Window->Max);
  }
  projection->SetSampleDistance(options.SampleDistance);
  projection->SetMethod(options.Method);
  projection->SetKernel(options.Kernel);
  projection->SetPadding(options.Padding);
  projection->SetMemoryBudget(options.Memory);
  projection->OutputFloatsOn();
  if (options.Law != vtkHartleyProjection::LAW_XRAY)
  {
    projection->SetProperty(MakeProperty(
      MakeTransfer(options, { source.GetFile(), source.GetArray(), source.GetRange() }),
      options.UnitDistance.value_or(DiagonalOf(source.GetBounds()) / 100)));
  }
}

void Render(const Options& options, const Settings& settings)
{
  Check(options);
  CheckImages(options);
  const VolumeSource source(options.Input, settings);
  vtkNew<vtkHartleyProjection> projection;
  SetUp(projection, options, source);
  const auto render = [&](vtkCamera* camera, Progress& progress)
  {
    projection->SetCamera(camera);
    progress.Watch(projection);
    projection->Update();
    return projection->GetOutput();
  };
  const auto getStatistics = [&]() -> Statistics
  {
    return { { "blocks", "blocks drawn", Statistic::Count,
               static_cast<double>(projection->GetNumberOfBlocksDrawn()) },
      { "terms", "coefficients added up", Statistic::Count,
        static_cast<double>(projection->GetNumberOfTerms()) } };
  };
  const RenderedImages rendered = RenderImages(options, settings,
    { { source.GetFile(), source.GetArray(), source.GetRange() }, source.GetBounds(), render,
      getStatistics });

  const char* const method = Methods.at(static_cast<std::size_t>(projection->GetMethodUsed()));
  Json::Value json;
  json["input"] = source.GetFile();
  json["size"] = JsonArray(source.GetSize());
  json["array"] = source.GetArray();
  json["law"] = Laws.at(static_cast<std::size_t>(options.Law));
  json["method"] = method;
  PrintImages(options, settings, rendered,
    fmt::format("'{}' of {} voxels, method {}", Printable(source.GetArray()),
      SizeOf(source.GetSize()), method),
    json);
}

// An option that takes one of some names; the number of the name is what it sets.
template <std::size_t Count>
void AddChoice(CLI::App* command, const char* option, const std::array<const char*, Count>& names,
  int& number, const std::string& description, const char* group)
{
  command
    ->add_option_function<std::string>(
      option,
      [&names, &number](const std::string& name)
      {
        const auto found = std::find(names.begin(), names.end(), name);
        number = static_cast<int>(found - names.begin());
      },
      description)
    ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())))
    ->option_text("NAME")
    ->group(group);
}

void AddLawOptions(CLI::App* command, Options& options)
{
  const char* const group = "Colors and opacities";
  AddChoice(command, "--law", Laws, options.Law,
    "transfer (the default): opacity by the transfer function; exponential: by the extinction, "
    "exact for each block; xray: gray, the sum along the ray",
    group);
  command
    ->add_option("--extinction", options.Extinction,
      "For exponential: a length l of ray through the value v has the opacity 1 - exp(-K (v - V0) "
      "l) "
      "(default: 1 in a tenth of the diagonal, for the largest value)")
    ->check(Positive())
    ->option_text("K")
    ->group(group);
  command
    ->add_option("--zero", options.Zero,
      "For exponential: V0, the value up to which there is nothing (default: the smallest one)")
    ->option_text("V0")
    ->group(group);
  command
    ->add_option_function<std::string>(
      "--window",
      [&options](const std::string& text) { options.Window = ParseRange("--window", text); },
      "For xray: the sums that are black and white (default: those of the picture)")
    ->option_text("LO,HI")
    ->group(group);
}

void AddMethodOptions(CLI::App* command, Options& options)
{
  const char* const group = "How it is drawn";
  command
    ->add_option("--sample-distance", options.SampleDistance,
      "The length of ray of which each value in a sum stands, above 0, in units of the coordinates "
      "(default: the edge of a voxel)")
    ->check(Positive())
    ->option_text("D")
    ->group(group);
  AddChoice(command, "--method", Methods, options.Method,
    "Pictures of blocks are sums of those of basis functions (basis), or slices through their "
    "spectra (slice); automatic: basis for blocks of up to 16 voxels",
    group);
  AddChoice(command, "--kernel", Kernels, options.Kernel,
    "For slice: kaiser-bessel (the default), nearly exact, or trilinear, for comparison", group);
  command
    ->add_option("--padding", options.Padding,
      "For slice: size of a block with the zeros around it, in blocks, 1 to 8")
    ->check(Between(1, 8))
    ->option_text("F [2]")
    ->group(group);
  command
    ->add_option("--memory", options.Memory,
      "For slice: MiB of spectra to keep for the next picture, 0 to 1048576")
    ->check(CLI::Range(0, 1 << 20))
    ->option_text("MIB [1024]")
    ->group(group);
  command
    ->add_flag("--stats", options.Statistics, "Print what it took; of a turntable, the last one")
    ->group(group);
  command->add_flag("--json", options.Json, "Print the same of each picture, as JSON")
    ->group(group);
}

void AddRotation(CLI::App* command, CameraOptions& camera)
{
  CLI::Option* const rotate = command
                                ->add_option_function<std::string>(
                                  "--rotate",
                                  [&camera](const std::string& text)
                                  {
                                    camera.Turns = ParseList<3>(text);
                                    if (!camera.Turns)
                                    {
                                      Refuse("--rotate", text, "three numbers, as 0.25,0.25,0.25");
                                    }
                                  },
                                  "Instead of all that: rotations of the volume about x, then y, "
                                  "then z, in units of pi; it is "
                                  "then looked at along z, with x to the right and y down")
                                ->option_text("X,Y,Z")
                                ->group("View");
  for (const char* const other : { "--azimuth", "--elevation", "--camera" })
  {
    rotate->excludes(command->get_option(other));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeRender(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<Options>();
  options->TransferFunction = "bone";
  options->Camera.Parallel = true;
  CLI::App* command = AddCommand(app, settings, "render",
    "Draw a volume into a .png or .exr file, from its Hartley coefficients: a .ghv file as it is,\n"
    "chunk by chunk; others are compressed first, in memory. The projection is always parallel.",
    "  gtn volume render head.ghv head.png\n"
    "  gtn volume render --tf bone --range 0,1500 --elevation 10 --background black head.ghv "
    "a.png\n"
    "  gtn volume render --law xray --rotate 0.25,0.25,0.25 --size 512x512 head.ghv xray.png\n"
    "  gtn volume render --law exponential --extinction 0.001 head.nii.gz head.exr\n"
    "  gtn volume render --turntable 36 head.ghv around.png");
  AddForce(command, options->Overwrite);
  AddImageOptions(command, *options);
  AddViewOptions(command, options->Camera, "volume");
  AddRotation(command, options->Camera);
  AddColorOptions(command, *options, "volume");
  AddLawOptions(command, *options);
  AddMethodOptions(command, *options);
  AddVolumeInput(command, options->Input);
  AddCompression(command, options->Compression, "Compression, of what is no .ghv file");
  command
    ->add_option_function<std::string>(
      "IN", [options](const std::string& file) { options->Input.Files = { file }; },
      std::string("A volume: ") + VolumeFormats)
    ->required();
  command->add_option("OUT", options->Out, "The .png or .exr file")->required();
  command->callback([options, &settings] { Render(*options, settings); });
}
}
