// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayImages_h
#define gatunRayImages_h

// What tests of the ray caster draw, how, and how they compare images.

#include "gatunRayCaster.h"
#include "gatunRayReference.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace gatun::test
{
/** Colors with ramps, which begin and end at entries of the table, and a part that is not seen. */
inline std::array<double, 4> Ramp(double value)
{
  const double s = std::clamp(value, 0.0, 1.0);
  const double opacity = s < 0.25 ? 0 : s < 0.625 ? (s - 0.25) : 0.375 - (s - 0.625) / 2;
  return { s, 1 - std::abs(2 * s - 1), 1 - s, opacity };
}

/** Eight sharp bands that are nearly opaque, and the values between them and nothing. */
inline std::array<double, 4> Bands(double value)
{
  const double s = 16 * std::clamp(value, 0.0, 1.0) + 0.3;
  const auto band = static_cast<int>(s);
  const double high = band % 4 == 0 ? 1.0 : 0.4;
  return { high, 0.5, 1 - high, band % 2 == 0 ? 0.9 : 0 };
}

inline std::vector<double> BandBreaks()
{
  std::vector<double> breaks;
  for (int band = 1; band <= 16; ++band)
  {
    breaks.push_back((band - 0.3) / 16);
  }
  return breaks;
}

inline double Wave(const Vec& p)
{
  return 0.5 + 0.25 * std::sin(1.3 * p[0] + 0.2) + 0.25 * std::cos(1.7 * p[1]) * std::sin(p[2]);
}

inline ReferenceMesh ToReference(const TestMesh& mesh)
{
  ReferenceMesh result;
  for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
  {
    result.Points.push_back(
      { mesh.Coordinates[3 * i], mesh.Coordinates[3 * i + 1], mesh.Coordinates[3 * i + 2] });
    result.Values.push_back(Wave(result.Points.back()));
  }
  for (std::size_t i = 0; i < mesh.GetTets(); ++i)
  {
    auto& tet = result.Tets.emplace_back();
    for (std::size_t c = 0; c < 4; ++c)
    {
      tet[c] = static_cast<std::uint32_t>(mesh.Ids[4 * i + c]);
    }
  }
  return result;
}

inline RaySource::Blocks MakeBlocks(const ReferenceMesh& mesh, std::size_t tetsInBlock)
{
  RaySource::Blocks blocks;
  for (std::size_t first = 0; first < mesh.Tets.size(); first += tetsInBlock)
  {
    auto block = std::make_shared<RayBlock>();
    std::vector<std::uint32_t> places(mesh.Points.size(), ~0u);
    for (auto i = first; i < std::min(first + tetsInBlock, mesh.Tets.size()); ++i)
    {
      auto tet = mesh.Tets[i];
      for (auto& corner : tet)
      {
        const auto point = corner;
        if (places[point] == ~0u)
        {
          places[point] = static_cast<std::uint32_t>(block->Points.size());
          const Vec& p = mesh.Points[point];
          block->Points.push_back({ p[0], p[1], p[2], mesh.Values[point] });
        }
        corner = places[point];
      }
      block->Tets.push_back(tet);
    }
    block->Prepare();
    blocks.push_back(std::move(block));
  }
  return blocks;
}

/** Each instruction set. One that this processor lacks is replaced by a simpler one. */
constexpr RayInstructions AllInstructions[] = { RayInstructions::Portable, RayInstructions::AVX2,
  RayInstructions::AVX512 };

struct Image
{
  std::vector<float> Colors;
  std::vector<float> Depths;
};

struct Setting
{
  RayMode Mode = RayMode::Composite;
  RayColor Color = Ramp;
  std::vector<double> Breaks = { 0.25, 0.5, 0.625 }; // Reference's
  RaySettings Settings;
  std::vector<std::array<double, 4>> Planes;
  std::size_t TetsInBlock = 500;
  Range Values{ 0, 1 }; // of the table
  double Unit = 1;      // of opacities
};

inline Image Render(const ReferenceMesh& mesh, const Viewer& viewer, const Setting& setting)
{
  const RayView view = viewer.GetView();
  RayLimits limits;
  for (const auto& plane : setting.Planes)
  {
    ClipByPlane(view, plane, limits);
  }
  RayCaster caster(view,
    RayTable(setting.Mode, setting.Color, setting.Values, viewer.SampleDistance, setting.Unit),
    limits, setting.Settings);
  for (const auto& block : MakeBlocks(mesh, setting.TetsInBlock))
  {
    caster.Draw({ &block, 1 });
  }
  const auto pixels = static_cast<std::size_t>(viewer.Width) * viewer.Height;
  Image image{ std::vector<float>(4 * pixels), std::vector<float>(pixels) };
  caster.Finish(image.Colors.data(), image.Depths.data());
  return image;
}

/** How far two images are apart: pixels that differ by more than 1.5 / 255, at most, and on
 * average. */
struct ImageDifference
{
  std::size_t Bad = 0;
  std::size_t BadDepths = 0;
  double Largest = 0;
  double Mean = 0;
  double Lit = 0; // how many pixels show anything
};

inline ImageDifference Compare(
  const Image& image, const std::vector<ReferencePixel>& reference, double sampleDistance)
{
  ImageDifference result;
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    double most = 0;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const double difference = std::abs(image.Colors[4 * i + c] - reference[i][c]);
      most = std::max(most, difference);
      result.Mean += difference / (4 * static_cast<double>(reference.size()));
    }
    result.Bad += most <= 1.5 / 255 ? 0 : 1;
    result.Largest = std::max(result.Largest, most);
    const auto isAt = [&](double depth)
    {
      return std::isinf(depth) ? std::isinf(image.Depths[i])
                               : std::abs(image.Depths[i] - depth) < 0.01 * sampleDistance;
    };
    result.BadDepths += isAt(reference[i][4]) || isAt(reference[i][5]) ? 0 : 1;
    result.Lit += reference[i][3] > 0.01 ? 1 : 0;
  }
  return result;
}

/** Expects that an image is as its definition says. In mode Sampled, either of two tetrahedra may
 * have a sample that is within rounding of their face; and a ray within rounding of an edge may see
 * the tetrahedron or not, whose color is then that of nothing. Returns the number of such pixels,
 * for the caller to limit. */
inline std::size_t ExpectAsDefined(const ImageDifference& difference, RayMode mode, bool withDepth)
{
  const bool sampled = mode == RayMode::Sampled;
  EXPECT_LE(difference.Mean, sampled ? 1e-5 : 0.05 / 255);
  EXPECT_LE(difference.Largest, sampled ? 1 : 1.5 / 255);
  return (sampled ? difference.Bad : 0) + (withDepth ? difference.BadDepths : 0);
}

/** Viewers all around a box from 0 to size, some within. */
inline std::vector<Viewer> MakeViewers(double size, bool parallel)
{
  std::vector<Viewer> viewers;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  const Vec middle{ size / 2, size / 2, size / 2 };
  for (int i = 0; i < 20; ++i)
  {
    Vec direction{ any(random), any(random), any(random) };
    if (i < 3)
    {
      direction = { i == 0 ? 1.0 : 0, i == 1 ? 1.0 : 0, i == 2 ? 1.0 : 0 }; // along an axis
    }
    // Every fourth from within the mesh.
    const double away = i % 4 == 3 ? 0.3 * size : 3 * size;
    viewers.push_back(Viewer::LookAt(
      middle + away * Normalize(direction), middle, parallel, i % 4 == 3 ? size / 2 : 1.9 * size));
  }
  return viewers;
}

inline float GetLargestDifference(const Image& a, const Image& b)
{
  float most = 0;
  for (std::size_t i = 0; i < a.Colors.size(); ++i)
  {
    most = std::max(most, std::abs(a.Colors[i] - b.Colors[i]));
  }
  return most;
}

//------------------------------------------------------------------------------
/** Blocks as a source, which counts those that are asked for. */
class CountingSource final : public RaySource
{
public:
  CountingSource(const ReferenceMesh& mesh, std::size_t tetsInBlock)
    : All(MakeBlocks(mesh, tetsInBlock))
  {
    for (const auto& block : this->All)
    {
      Bounds box;
      Range range;
      for (const RayPoint& p : block->Points)
      {
        const std::array<double, 3> x{ p.X, p.Y, p.Z };
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          box[axis].Min = std::min(box[axis].Min, x[axis]);
          box[axis].Max = std::max(box[axis].Max, x[axis]);
        }
        range.Min = std::min(range.Min, p.Value);
        range.Max = std::max(range.Max, p.Value);
      }
      this->Boxes.push_back(box);
      this->Ranges.push_back(range);
    }
  }

  std::size_t GetNumberOfBlocks() const override { return this->All.size(); }
  const Bounds& GetBounds(std::size_t block) const override { return this->Boxes[block]; }
  Range GetRange(std::size_t block) const override { return this->Ranges[block]; }
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress&) override
  {
    Blocks result;
    for (const auto block : blocks)
    {
      result.push_back(this->All[block]);
      ++this->Asked;
    }
    return result;
  }

  std::size_t Asked = 0;

private:
  Blocks All;
  std::vector<Bounds> Boxes;
  std::vector<Range> Ranges;
};

inline Image RenderSource(
  RaySource& source, const Viewer& viewer, const RayColor& color, float opaque)
{
  RaySettings settings;
  settings.Opaque = opaque;
  RayCaster caster(viewer.GetView(),
    RayTable(RayMode::Composite, color, { 0, 1 }, viewer.SampleDistance, 1), {}, settings);
  caster.Draw(source);
  const auto pixels = static_cast<std::size_t>(viewer.Width) * viewer.Height;
  Image image{ std::vector<float>(4 * pixels), std::vector<float>(pixels) };
  caster.Finish(image.Colors.data(), image.Depths.data());
  return image;
}
}

#endif
