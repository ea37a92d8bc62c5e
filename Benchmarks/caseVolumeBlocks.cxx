// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// volume-blocks: pictures of single blocks next to sums along the same rays, Table 1 of the
// dissertation.

#include "benchCases.h"
#include "benchVolume.h"

#include "gatunParallel.h"

#include <algorithm>
#include <memory>
#include <mutex>

namespace bench
{
namespace
{
using gatun::HartleyLayout;
using gatun::HartleyView;
using gatun::test::ReferenceVolume;

struct VolumeBlocksOptions
{
  std::string File;
  std::uint32_t Block = 8;
  double Rate = 0;
  std::size_t Blocks = 2000;
  std::size_t Rays = 1000000;
  std::vector<std::string> Ways; ///< all if empty
};

/** A way to make a block's picture. */
struct Way
{
  const char* Name;
  gatun::HartleyOptions VolumeBlocksOptions;
};

std::vector<Way> GetWays()
{
  using gatun::HartleyKernel;
  using gatun::HartleyMethod;
  gatun::HartleyOptions options;
  std::vector<Way> ways{ { "gatun", options } };
  options.Method = HartleyMethod::Slice;
  ways.push_back({ "slice", options });
  options.Kernel = HartleyKernel::Trilinear;
  ways.push_back({ "trilinear-2", options });
  options.Padding = 1;
  ways.push_back({ "trilinear-1", options });
  return ways;
}

/** A block that is looked at, and which rays of its picture. */
struct Chosen
{
  std::size_t Chunk = 0;
  std::size_t InChunk = 0;
  HartleyLayout::Triple First{};
  HartleyLayout::Triple End{};
};

/** Whether all of a box has the lowest density. */
bool IsEmpty(const Volume& volume, const Chosen& block)
{
  const auto& size = volume.GetSize();
  const auto lowest = static_cast<float>(volume.GetLowest());
  for (std::uint32_t z = block.First[2]; z < block.End[2]; ++z)
  {
    for (std::uint32_t y = block.First[1]; y < block.End[1]; ++y)
    {
      const float* const row = &volume.GetVoxels()[size[0] * (y + std::size_t{ size[1] } * z)];
      if (std::any_of(
            row + block.First[0], row + block.End[0], [&](float v) { return v != lowest; }))
      {
        return false;
      }
    }
  }
  return true;
}

/** The blocks of a chunk that are not empty. */
std::vector<Chosen> FindBlocks(const Volume& volume, const HartleyLayout& layout, std::size_t chunk)
{
  std::vector<Chosen> found;
  const HartleyLayout::Box box = layout.GetBlocksOfChunk(chunk);
  std::size_t number = 0;
  for (std::uint32_t k = box.First[2]; k < box.End[2]; ++k)
  {
    for (std::uint32_t j = box.First[1]; j < box.End[1]; ++j)
    {
      for (std::uint32_t i = box.First[0]; i < box.End[0]; ++i, ++number)
      {
        const HartleyLayout::Triple place{ i, j, k };
        Chosen block{ chunk, number, {}, {} };
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          block.First[axis] = place[axis] * layout.Block[axis];
          block.End[axis] =
            std::min(block.First[axis] + layout.Block[axis], volume.GetSize()[axis]);
        }
        if (!IsEmpty(volume, block))
        {
          found.push_back(block);
        }
      }
    }
  }
  return found;
}

/** Every so manieth, so that there are at most so many. */
template <typename Item>
void Thin(std::vector<Item>& items, std::size_t most)
{
  if (items.size() > most)
  {
    for (std::size_t i = 0; i < most; ++i)
    {
      items[i] = items[i * items.size() / most];
    }
    items.resize(most);
  }
}

/** Blocks that are not empty, evenly many through the volume, in the order of chunks. All of a
 * chunk are drawn where one is looked at, and therefore not all chunks are. */
std::vector<Chosen> Choose(const Volume& volume, const HartleyLayout& layout, std::size_t most)
{
  std::vector<std::vector<Chosen>> chunks;
  for (std::size_t chunk = 0; chunk < layout.GetNumberOfChunks(); ++chunk)
  {
    chunks.push_back(FindBlocks(volume, layout, chunk));
    if (chunks.back().empty())
    {
      chunks.pop_back();
    }
  }
  Thin(chunks, layout.Block[0] < 8 ? 6 : 12);
  std::vector<Chosen> found;
  for (const auto& blocks : chunks)
  {
    found.insert(found.end(), blocks.begin(), blocks.end());
  }
  Thin(found, most);
  return found;
}

/** What the rays of some pictures came to. */
struct Sums
{
  std::size_t Rays = 0;
  double Largest = 0;   ///< of the sums of samples
  double OfSamples = 0; ///< square differences to sums of samples
  double OfLines = 0;   ///< to line integrals
  double Between = 0;   ///< of the two with one another
  double WorstLine = 0; ///< largest difference to a line integral

  void Add(const Sums& other)
  {
    this->Rays += other.Rays;
    this->Largest = std::max(this->Largest, other.Largest);
    this->OfSamples += other.OfSamples;
    this->OfLines += other.OfLines;
    this->Between += other.Between;
    this->WorstLine = std::max(this->WorstLine, other.WorstLine);
  }
};

/** Every so manieth ray that meets the block, beginning with another in each block. */
Sums Compare(const gatun::HartleyProjector::BlockImage& picture, const ReferenceVolume& block,
  std::size_t number, std::size_t every)
{
  Sums sums;
  std::size_t met = number;
  for (unsigned row = 0; row < picture.Height; ++row)
  {
    for (unsigned column = 0; column < picture.Width; ++column)
    {
      const auto point = gatun::test::GetPixel(picture.View, column, row);
      const auto part = block.Clip(point, picture.View.Step);
      if (!(part.Begin < part.End) || met++ % every != 0)
      {
        continue;
      }
      const double own = picture.Sums[row * std::size_t{ picture.Width } + column];
      const double samples = block.SumSamples(point, picture.View.Step);
      const double line = block.Integrate(point, picture.View.Step);
      ++sums.Rays;
      sums.Largest = std::max(sums.Largest, samples);
      sums.OfSamples += (own - samples) * (own - samples);
      sums.OfLines += (own - line) * (own - line);
      sums.Between += (samples - line) * (samples - line);
      sums.WorstLine = std::max(sums.WorstLine, std::abs(own - line));
    }
  }
  return sums;
}

Sums Measure(const Volume& volume, const gatun::HartleySource& source,
  gatun::HartleyProjector& projector, const HartleyView& view, const std::vector<Chosen>& chosen,
  std::size_t mostRays)
{
  Sums all;
  std::size_t every = 0;
  for (auto begin = chosen.begin(); begin != chosen.end();)
  {
    const auto end = std::find_if(
      begin, chosen.end(), [&](const Chosen& block) { return block.Chunk != begin->Chunk; });
    const auto pictures = projector.DrawBlocks(view, begin->Chunk);
    if (every == 0)
    {
      const auto& first = pictures.at(begin->InChunk);
      const std::size_t rays = chosen.size() * first.Width * first.Height;
      every = std::max<std::size_t>(1, rays / mostRays);
    }
    std::mutex mutex;
    gatun::ParallelFor(static_cast<std::size_t>(end - begin),
      [&](std::size_t i)
      {
        const Chosen& block = begin[static_cast<std::ptrdiff_t>(i)];
        const ReferenceVolume reference(
          volume.GetVoxels().data(), volume.GetSize(), source.GetBase(), block.First, block.End);
        const Sums sums = Compare(pictures[block.InChunk], reference, block.InChunk, every);
        const std::lock_guard lock(mutex);
        all.Add(sums);
      });
    begin = end;
  }
  return all;
}

void PrintBlocks(const VolumeBlocksOptions& options)
{
  const Volume volume(options.File);
  const auto source = MakeSource(volume, options.Block, options.Rate);
  const std::vector<Chosen> chosen = Choose(volume, source->GetLayout(), options.Blocks);
  PrintJson(
    [&](Json::Value& json)
    {
      json["block"] = static_cast<std::uint64_t>(options.Block);
      json["rate"] = options.Rate;
      json["blocks"] = static_cast<std::uint64_t>(chosen.size());
      json["ways"] = Json::arrayValue;
      for (const Way& way : GetWays())
      {
        if (!options.Ways.empty() &&
          std::find(options.Ways.begin(), options.Ways.end(), way.Name) == options.Ways.end())
        {
          continue;
        }
        gatun::HartleyProjector projector(source, way.VolumeBlocksOptions);
        Json::Value wayJson;
        wayJson["way"] = way.Name;
        wayJson["views"] = Json::arrayValue;
        for (const Turns& turns : GetPaperTurns())
        {
          const HartleyView view = gatun::test::MakeTurnedView(volume.GetSize(), turns, 16, 1);
          const Sums sums = Measure(volume, *source, projector, view, chosen, options.Rays);
          const double scale = 255 / sums.Largest;
          const double mean = scale * scale / static_cast<double>(sums.Rays);
          Json::Value viewJson;
          viewJson["rays"] = static_cast<std::uint64_t>(sums.Rays);
          viewJson["largest"] = sums.Largest;
          viewJson["samples"] = mean * sums.OfSamples;
          viewJson["lines"] = mean * sums.OfLines;
          viewJson["between"] = mean * sums.Between;
          viewJson["worst"] = scale * sums.WorstLine;
          wayJson["views"].append(viewJson);
        }
        json["ways"].append(wayJson);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddVolumeBlocks(CLI::App& app)
{
  auto options = std::make_shared<VolumeBlocksOptions>();
  CLI::App* const command = app.add_subcommand(
    "volume-blocks", "Mean square errors of blocks' pictures against sums along rays");
  command->add_option("VOLUME", options->File, "A .vti or NIfTI file; head:SIZE, smooth:SIZE")
    ->required();
  command->add_option("--block", options->Block, "Voxels of a block; 0: all in one");
  command->add_option("--rate", options->Rate, "Bits a voxel; 0: not quantized");
  command->add_option("--blocks", options->Blocks, "At most so many blocks");
  command->add_option("--rays", options->Rays, "At most about so many rays for each view")
    ->check(CLI::Range(1, 1000000000));
  command->add_option("--ways", options->Ways, "Those only")
    ->check(CLI::IsMember({ "gatun", "slice", "trilinear-1", "trilinear-2" }));
  command->callback([options] { PrintBlocks(*options); });
}
}
