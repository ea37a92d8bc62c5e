// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// volume-times: seconds for a view of a volume, each view from another side, next to what draws it
// from voxels.

#include "benchCases.h"
#include "benchVolume.h"
#include "benchVolumePeers.h"

#include "gatunHartleyFile.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <numeric>
#include <optional>

namespace bench
{
namespace
{
using gatun::HartleyOpacityModel;

struct VolumeTimesOptions
{
  std::string File;
  std::vector<std::uint32_t> Blocks{ 8 };
  std::vector<double> Rates{ 0 };
  std::vector<std::string> Laws{ "xray", "exponential" };
  unsigned Pixels = 512;
  double Opacity = 0.1;
  int Rounds = 3;
  bool Peers = false;
  bool Errors = false;
  std::string Folder;
  bool Window = false;
};

/** Something that draws, and what is known of it. */
struct Drawer
{
  std::string Way;
  std::string Law;
  std::uint32_t Block = 0;
  double Rate = 0;
  std::function<void(const gatun::HartleyView&)> Draw = {};
  std::function<std::vector<float>()> GetSums = {};  ///< X-ray: of the last view, minus the base
  std::shared_ptr<gatun::HartleyImage> Picture = {}; ///< Gatun's last
  int Views = 0;                                     ///< so far
  Cost First{};
  double FirstProcessor = 0;          ///< seconds of all threads
  double OtherAxis = 0;               ///< seconds of the first view along another axis
  std::vector<double> Processor = {}; ///< seconds of all threads, of the later views
};

/** The same views for all, none twice. */
gatun::HartleyView GetView(const Volume& volume, unsigned pixels, int number, double turn = 0)
{
  const double scale = pixels / static_cast<double>(volume.GetPixels(1));
  return volume.MakeView(
    { 0.13 + 0.07 * number + turn, 0.21 + 0.05 * number, 0.03 }, pixels, scale);
}

std::uint64_t CountTerms(const gatun::HartleySource& source)
{
  std::uint64_t terms = 0;
  for (std::size_t chunk = 0; chunk < source.GetLayout().GetNumberOfChunks(); ++chunk)
  {
    terms += source.GetChunk(chunk)->Terms.size();
  }
  return terms;
}

double GetProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** The mean square error of X-rays of two views, of 255 squared, where 255 is the largest sum. The
 * exact sums are integrals of the trilinear volume. */
void AddErrors(
  Json::Value& json, const std::vector<Drawer>& drawers, const Volume& volume, unsigned pixels)
{
  const gatun::test::ReferenceVolume reference = volume.GetReference();
  json["errors"] = Json::arrayValue;
  for (const int number : { 0, 3 })
  {
    const gatun::HartleyView view = GetView(volume, pixels, number);
    std::vector<double> exact(std::size_t{ view.Width } * view.Height);
    gatun::ParallelFor(view.Height,
      [&](std::size_t row)
      {
        for (unsigned column = 0; column < view.Width; ++column)
        {
          exact[row * view.Width + column] = reference.Integrate(
            gatun::test::GetPixel(view, column, static_cast<double>(row)), view.Step);
        }
      });
    const double scale = 255 / *std::max_element(exact.begin(), exact.end());
    for (const Drawer& drawer : drawers)
    {
      if (!drawer.GetSums)
      {
        continue;
      }
      drawer.Draw(view);
      const std::vector<float> sums = drawer.GetSums();
      double squares = 0;
      double worst = 0;
      for (std::size_t i = 0; i < exact.size(); ++i)
      {
        const double error = (static_cast<double>(sums[i]) - exact[i]) * scale;
        squares += error * error;
        worst = std::max(worst, std::abs(error));
      }
      Json::Value entry;
      entry["way"] = drawer.Way;
      entry["block"] = static_cast<std::uint64_t>(drawer.Block);
      entry["rate"] = drawer.Rate;
      entry["view"] = number;
      entry["mse"] = squares / static_cast<double>(exact.size());
      entry["worst"] = worst;
      json["errors"].append(entry);
    }
  }
}

double GetMedian(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Plain: seconds of a plain ray sum, or 0. */
void AddDrawer(Json::Value& json, const Drawer& drawer, const Operation& operation, double plain)
{
  Json::Value entry;
  entry["way"] = drawer.Way;
  entry["law"] = drawer.Law;
  if (drawer.Picture)
  {
    entry["block"] = static_cast<std::uint64_t>(drawer.Block);
    entry["rate"] = drawer.Rate;
    entry["termsDrawn"] = drawer.Picture->Terms;
    entry["blocksDrawn"] = drawer.Picture->Blocks;
    constexpr std::array<const char*, 4> methods{ "automatic", "basis", "slice", "voxels" };
    entry["method"] = methods.at(static_cast<std::size_t>(drawer.Picture->Method));
  }
  AddCost(entry, drawer.First);
  entry["processor"] = drawer.FirstProcessor;
  AddList(entry, "later", operation.Seconds);
  entry["otherAxis"] = drawer.OtherAxis;
  if (plain > 0)
  {
    entry["timesAsFastAsPlain"] = plain / GetMedian(operation.Seconds);
  }
  AddList(entry, "laterProcessor", drawer.Processor);
  json.append(entry);
}

/** Of Gatun: each law of each block size and rate, and all of it is kept. */
std::vector<Drawer> MakeOwn(
  const Volume& volume, const VolumeTimesOptions& options, Json::Value& json)
{
  std::vector<Drawer> drawers;
  json["sources"] = Json::arrayValue;
  for (const std::uint32_t block : options.Blocks)
  {
    for (const double rate : options.Rates)
    {
      std::shared_ptr<const gatun::HartleySource> source;
      const std::string path =
        options.Folder + "/times-" + std::to_string(block) + "-" + std::to_string(rate) + ".ghv";
      const Cost cost = CostOf(
        [&]
        {
          if (options.Folder.empty())
          {
            source = gatun::HartleyVolume::Make(volume.GetInput(), block, MakeQuality(rate));
          }
          else
          {
            gatun::WriteHartleyFile(path, volume.GetInput(), { block, MakeQuality(rate) });
            source = std::make_shared<gatun::HartleyFile>(path);
          }
        });
      Json::Value sourceJson;
      sourceJson["block"] = static_cast<std::uint64_t>(block);
      sourceJson["rate"] = rate;
      AddCost(sourceJson, cost);
      sourceJson["terms"] = CountTerms(*source);
      json["sources"].append(sourceJson);
      for (const std::string& law : options.Laws)
      {
        // One each: what is kept of a view is of no use for another.
        const auto projector = std::make_shared<std::optional<gatun::HartleyProjector>>();
        Drawer drawer{ "gatun", law, block, rate };
        drawer.Picture = std::make_shared<gatun::HartleyImage>();
        const gatun::HartleyShading shading =
          MakeGray(volume, GetOpacityModel(law), options.Opacity);
        drawer.Draw = [source, path, projector, shading, picture = drawer.Picture,
                        isFile = !options.Folder.empty()](const auto& view)
        {
          if (!*projector)
          {
            // Opening the file counts for the first view.
            projector->emplace(isFile ? std::make_shared<const gatun::HartleyFile>(path) : source);
          }
          *picture = (*projector)->Draw(view, shading);
        };
        if (law == "xray")
        {
          drawer.GetSums = [base = static_cast<float>(source->GetBase()), picture = drawer.Picture]
          {
            std::vector<float> sums = picture->Sums;
            for (std::size_t i = 0; i < sums.size(); ++i)
            {
              sums[i] -= base * picture->Samples[i];
            }
            return sums;
          };
        }
        drawers.push_back(std::move(drawer));
      }
    }
  }
  return drawers;
}

void AddPeers(std::vector<Drawer>& drawers, const Volume& volume, const VolumeTimesOptions& options)
{
  const auto plain = std::make_shared<PlainRaySum>(volume);
  const auto last = std::make_shared<std::vector<float>>();
  drawers.push_back({ "plain", "xray", 0, 0,
    [plain, last](const gatun::HartleyView& view)
    {
      *last = plain->Draw(view);
      if (std::accumulate(last->begin(), last->end(), 0.0) <= 0)
      {
        throw Failure("a picture is empty");
      }
    },
    [last] { return *last; }, nullptr });
  if (!options.Window)
  {
    return;
  }
  for (const std::string& law : options.Laws)
  {
    const auto window = std::make_shared<FixedPointWindow>(
      volume, options.Pixels, MakeGray(volume, GetOpacityModel(law), options.Opacity));
    drawers.push_back({ "fixed-point", law, 0, 0,
      [window](const gatun::HartleyView& view)
      {
        window->Render(view);
        if (window->GetMean() <= 0)
        {
          throw Failure("a picture is empty");
        }
      },
      {}, nullptr });
  }
}

void PrintTimes(const VolumeTimesOptions& options)
{
  const Volume volume(options.File);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["pixels"] = static_cast<std::uint64_t>(options.Pixels);
      json["voxels"] = static_cast<std::uint64_t>(volume.GetNumberOfVoxels());
      std::vector<Drawer> drawers = MakeOwn(volume, options, json);
      if (options.Peers)
      {
        AddPeers(drawers, volume, options);
      }
      std::vector<Operation> operations;
      for (Drawer& drawer : drawers)
      {
        const auto draw = [&volume, &options, &drawer]
        { drawer.Draw(GetView(volume, options.Pixels, drawer.Views++)); };
        const double begin = GetProcessorSeconds();
        drawer.First = CostOf(draw);
        drawer.FirstProcessor = GetProcessorSeconds() - begin;
        operations.push_back({ drawer.Way,
          [draw, &drawer]
          {
            const double before = GetProcessorSeconds();
            draw();
            drawer.Processor.push_back(GetProcessorSeconds() - before);
          } });
      }
      RunInterleaved(operations, options.Rounds);
      double plain = 0;
      for (std::size_t i = 0; i < drawers.size(); ++i)
      {
        const auto other = GetView(volume, options.Pixels, 0, 0.5);
        drawers[i].OtherAxis = CostOf([&] { drawers[i].Draw(other); }).Seconds;
        plain = drawers[i].Way == "plain" ? GetMedian(operations[i].Seconds) : plain;
      }
      json["ways"] = Json::arrayValue;
      for (std::size_t i = 0; i < drawers.size(); ++i)
      {
        AddDrawer(json["ways"], drawers[i], operations[i], plain);
      }
      if (options.Errors)
      {
        AddErrors(json, drawers, volume, options.Pixels);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeTimes(CLI::App& app)
{
  auto options = std::make_shared<VolumeTimesOptions>();
  CLI::App* const command = app.add_subcommand(
    "volume-times", "Time for each view of a volume, from ever other sides, next to peers");
  command->add_option("VOLUME", options->File, "A .vti or NIfTI file; head:SIZE, smooth:SIZE")
    ->required();
  command->add_option("--blocks", options->Blocks, "Voxels of a block; 0: all in one");
  command->add_option("--rates", options->Rates, "Bits a voxel; 0: lossless");
  command->add_option("--laws", options->Laws, "How densities become colors")
    ->check(CLI::IsMember(GetLawNames()));
  command->add_option("--pixels", options->Pixels, "Width and height of a picture")
    ->check(CLI::Range(16, 8192));
  command->add_option("--opacity", options->Opacity, "Of a sample of the highest density")
    ->check(CLI::Range(0.0001, 0.9999));
  command->add_option("--rounds", options->Rounds, "Views beyond the first")
    ->check(CLI::Range(1, 1000));
  command->add_option("--folder", options->Folder, "Draw from files that are written here")
    ->check(CLI::ExistingDirectory);
  command->add_flag("--errors", options->Errors, "Compare X-rays with exact integrals, too");
  command->add_flag("--peers", options->Peers, "Measure plain sums along rays too");
  command->add_flag(
    "--window", options->Window, "And vtkFixedPointVolumeRayCastMapper, which needs a display");
  command->callback([options] { PrintTimes(*options); });
}
}
