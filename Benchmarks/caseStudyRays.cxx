// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// study-release: tetrahedra released from the front, or from both ends, with and without an end of
// rays at what is opaque. study-prefilter: what leaving out tetrahedra between the rays is worth.

#include "benchCases.h"
#include "benchScene.h"

#include "gatunFileRaySource.h"
#include "gatunFileReader.h"
#include "gatunParallel.h"
#include "gatunRayCaster.h"

#include <algorithm>
#include <array>
#include <memory>

namespace bench
{
namespace
{

struct StudyRaysOptions
{
  std::string File;
  std::string Array = "Density";
  std::vector<int> Sizes{ 512 };
  int Rounds = 3;
};

/** How much of the light a mesh holds back: Scene::Opacities. */
struct Light
{
  std::string Name;
  std::array<double, 2> Opacities;
};

struct RayCase
{
  std::string Light;
  Scene View;
  int Size = 512;
  gatun::RaySettings Settings = {};
  gatun::RayStatistics Statistics = {};
  Seen Picture = {};
};

Seen Look(const std::vector<float>& rgba)
{
  std::size_t covered = 0;
  double sum = 0;
  for (std::size_t i = 0; i < rgba.size(); i += 4)
  {
    covered += rgba[i + 3] > 0 ? 1 : 0;
    sum += rgba[i] + rgba[i + 1] + rgba[i + 2];
  }
  if (covered == 0)
  {
    throw Failure("a picture is empty");
  }
  const auto pixels = static_cast<double>(rgba.size() / 4);
  return { static_cast<double>(covered) / pixels, sum / (3 * pixels) };
}

void Draw(RayCase& one, const std::shared_ptr<const gatun::FileReader>& file, std::uint32_t array)
{
  // Nothing is kept, so that each picture begins with the file.
  gatun::FileRaySource source(file, { array, 0, 0 }, 0);
  const gatun::RayView view = one.View.MakeView(one.Size);
  // The paper's method takes samples, and its pre-filter drops what lies between them.
  gatun::RayCaster caster(
    view, one.View.MakeTable(view, gatun::RayMode::Sampled), {}, one.Settings);
  caster.Draw(source);
  std::vector<float> rgba(
    4 * static_cast<std::size_t>(one.Size) * static_cast<std::size_t>(one.Size));
  caster.Finish(rgba.data());
  one.Statistics = caster.GetStatistics();
  one.Picture = Look(rgba);
}

void Print(const RayCase& one, const Operation& operation, Json::Value& json)
{
  const gatun::RayStatistics& known = one.Statistics;
  Json::Value entry;
  entry["light"] = one.Light;
  entry["size"] = one.Size;
  entry["opaque"] = static_cast<double>(one.Settings.Opaque);
  entry["bothEnds"] = one.Settings.FromBothEnds;
  entry["prefilter"] = one.Settings.Prefilter;
  entry["tets"] = known.Tets;
  entry["seenTets"] = known.SeenTets;
  entry["blocks"] = known.Blocks;
  entry["skippedBlocks"] = known.SkippedBlocks;
  entry["mostWaiting"] = known.MostWaiting;
  entry["mostFragments"] = known.MostFragments;
  entry["mostBytes"] = known.MostBytes;
  entry["fetch"] = known.FetchTime;
  entry["order"] = known.OrderTime;
  entry["setUp"] = known.SetUpTime;
  entry["draw"] = known.DrawTime;
  entry["finish"] = known.FinishTime;
  entry["covered"] = one.Picture.Covered;
  entry["mean"] = one.Picture.Mean;
  AddTimes(entry, operation);
  json.append(entry);
}

void Time(const StudyRaysOptions& options, std::vector<RayCase>& cases,
  const std::shared_ptr<const gatun::FileReader>& file)
{
  const std::uint32_t array = FindPointArray(*file, options.Array);
  std::vector<Operation> operations;
  for (RayCase& one : cases)
  {
    operations.push_back({ one.Light, [&one, &file, array] { Draw(one, file, array); } });
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  std::uint64_t largest = 0;
  for (const gatun::ChunkInfo& chunk : file->GetChunks())
  {
    largest = std::max(largest, chunk.Tets);
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = file->GetNumberOfTets();
      json["chunks"] = static_cast<std::uint64_t>(file->GetChunks().size());
      json["largestChunk"] = largest;
      json["cases"] = Json::arrayValue;
      for (std::size_t i = 0; i < cases.size(); ++i)
      {
        Print(cases[i], operations[i], json["cases"]);
      }
    });
}

void StudyRelease(const StudyRaysOptions& options)
{
  const auto file = std::make_shared<const gatun::FileReader>(options.File);
  std::vector<RayCase> cases;
  for (const Light& light :
    { Light{ "translucent", { 0, 0.02 } }, Light{ "nearly opaque", { 0.9, 0.9 } } })
  {
    for (const float opaque : { gatun::RaySettings().Opaque, 0.0f })
    {
      for (const bool bothEnds : { false, true })
      {
        RayCase one{ light.Name, MakeScene(*file, options.Array), options.Sizes[0] };
        one.View.Opacities = light.Opacities;
        one.Settings.Opaque = opaque;
        one.Settings.FromBothEnds = bothEnds;
        cases.push_back(one);
      }
    }
  }
  Time(options, cases, file);
}

void StudyPrefilter(const StudyRaysOptions& options)
{
  const auto file = std::make_shared<const gatun::FileReader>(options.File);
  std::vector<RayCase> cases;
  for (const int size : options.Sizes)
  {
    for (const bool prefilter : { true, false })
    {
      RayCase one{ "ordinary", MakeScene(*file, options.Array), size };
      one.Settings.Prefilter = prefilter;
      cases.push_back(one);
    }
  }
  Time(options, cases, file);
}

void Add(CLI::App& app, const char* name, const char* about, void (*study)(const StudyRaysOptions&))
{
  auto options = std::make_shared<StudyRaysOptions>();
  CLI::App* command = app.add_subcommand(name, about);
  command->add_option("FILE", options->File, "A .gtn file")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Sizes, "Width and height in pixels")
    ->delimiter(',')
    ->check(CLI::Range(16, 8192));
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->callback([options, study] { study(*options); });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddStudyRelease(CLI::App& app)
{
  Add(app, "study-release",
    "Tetrahedra released from the front or from both ends: waiting, fragments, memory, time",
    StudyRelease);
}

//------------------------------------------------------------------------------
void AddStudyPrefilter(CLI::App& app)
{
  Add(app, "study-prefilter", "Time with and without the pre-filter, for one or more sizes",
    StudyPrefilter);
}
}
