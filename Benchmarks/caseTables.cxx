// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Tables 1 and 2 of the dissertation. table1: images of single blocks next to sums along the same
// rays. table2: whole images next to those of a voxel-by-voxel ray caster.

#include "benchCases.h"
#include "benchVolume.h"

#include "gatunParallel.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

namespace bench
{
namespace
{
using gatun::HartleyLayout;
using gatun::HartleyView;
using gatun::test::ReferenceVolume;

struct TableOptions
{
  std::string File;
  std::vector<std::uint32_t> Blocks{ 4, 8, 16, 32, 64 };
  std::size_t MostBlocks = 1000;
  std::size_t Rays = 100000;
  double Opacity = 0.1;
  double Scale = 0.47;
};

/** The coefficients, so finely quantized that images do not show it. */
std::shared_ptr<const gatun::HartleySource> MakeExactSource(
  const Volume& volume, std::uint32_t block)
{
  gatun::VolumeInput input = volume.GetInput();
  input.Type = gatun::ScalarType::Float32; // integers would be rounded
  input.VTKType = VTK_FLOAT;
  input.Values = volume.GetVoxels().data();
  gatun::HartleyRateControl control;
  control.Mode = gatun::HartleyRateMode::RMSError;
  control.Value = 1e-6 * volume.GetRange();
  return gatun::HartleyVolume::Make(input, block, control);
}

/** A block that is looked at, and which rays of its image. */
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

/** Every so many-th, so that there are at most so many. */
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
std::vector<Chosen> ChooseBlocks(
  const Volume& volume, const HartleyLayout& layout, std::size_t most)
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

/** What the rays of some images came to. */
struct Sums
{
  std::size_t Rays = 0;
  double Largest = 0;   ///< of the sums of samples
  double OfSamples = 0; ///< square differences to sums of samples
  double OfLines = 0;   ///< to line integrals
  double Between = 0;   ///< of the two with one another

  void Add(const Sums& other)
  {
    this->Rays += other.Rays;
    this->Largest = std::max(this->Largest, other.Largest);
    this->OfSamples += other.OfSamples;
    this->OfLines += other.OfLines;
    this->Between += other.Between;
  }
};

/** Every so many-th ray that meets the block, beginning with another in each block. */
Sums CompareRays(const gatun::HartleyProjector::BlockImage& image, const ReferenceVolume& block,
  std::size_t number, std::size_t every)
{
  Sums sums;
  std::size_t met = number;
  for (unsigned row = 0; row < image.Height; ++row)
  {
    for (unsigned column = 0; column < image.Width; ++column)
    {
      const auto point = gatun::test::GetPixel(image.View, column, row);
      const auto part = block.Clip(point, image.View.Step);
      if (!(part.Begin < part.End) || met++ % every != 0)
      {
        continue;
      }
      const double own = image.Sums[row * std::size_t{ image.Width } + column];
      const double samples = block.SumSamples(point, image.View.Step);
      const double line = block.Integrate(point, image.View.Step);
      ++sums.Rays;
      sums.Largest = std::max(sums.Largest, samples);
      sums.OfSamples += (own - samples) * (own - samples);
      sums.OfLines += (own - line) * (own - line);
      sums.Between += (samples - line) * (samples - line);
    }
  }
  return sums;
}

Sums CompareBlocks(const Volume& volume, const gatun::HartleySource& source,
  gatun::HartleyProjector& projector, const HartleyView& view, const std::vector<Chosen>& chosen,
  std::size_t mostRays)
{
  Sums all;
  std::size_t every = 0;
  for (auto begin = chosen.begin(); begin != chosen.end();)
  {
    const auto end = std::find_if(
      begin, chosen.end(), [&](const Chosen& block) { return block.Chunk != begin->Chunk; });
    const auto images = projector.DrawBlocks(view, begin->Chunk);
    if (every == 0)
    {
      const auto& first = images.at(begin->InChunk);
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
        const Sums sums = CompareRays(images[block.InChunk], reference, block.InChunk, every);
        const std::lock_guard lock(mutex);
        all.Add(sums);
      });
    begin = end;
  }
  return all;
}

void PrintTable1(const TableOptions& options)
{
  const Volume volume(options.File);
  PrintJson(
    [&](Json::Value& json)
    {
      json["blocks"] = Json::arrayValue;
      for (const std::uint32_t block : options.Blocks)
      {
        const auto source = MakeExactSource(volume, block);
        const auto chosen = ChooseBlocks(volume, source->GetLayout(), options.MostBlocks);
        gatun::HartleyProjector projector(source);
        Json::Value entry;
        entry["block"] = static_cast<std::uint64_t>(block);
        entry["views"] = Json::arrayValue;
        for (const Turns& turns : GetPaperTurns())
        {
          const HartleyView view = gatun::test::MakeTurnedView(volume.GetSize(), turns, 16, 1);
          const Sums sums = CompareBlocks(volume, *source, projector, view, chosen, options.Rays);
          const double scale = 255 / sums.Largest;
          const double mean = scale * scale / static_cast<double>(sums.Rays);
          Json::Value viewJson;
          viewJson["samples"] = mean * sums.OfSamples;
          viewJson["lines"] = mean * sums.OfLines;
          viewJson["between"] = mean * sums.Between;
          entry["views"].append(viewJson);
        }
        json["blocks"].append(entry);
      }
    });
}

/** A pixel of the reference: whether its ray meets the volume, and the grays of the two models. */
struct ReferencePixel
{
  bool Met = false;
  double Exponential = 0;
  double Linear = 0;
};

std::vector<ReferencePixel> CastReference(const ReferenceVolume& volume, const HartleyView& view,
  const gatun::HartleyShading& exponential, const gatun::HartleyShading& linear)
{
  std::vector<ReferencePixel> pixels(std::size_t{ view.Width } * view.Height);
  gatun::ParallelFor(view.Height,
    [&](std::size_t row)
    {
      for (unsigned column = 0; column < view.Width; ++column)
      {
        auto& pixel = pixels[row * view.Width + column];
        const auto point = gatun::test::GetPixel(view, column, static_cast<double>(row));
        const auto part = volume.Clip(point, view.Step);
        if (part.Begin < part.End)
        {
          pixel.Met = true;
          pixel.Exponential = volume.Cast(point, view.Step, exponential)[0];
          pixel.Linear = volume.Cast(point, view.Step, linear)[0];
        }
      }
    });
  return pixels;
}

/** The mean square error of grays from 0 to 255. */
double GetImageError(const gatun::HartleyImage& image, const std::vector<ReferencePixel>& reference,
  double ReferencePixel::*gray)
{
  double squares = 0;
  std::size_t met = 0;
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    if (reference[i].Met)
    {
      const double error = 255 * (image.Colors[i][0] - reference[i].*gray);
      squares += error * error;
      ++met;
    }
  }
  return squares / static_cast<double>(met);
}

void PrintTable2(const TableOptions& options)
{
  const Volume volume(options.File);
  const auto exponential =
    MakeGray(volume, gatun::HartleyOpacityModel::Exponential, options.Opacity);
  const auto linear =
    MakeGray(volume, gatun::HartleyOpacityModel::TransferFunction, options.Opacity);
  double squares = 0;
  for (const std::uint32_t size : volume.GetSize())
  {
    squares += (size + 1.0) * (size + 1.0);
  }
  const auto pixels = static_cast<unsigned>(std::ceil(options.Scale * std::sqrt(squares)));
  std::vector<HartleyView> views;
  std::vector<std::vector<ReferencePixel>> references;
  for (const std::size_t i : { 1, 3 }) // the two of the table
  {
    views.push_back(
      gatun::test::MakeTurnedView(volume.GetSize(), GetPaperTurns()[i], pixels, options.Scale));
    references.push_back(CastReference(volume.GetReference(), views.back(), exponential, linear));
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["pixels"] = static_cast<std::uint64_t>(pixels);
      json["opacity"] = options.Opacity;
      json["blocks"] = Json::arrayValue;
      for (const std::uint32_t block : options.Blocks)
      {
        gatun::HartleyProjector projector(MakeExactSource(volume, block));
        Json::Value entry;
        entry["block"] = static_cast<std::uint64_t>(block);
        for (std::size_t i = 0; i < views.size(); ++i)
        {
          entry["exponential"].append(GetImageError(
            projector.Draw(views[i], exponential), references[i], &ReferencePixel::Exponential));
          entry["linear"].append(GetImageError(
            projector.Draw(views[i], linear), references[i], &ReferencePixel::Linear));
        }
        json["blocks"].append(entry);
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddTables(CLI::App& app)
{
  auto options = std::make_shared<TableOptions>();
  const auto add = [&](const char* name, const char* about, void (*print)(const TableOptions&))
  {
    CLI::App* const command = app.add_subcommand(name, about);
    command->add_option("VOLUME", options->File, "A .vti or NIfTI file; or head:SIZE")->required();
    command->add_option("--blocks", options->Blocks, "Voxels of a block")->delimiter(',');
    command->add_option("--most-blocks", options->MostBlocks, "At most so many blocks (table1)");
    command->add_option("--rays", options->Rays, "About so many rays for each view (table1)")
      ->check(CLI::Range(1, 1000000000));
    command
      ->add_option("--opacity", options->Opacity, "Of a sample of the highest density (table2)")
      ->check(CLI::Range(0.0001, 0.9999));
    command->add_option("--scale", options->Scale, "Pixels a voxel (table2)")
      ->check(CLI::Range(0.1, 16.0));
    command->callback([options, print] { print(*options); });
  };
  add("table1", "Mean square errors of blocks' images against sums along rays", PrintTable1);
  add("table2", "Mean square errors of images against voxel-by-voxel ray casting", PrintTable2);
}
}
