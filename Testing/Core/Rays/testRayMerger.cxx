// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Images of several casters, each with a random part of the cells, against that of one with all.

#include "gatunError.h"
#include "gatunRayImages.h"
#include "gatunRayMerger.h"
#include "gatunRayShare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace gatun::test
{
namespace
{
/** Deals the tetrahedra of a mesh out at random; the last part stays empty. */
std::vector<ReferenceMesh> Deal(const ReferenceMesh& mesh, std::size_t parts)
{
  std::vector<ReferenceMesh> result(parts + 1);
  std::mt19937 random(5);
  for (ReferenceMesh& part : result)
  {
    part.Points = mesh.Points;
    part.Values = mesh.Values;
  }
  for (const auto& tet : mesh.Tets)
  {
    result[random() % parts].Tets.push_back(tet);
  }
  return result;
}

struct Scene
{
  RayView View;
  RayTable Table;
  RayLimits Limits;
  RaySettings Settings;

  Scene(const Viewer& viewer, const Setting& setting)
    : View(viewer.GetView())
    , Table(setting.Mode, setting.Color, setting.Values, viewer.SampleDistance, setting.Unit)
    , Settings(setting.Settings)
  {
    for (const auto& plane : setting.Planes)
    {
      ClipByPlane(this->View, plane, this->Limits);
    }
  }

  std::unique_ptr<RayCaster> Cast(const ReferenceMesh& mesh) const
  {
    auto caster =
      std::make_unique<RayCaster>(this->View, this->Table, this->Limits, this->Settings);
    for (const auto& block : MakeBlocks(mesh, 100))
    {
      caster->Draw({ &block, 1 });
    }
    return caster;
  }
};

/** As several processes do it: each owns some tiles, and gets their fragments from all. */
Image Merge(const Scene& scene, const std::vector<ReferenceMesh>& parts)
{
  std::vector<std::unique_ptr<RayCaster>> casters;
  for (const auto& part : parts)
  {
    casters.push_back(scene.Cast(part));
  }
  const auto pixels =
    static_cast<std::size_t>(scene.View.Width) * static_cast<std::size_t>(scene.View.Height);
  Image image{ std::vector<float>(4 * pixels, -1), std::vector<float>(pixels, -1) };
  for (std::size_t owner = 0; owner < parts.size(); ++owner)
  {
    RayMerger merger(scene.View, scene.Table);
    std::vector<std::size_t> tiles;
    for (std::size_t tile = owner; tile < merger.GetNumberOfTiles(); tile += parts.size())
    {
      tiles.push_back(tile);
    }
    for (const auto& caster : casters)
    {
      merger.Add(caster->TakeFragments(tiles, true));
    }
    merger.Finish(tiles, image.Colors.data(), image.Depths.data());
  }
  return image;
}

Image CastWhole(const Scene& scene, const ReferenceMesh& mesh)
{
  const auto pixels =
    static_cast<std::size_t>(scene.View.Width) * static_cast<std::size_t>(scene.View.Height);
  Image image{ std::vector<float>(4 * pixels), std::vector<float>(pixels) };
  scene.Cast(mesh)->Finish(image.Colors.data(), image.Depths.data());
  return image;
}

class InEachMode : public testing::TestWithParam<RayMode>
{
};

TEST_P(InEachMode, PartsOfCellsGiveTheImageOfAll)
{
  const auto mesh = ToReference(MakeCubes(5, 0.25));
  Setting setting;
  setting.Mode = GetParam();
  setting.Planes = { { 1, 0.3, 0, -1.1 } };
  setting.Settings.Opaque = 0;
  auto viewers = MakeViewers(5, false);
  viewers.resize(5, viewers.front());
  for (const auto& viewer : viewers)
  {
    const Scene scene(viewer, setting);
    const Image whole = CastWhole(scene, mesh);
    for (const std::size_t parts : { 1u, 2u, 4u })
    {
      const Image merged = Merge(scene, Deal(mesh, parts));
      // A caster integrates thick segments in one piece or in several, as their neighbors need it.
      EXPECT_LE(GetLargestDifference(whole, merged),
        setting.Mode == RayMode::Composite ? 0.5f / 255 : 2e-5f);
      std::size_t otherDepths = 0;
      for (std::size_t i = 0; i < whole.Depths.size(); ++i)
      {
        const bool same = std::isinf(whole.Depths[i])
          ? std::isinf(merged.Depths[i])
          : std::abs(whole.Depths[i] - merged.Depths[i]) < 1e-4f;
        otherDepths += same ? 0 : 1;
      }
      // Where the first that is seen is next to nothing, a sum may round to nothing.
      EXPECT_LE(otherDepths, whole.Depths.size() / 1000);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rays, InEachMode,
  testing::Values(RayMode::Composite, RayMode::Sampled, RayMode::Maximum, RayMode::XRay));

TEST(RayMerger, EarlyTerminationKeepsTheImage)
{
  const auto mesh = ToReference(MakeCubes(5, 0.25));
  Setting setting;
  setting.Color = Bands;
  const Scene scene(MakeViewers(5, true)[4], setting);
  const Image merged = Merge(scene, Deal(mesh, 3));
  // What one caster leaves out behind opaque segments, another may add: as much as is transparent.
  EXPECT_LE(GetLargestDifference(CastWhole(scene, mesh), merged), 1e-3f + 0.5f / 255);
}

TEST(RayMerger, WithoutFragmentsThereIsNothing)
{
  Setting setting;
  for (const auto mode : { RayMode::Composite, RayMode::Sampled, RayMode::Maximum, RayMode::XRay })
  {
    setting.Mode = mode;
    const Scene scene(MakeViewers(5, false)[4], setting);
    const Image image = Merge(scene, std::vector<ReferenceMesh>(2));
    EXPECT_EQ(std::count(image.Colors.begin(), image.Colors.end(), 0.0f),
      static_cast<std::ptrdiff_t>(image.Colors.size()));
    EXPECT_TRUE(std::all_of(
      image.Depths.begin(), image.Depths.end(), [](float depth) { return std::isinf(depth); }));
  }
}

TEST(RayMerger, RejectsOtherBytes)
{
  const auto mesh = ToReference(MakeCubes(2, 0.25));
  std::mt19937 random(11);
  for (const auto mode : { RayMode::Composite, RayMode::Maximum, RayMode::XRay })
  {
    Setting setting;
    setting.Mode = mode;
    Viewer viewer = MakeViewers(2, false)[4];
    const Scene scene(viewer, setting);
    const auto caster = scene.Cast(mesh);
    std::vector<std::size_t> tiles(caster->GetNumberOfTiles());
    std::iota(tiles.begin(), tiles.end(), std::size_t{ 0 });
    const auto message = caster->TakeFragments(tiles);
    ASSERT_FALSE(message.empty());
    const auto pixels =
      static_cast<std::size_t>(viewer.Width) * static_cast<std::size_t>(viewer.Height);
    std::vector<float> image(4 * pixels);
    const auto tryOut = [&](const std::vector<std::uint8_t>& bytes)
    {
      try
      {
        RayMerger merger(scene.View, scene.Table);
        merger.Add(bytes);
        merger.Finish(tiles, image.data());
        return true;
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::Corrupt);
        return false;
      }
    };
    EXPECT_TRUE(tryOut(message));
    for (std::size_t i = 0; i < 200; ++i)
    {
      auto damaged = message;
      damaged.resize(1 + random() % (message.size() - 1));
      tryOut(damaged);
      damaged = message;
      damaged[random() % message.size()] ^= static_cast<std::uint8_t>(1 + random() % 255);
      tryOut(damaged);
    }
    auto shorter = message;
    shorter.pop_back();
    EXPECT_FALSE(tryOut(shorter));
    auto longer = message;
    longer.push_back(0);
    EXPECT_FALSE(tryOut(longer));
  }
}

TEST(RayShare, EachBlockIsInOneShare)
{
  const auto mesh = ToReference(MakeCubes(3, 0));
  const auto all = std::make_shared<CountingSource>(mesh, 25);
  const auto count = all->GetNumberOfBlocks();
  std::set<const RayBlock*> drawn;
  std::size_t blocks = 0;
  for (std::size_t process = 0; process < 4; ++process)
  {
    RayShare share(all, process, 4);
    const auto number = share.GetNumberOfBlocks();
    EXPECT_LE(number, count / 4 + 1);
    std::vector<std::size_t> wanted(number);
    std::iota(wanted.begin(), wanted.end(), std::size_t{ 0 });
    for (const auto& block : share.GetBlocks(wanted, {}))
    {
      drawn.insert(block.get());
      ++blocks;
    }
  }
  EXPECT_EQ(blocks, count);
  EXPECT_EQ(drawn.size(), count);
  EXPECT_EQ(RayShare(all, count + 1, count + 2).GetNumberOfBlocks(), 0u);
}
}
}
