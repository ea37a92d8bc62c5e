// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume render: renders a volume from its Hartley coefficients.

#include "gtnFailure.h"
#include "gtnImageOptions.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnParse.h"
#include "gtnProgress.h"
#include "gtnRenderImage.h"
#include "gtnText.h"
#include "gtnVolume.h"
#include "gtnVolumeOptions.h"
#include "gtnVolumeSource.h"

#include "vtkGatunDefaults.h"
#include "vtkGatunHartleyEncoder.h"
#include "vtkGatunHartleyProjection.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVolumeProperty.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

namespace gtn
{
namespace
{

constexpr std::array<const char*, 3> OpacityModels{ "xray", "exponential", "transfer" };
static_assert(vtkGatunHartleyProjection::OPACITY_MODEL_XRAY == 0 &&
  vtkGatunHartleyProjection::OPACITY_MODEL_EXPONENTIAL == 1 &&
  vtkGatunHartleyProjection::OPACITY_MODEL_TRANSFER_FUNCTION == 2);
constexpr std::array<const char*, 4> Methods{ "automatic", "basis", "slice", "voxels" };

struct VolumeRenderOptions : ImageOptions
{
  VolumeInputOptions Input;
  CompressionOptions Compression;
  int OpacityModel = vtkGatunHartleyProjection::OPACITY_MODEL_TRANSFER_FUNCTION;
  std::optional<double> Extinction;
  std::optional<double> Zero;
  std::optional<gatun::Range> Window;
  double SampleDistance = 0;
  int Method = 0;
  int Memory = 512;
};

void Check(const VolumeRenderOptions& options)
{
  if ((options.Extinction || options.Zero) &&
    options.OpacityModel != vtkGatunHartleyProjection::OPACITY_MODEL_EXPONENTIAL)
  {
    throw UsageError("--extinction and --zero require --opacity-model exponential");
  }
  if (options.Window && options.OpacityModel != vtkGatunHartleyProjection::OPACITY_MODEL_XRAY)
  {
    throw UsageError("--window requires --opacity-model xray");
  }
}

void SetUp(vtkGatunHartleyProjection* projection, const VolumeRenderOptions& options,
  const VolumeSource& source, vtkGatunDefaults* defaults)
{
  projection->SetSize(options.Width, options.Height);
  projection->SetOpacityModel(options.OpacityModel);
  projection->SetExtinction(options.Extinction.value_or(0));
  if (options.Zero)
  {
    projection->SetZero(*options.Zero);
  }
  if (options.Window)
  {
    projection->SetWindow(options.Window->Min, options.Window->Max);
  }
  projection->SetSampleDistance(options.SampleDistance);
  projection->SetMethod(options.Method);
  projection->SetMemoryBudget(options.Memory);
  projection->OutputFloatsOn();
  if (options.OpacityModel != vtkGatunHartleyProjection::OPACITY_MODEL_XRAY)
  {
    projection->SetProperty(
      MakeImageProperty(options, { source.GetFile(), source.GetArray(), source.GetRange() },
        defaults, source.GetBounds(), OpacityKind::Structure));
  }
}

// Connects a .ghv file as it is; encodes other volumes first.
void Connect(vtkGatunHartleyProjection* projection, vtkGatunHartleyEncoder* encoder,
  const VolumeRenderOptions& options, const Settings& settings, const VolumeSource& source)
{
  if (source.IsFile())
  {
    source.Connect(projection);
    return;
  }
  source.Connect(encoder);
  options.Compression.Apply(encoder->GetEncoding());
  projection->SetInputConnection(encoder->GetOutputPort());
  Progress progress("compressing", settings.ShowProgress);
  progress.Watch(encoder);
  encoder->Update();
  CheckInterrupt();
  CheckMessages(source.GetFile(), settings.Quiet);
}

void Render(const VolumeRenderOptions& options, const Settings& settings)
{
  Check(options);
  CheckImage(options);
  const VolumeSource source(options.Input, settings);
  vtkNew<vtkGatunHartleyProjection> projection;
  vtkNew<vtkGatunDefaults> defaults;
  source.Connect(defaults);
  SetUp(projection, options, source, defaults);
  vtkNew<vtkGatunHartleyEncoder> encoder;
  Connect(projection, encoder, options, settings, source);
  const auto render = [&](vtkCamera* camera, Progress& progress)
  {
    projection->SetCamera(camera);
    progress.Watch(projection);
    projection->Update();
    return projection->GetOutput();
  };
  const auto getStatistics = [&]() -> Statistics
  {
    vtkTable* const table = projection->GetStatistics();
    const auto get = [table](const char* name)
    { return table->GetValueByName(0, name).ToDouble(); };
    return { { "blocks", "blocks drawn", Statistic::Count, get("DrawnBlocks") },
      { "terms", "coefficients summed", Statistic::Count, get("Coefficients") } };
  };
  const RenderedImage rendered = RenderImage(options, settings,
    { { source.GetFile(), source.GetArray(), source.GetRange() }, source.GetBounds(), defaults,
      render, getStatistics });

  const int used = projection->GetStatistics()->GetValueByName(0, "Method").ToInt();
  const char* const method = Methods.at(static_cast<std::size_t>(used));
  Json::Value json;
  json["input"] = source.GetFile();
  json["size"] = MakeJsonArray(source.GetSize());
  json["array"] = source.GetArray();
  json["opacityModel"] = OpacityModels.at(static_cast<std::size_t>(options.OpacityModel));
  json["method"] = method;
  PrintImage(options, settings, rendered,
    fmt::format("'{}' of {} voxels, method {}", MakePrintableLine(source.GetArray()),
      SizeOf(source.GetSize()), method),
    json);
}

// An option whose value is one of several names; sets the number of the name.
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

void AddOpacityModelOptions(CLI::App* command, VolumeRenderOptions& options)
{
  const char* const group = "Colors and opacities";
  AddChoice(command, "--opacity-model", OpacityModels, options.OpacityModel,
    "transfer (the default): opacity by the transfer function; exponential: opacity by the "
    "extinction, independent of the block size; xray: gray, by the sum along the ray",
    group);
  command
    ->add_option("--extinction", options.Extinction,
      "For exponential: a ray of length l through the value v has the opacity 1 - exp(-K (v - V0) "
      "l) "
      "(default: an optical depth of 1 in a tenth of the diagonal, for the largest value)")
    ->check(Positive())
    ->option_text("K")
    ->group(group);
  command
    ->add_option("--zero", options.Zero,
      "For exponential: V0, the value that is transparent (default: the smallest one)")
    ->option_text("V0")
    ->group(group);
  command
    ->add_option_function<std::string>(
      "--window",
      [&options](const std::string& text) { options.Window = ParseRange("--window", text); },
      "For xray: the sums that are drawn black and white (default: those of the image)")
    ->option_text("LO,HI")
    ->group(group);
}

void AddMethodOptions(CLI::App* command, VolumeRenderOptions& options)
{
  const char* const group = "Method";
  command
    ->add_option("--sample-distance", options.SampleDistance,
      "The length of a ray that a sample stands for, above 0, in units of the coordinates "
      "(default: the edge of a voxel)")
    ->check(Positive())
    ->option_text("D")
    ->group(group);
  AddChoice(command, "--method", Methods, options.Method,
    "How blocks are projected: as sums of the images of basis functions (basis), by slices "
    "through their spectra (slice) or as sums of the voxels next to each ray (voxels); automatic: "
    "X-rays by the spectrum of the whole volume, otherwise voxels for blocks of up to 64 voxels",
    group);
  command->add_option("--memory", options.Memory, "MiB for coefficients and spectra, 0 to 1048576")
    ->check(CLI::Range(0, 1 << 20))
    ->option_text("MIB [512]")
    ->group(group);
  command->add_flag("--stats", options.Statistics, "Print statistics")->group(group);
  command->add_flag("--json", options.Json, "Print statistics as JSON")->group(group);
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
                                  "Instead of the above: rotations of the volume about x, then "
                                  "y, then z, in units of pi; the view is along z, with x to "
                                  "the right and y down")
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
  auto options = std::make_shared<VolumeRenderOptions>();
  options->Camera.Parallel = true;
  CLI::App* command = AddCommand(app, settings, "render",
    "Draw a volume from its Hartley coefficients into a .png or .exr file. A .ghv file is drawn\n"
    "chunk by chunk; other volumes are compressed in memory first. The projection is parallel.",
    "  gtn volume render head.ghv head.png\n"
    "  gtn volume render --range 0,1500 --elevation 10 --background black head.ghv a.png\n"
    "  gtn volume render --opacity-model xray --rotate 0.25,0.25,0.25 --size 512x512 head.ghv "
    "xray.png\n"
    "  gtn volume render --opacity-model exponential --extinction 0.001 head.nii.gz head.exr");
  AddForce(command, options->Overwrite);
  AddImageOptions(command, *options);
  AddViewOptions(command, options->Camera, "volume");
  AddRotation(command, options->Camera);
  AddColorOptions(command, *options, "volume");
  AddOpacityModelOptions(command, *options);
  AddMethodOptions(command, *options);
  AddVolumeInput(command, options->Input);
  AddCompression(command, options->Compression, "Compression of other volumes than .ghv files");
  command
    ->add_option_function<std::string>(
      "IN", [options](const std::string& file) { options->Input.Files = { file }; },
      std::string("A volume: ") + VolumeFormats)
    ->required();
  command->add_option("OUT", options->Out, "The .png or .exr file")->required();
  command->callback([options, &settings] { Render(*options, settings); });
}
}
