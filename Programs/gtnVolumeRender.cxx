// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn volume render: one or more images of a volume, from its Hartley coefficients.

#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnParse.h"
#include "gtnPictureOptions.h"
#include "gtnProgress.h"
#include "gtnRenderStatistics.h"
#include "gtnText.h"
#include "gtnVolume.h"
#include "gtnVolumeOptions.h"
#include "gtnVolumeSource.h"

#include "vtkGatunHartleyEncoder.h"
#include "vtkGatunHartleyProjection.h"
#include "vtkGatunHartleyView.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>

namespace gtn
{
namespace
{

constexpr std::array<const char*, 3> OpacityModels{ "xray", "exponential", "transfer" };
static_assert(vtkGatunHartleyProjection::OPACITY_MODEL_XRAY == 0 &&
  vtkGatunHartleyProjection::OPACITY_MODEL_EXPONENTIAL == 1 &&
  vtkGatunHartleyProjection::OPACITY_MODEL_TRANSFER_FUNCTION == 2);
constexpr std::array<const char*, 3> Methods{ "automatic", "basis", "slice" };
constexpr std::array<const char*, 2> Kernels{ "kaiser-bessel", "trilinear" };

struct Options : PictureOptions
{
  VolumeInputOptions Input;
  CompressionOptions Compression;
  int OpacityModel = vtkGatunHartleyProjection::OPACITY_MODEL_TRANSFER_FUNCTION;
  std::optional<double> Extinction;
  std::optional<double> Zero;
  std::optional<gatun::Range> Window;
  double SampleDistance = 0;
  int Method = 0;
  int Kernel = 0;
  double Padding = 2;
  int Memory = 512;
};

struct Drawn
{
  std::string File;
  vtkSmartPointer<vtkCamera> Camera;
  double Seconds = 0;
  std::uint64_t Blocks = 0;
  std::uint64_t Terms = 0;
};

void Check(const Options& options)
{
  if (!IsPicture(options.Out))
  {
    throw UsageError(options.Out + ": the name must end in " + PictureFormats);
  }
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

void SetUp(
  vtkGatunHartleyProjection* projection, const Options& options, const VolumeSource& source)
{
  projection->SetSize(options.Width, options.Height);
  projection->SetOpacityModel(options.OpacityModel);
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
  if (options.OpacityModel != vtkGatunHartleyProjection::OPACITY_MODEL_XRAY)
  {
    vtkGatunHartleyView::SetProperty(projection,
      MakeProperty(
        MakeTransfer(options, { source.GetFile(), source.GetArray(), source.GetRange() }),
        options.UnitDistance.value_or(DiagonalOf(source.GetBounds()) / 100)));
  }
}

// Draws a .ghv file as it is; encodes other volumes before.
void Connect(vtkGatunHartleyProjection* projection, vtkGatunHartleyEncoder* encoder,
  const Options& options, const Settings& settings, const VolumeSource& source)
{
  if (source.IsFile())
  {
    source.Connect(projection);
    return;
  }
  source.Connect(encoder);
  options.Compression.Apply(encoder);
  projection->SetInputConnection(encoder->GetOutputPort());
  Progress progress("compressing", settings.ShowProgress);
  progress.Watch(encoder);
  encoder->Update();
  CheckInterrupt();
  CheckMessages(source.GetFile(), settings.Quiet);
}

Drawn Draw(const Options& options, const Settings& settings, const VolumeSource& source,
  vtkGatunHartleyProjection* projection, const std::string& file, double turn, Progress& progress)
{
  const double aspect = static_cast<double>(options.Width) / options.Height;
  Drawn drawn{ file, MakeCamera(options.Camera, source.GetBounds(), aspect, turn) };
  vtkGatunHartleyView::SetView(projection, drawn.Camera);
  const auto start = std::chrono::steady_clock::now();
  progress.Watch(projection);
  projection->Update();
  CheckInterrupt();
  CheckMessages(source.GetFile(), settings.Quiet);
  drawn.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  drawn.Blocks = static_cast<std::uint64_t>(projection->GetNumberOfBlocksDrawn());
  drawn.Terms = projection->GetNumberOfCoefficients();
  return drawn;
}

double MedianSeconds(const std::vector<Drawn>& pictures)
{
  std::vector<double> seconds;
  for (const Drawn& picture : pictures)
  {
    seconds.push_back(picture.Seconds);
  }
  std::sort(seconds.begin(), seconds.end());
  const std::size_t middle = seconds.size() / 2;
  return seconds.size() % 2 == 1 ? seconds[middle] : (seconds[middle - 1] + seconds[middle]) / 2;
}

void PrintJson(const Options& options, const VolumeSource& source,
  vtkGatunHartleyProjection* projection, const std::vector<Drawn>& pictures, double peakMemory)
{
  Json json;
  json.BeginObject();
  json.Add("input", source.GetFile());
  json.BeginArray("size");
  for (const std::uint32_t voxels : source.GetSize())
  {
    json.Add({}, static_cast<std::uint64_t>(voxels));
  }
  json.EndArray();
  json.Add("array", source.GetArray());
  json.Add("opacityModel", OpacityModels.at(static_cast<std::size_t>(options.OpacityModel)));
  json.Add("method", Methods.at(static_cast<std::size_t>(projection->GetMethodUsed())));
  json.Add("width", options.Width);
  json.Add("height", options.Height);
  json.BeginArray("pictures");
  for (const Drawn& picture : pictures)
  {
    json.BeginObject();
    json.Add("file", picture.File);
    AddCamera(json, "camera", picture.Camera);
    json.Add("seconds", picture.Seconds);
    json.Add("blocks", picture.Blocks);
    json.Add("terms", picture.Terms);
    json.EndObject();
  }
  json.EndArray();
  json.Add("medianSeconds", MedianSeconds(pictures));
  json.Add("bytesRead", static_cast<std::uint64_t>(source.GetBytesRead()));
  json.Add("peakMemory", peakMemory);
  json.EndObject();
  fmt::print("{}", json.GetText());
}

void PrintRow(const char* title, const std::string& value)
{
  fmt::print("  {:<28} {:>14}\n", title, value);
}

void PrintText(const Options& options, const VolumeSource& source,
  vtkGatunHartleyProjection* projection, const std::vector<Drawn>& pictures, double peakMemory)
{
  const bool many = pictures.size() > 1;
  fmt::print("{}{}: {} x {}, '{}' of {} voxels, {:.2f} s{}\n", pictures.front().File,
    many ? " to " + FileOf(pictures.back().File) : std::string(), options.Width, options.Height,
    Printable(source.GetArray()), SizeOf(source.GetSize()), MedianSeconds(pictures),
    many ? " each" : "");
  if (options.Statistics)
  {
    PrintRow("method", Methods.at(static_cast<std::size_t>(projection->GetMethodUsed())));
    PrintRow("blocks drawn", Grouped(pictures.back().Blocks));
    PrintRow("coefficients summed", Grouped(pictures.back().Terms));
    if (source.IsFile())
    {
      PrintRow("read", ByteSize(source.GetBytesRead()));
    }
    if (peakMemory > 0)
    {
      PrintRow("peak memory", ByteSize(static_cast<std::uint64_t>(peakMemory)));
    }
  }
}

void Render(const Options& options, const Settings& settings)
{
  Check(options);
  const std::vector<std::string> files = NamePictures(options);
  for (const std::string& file : files)
  {
    CheckWritable(file, options.Overwrite);
  }
  const VolumeSource source(options.Input, settings);
  vtkNew<vtkGatunHartleyProjection> projection;
  SetUp(projection, options, source);
  vtkNew<vtkGatunHartleyEncoder> encoder;
  Connect(projection, encoder, options, settings, source);
  std::vector<Drawn> pictures;
  double peakMemory = 0;
  for (const std::string& file : files)
  {
    const auto number = static_cast<double>(pictures.size());
    const auto count = static_cast<double>(files.size());
    Progress progress(
      files.size() > 1 ? fmt::format("drawing {} of {}", number + 1, count) : "drawing",
      settings.ShowProgress);
    pictures.push_back(
      Draw(options, settings, source, projection, file, 360 * number / count, progress));
    peakMemory = GetPeakMemory();
    WritePicture(projection->GetOutput(), options.Background,
      MakeRemarks({ source.GetFile(), source.GetArray(), source.GetRange() }, settings.CommandLine,
        pictures.back().Camera),
      file);
  }
  if (options.Json)
  {
    PrintJson(options, source, projection, pictures, peakMemory);
  }
  else if (!settings.Quiet || options.Statistics)
  {
    PrintText(options, source, projection, pictures, peakMemory);
  }
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

void AddOpacityModelOptions(CLI::App* command, Options& options)
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

void AddMethodOptions(CLI::App* command, Options& options)
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
    "How blocks are projected: as sums of the images of basis functions (basis) or by slices "
    "through their spectra (slice); automatic: basis for blocks of up to 16 voxels",
    group);
  AddChoice(command, "--kernel", Kernels, options.Kernel,
    "For slice: interpolation by kaiser-bessel (the default), nearly exact, or trilinear, for "
    "comparison",
    group);
  command
    ->add_option("--padding", options.Padding,
      "For slice: size of a zero-padded block relative to the block, 1 to 8")
    ->check(Between(1, 8))
    ->option_text("F [2]")
    ->group(group);
  command
    ->add_option("--memory", options.Memory,
      "MiB of coefficients or spectra to keep from image to image, 0 to 1048576")
    ->check(CLI::Range(0, 1 << 20))
    ->option_text("MIB [512]")
    ->group(group);
  command
    ->add_flag(
      "--stats", options.Statistics, "Print statistics; of a turntable, those of the last image")
    ->group(group);
  command->add_flag("--json", options.Json, "Print the statistics of each image as JSON")
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
  auto options = std::make_shared<Options>();
  options->TransferFunction = "bone";
  options->Camera.Parallel = true;
  CLI::App* command = AddCommand(app, settings, "render",
    "Draw a volume from its Hartley coefficients into a .png or .exr file. A .ghv file is drawn\n"
    "chunk by chunk; other volumes are compressed in memory first. The projection is parallel.",
    "  gtn volume render head.ghv head.png\n"
    "  gtn volume render --tf bone --range 0,1500 --elevation 10 --background black head.ghv "
    "a.png\n"
    "  gtn volume render --opacity-model xray --rotate 0.25,0.25,0.25 --size 512x512 head.ghv "
    "xray.png\n"
    "  gtn volume render --opacity-model exponential --extinction 0.001 head.nii.gz head.exr\n"
    "  gtn volume render --turntable 36 head.ghv around.png");
  AddForce(command, options->Overwrite);
  AddPictureOptions(command, *options);
  AddViewOptions(command, options->Camera, "volume");
  AddRotation(command, options->Camera);
  AddColourOptions(command, *options, "volume");
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
