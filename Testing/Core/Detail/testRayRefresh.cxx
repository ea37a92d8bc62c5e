// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Of an image, only tiles that another number of points changes are drawn anew, and nobody can
// tell.

#include "gatunError.h"
#include "gatunMemoryLevelsOfDetail.h"
#include "gatunRayImages.h"
#include "gatunRayRefresh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace gatun::test
{
namespace
{
constexpr std::uint64_t PlentyForRefresh = std::uint64_t{ 1 } << 30;

/** A mesh that is simplified, as one looks at it. */
class Subject
{
public:
  Subject(std::int64_t n, const Viewer& viewer, RayMode mode, float opaque)
    : Onlooker(viewer)
    , Mode(mode)
  {
    const TestMesh mesh = MakeCubes(n, 0.2);
    const ReferenceMesh reference = ToReference(mesh);
    const auto copy = std::make_shared<const MemoryRayMesh>(mesh.GetInput(),
      RayValuesInput{ Association::Point, ScalarType::Float64, 1, 0, reference.Values.data() },
      nullptr);
    this->Detail =
      std::make_unique<MemoryLevelsOfDetail>(copy, copy->BuildTree(), PlentyForRefresh);
    this->Settings.Repeatable = true;
    this->Settings.Opaque = opaque;
  }

  std::uint64_t GetPoints() const { return this->Detail->GetNumberOfPoints(); }
  std::shared_ptr<RaySource> MakeSource(std::uint64_t points) const
  {
    return this->Detail->MakeLevel({ points, {} }, {}).Source;
  }
  std::unique_ptr<RayCaster> MakeCaster() const
  {
    return std::make_unique<RayCaster>(this->Onlooker.GetView(),
      RayTable(this->Mode, Ramp, { 0, 1 }, this->Onlooker.SampleDistance, 1), RayLimits{},
      this->Settings);
  }
  std::vector<float> MakeBlank() const
  {
    return std::vector<float>(4u * this->Onlooker.Width * this->Onlooker.Height, -1.0f);
  }
  std::vector<float> Draw(std::uint64_t points) const
  {
    auto image = this->MakeBlank();
    const auto caster = this->MakeCaster();
    caster->Draw(*this->MakeSource(points));
    caster->Finish(image.data());
    return image;
  }

private:
  Viewer Onlooker;
  RayMode Mode;
  RaySettings Settings;
  std::unique_ptr<MemoryLevelsOfDetail> Detail;
};

//------------------------------------------------------------------------------
TEST(RayRefresh, TheImageIsThatFromScratch)
{
  double drawn = 0;
  double all = 0;
  for (const RayMode mode :
    { RayMode::Composite, RayMode::Sampled, RayMode::Maximum, RayMode::XRay })
  {
    for (const float opaque : { 0.0f, 0.3f })
    {
      for (const bool parallel : { false, true })
      {
        for (const int view : { 4, 7 }) // from without and from within
        {
          const Subject subject(
            10, MakeViewers(10, parallel)[static_cast<std::size_t>(view)], mode, opaque);
          const auto points = subject.GetPoints();
          RayRefresh refresh([&] { return subject.MakeCaster(); });
          auto image = subject.MakeBlank();
          // Far apart, and one by one, up and down; and the same again.
          for (const std::uint64_t n : { points, points - 1, points - 2, points - 9, points - 40,
                 points / 2, points / 2 + 3, points / 9, points / 9, points / 9 + 1, points })
          {
            drawn += refresh.Draw(subject.MakeSource(n), image.data());
            ++all;
            EXPECT_EQ(image, subject.Draw(n)) << n;
          }
        }
      }
    }
  }
  EXPECT_LT(drawn, all);
  EXPECT_GT(drawn, all / 20);
  RecordProperty("partDrawn", std::to_string(drawn / all));
}

//------------------------------------------------------------------------------
TEST(RayRefresh, NothingIsDrawnWhereNothingChanges)
{
  const Subject subject(8, MakeViewers(8, false)[4], RayMode::Composite, 1e-3f);
  RayRefresh refresh([&] { return subject.MakeCaster(); });
  auto image = subject.MakeBlank();
  const auto source = subject.MakeSource(300);
  EXPECT_EQ(refresh.Draw(source, image.data()), 1);
  const auto before = image;
  EXPECT_EQ(refresh.Draw(subject.MakeSource(300), image.data()), 0);
  EXPECT_EQ(image, before);
}

//------------------------------------------------------------------------------
TEST(RayRefresh, AfterAImageThatWasStoppedAllIsDrawn)
{
  const Subject subject(8, MakeViewers(8, false)[4], RayMode::Composite, 1e-3f);
  RayRefresh refresh([&] { return subject.MakeCaster(); });
  auto image = subject.MakeBlank();
  refresh.Draw(subject.MakeSource(300), image.data());
  EXPECT_THROW(
    refresh.Draw(subject.MakeSource(200), image.data(), [](double) { return false; }), Error);
  EXPECT_EQ(refresh.Draw(subject.MakeSource(300), image.data()), 1);
}

//------------------------------------------------------------------------------
TEST(RayRefresh, TilesDoNotDependOnOthers)
{
  // Each tile alone is what it is in the whole image.
  for (const float opaque : { 0.0f, 0.5f })
  {
    const Subject subject(12, MakeViewers(12, false)[3], RayMode::Composite, opaque);
    const auto whole = subject.Draw(subject.GetPoints());
    const auto tiles = subject.MakeCaster()->GetNumberOfTiles();
    auto image = subject.MakeBlank();
    for (std::size_t tile = 0; tile < tiles; ++tile)
    {
      std::vector<std::uint8_t> only(tiles, 0);
      only[tile] = 1;
      const auto caster = subject.MakeCaster();
      caster->Restrict(only);
      caster->Draw(*subject.MakeSource(subject.GetPoints()));
      caster->Finish(image.data());
    }
    EXPECT_EQ(image, whole);
  }
}

//------------------------------------------------------------------------------
TEST(RayRefresh, TilesDoNotDependOnOthersWhereBlocksAreSetUpBitByBit)
{
  // Tetrahedra that are in many tiles each, more than are set up at once.
  Viewer viewer = MakeViewers(12, false)[3];
  viewer.Width = viewer.Height = 480;
  const Subject subject(12, viewer, RayMode::Composite, 0.5f);
  const auto source = subject.MakeSource(subject.GetPoints());
  const auto whole = subject.Draw(subject.GetPoints());
  const auto tiles = subject.MakeCaster()->GetNumberOfTiles();
  auto image = subject.MakeBlank();
  for (std::size_t part = 0; part < 5; ++part)
  {
    std::vector<std::uint8_t> some(tiles, 0);
    for (std::size_t tile = part; tile < tiles; tile += 5)
    {
      some[tile] = 1;
    }
    const auto caster = subject.MakeCaster();
    caster->Restrict(some);
    caster->Draw(*source);
    caster->Finish(image.data());
  }
  EXPECT_EQ(image, whole);
}
}
}
