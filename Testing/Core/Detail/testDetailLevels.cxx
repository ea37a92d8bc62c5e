// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Meshes that are simplified for a view, from a file with base meshes and from memory.

#include "gatunError.h"
#include "gatunFileLevelsOfDetail.h"
#include "gatunMemoryLevelsOfDetail.h"
#include "gatunMergeBuilder.h"
#include "gatunRayImages.h"
#include "gatunTestFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace gatun::test
{
namespace
{
using Vec = std::array<double, 3>;
using Corners = std::array<Vec, 4>;

constexpr std::int64_t Side = 16;
constexpr std::uint64_t PlentyForDetail = std::uint64_t{ 1 } << 30;

/** Where levels come from. */
enum class Origin
{
  Memory,
  File,
  FileWithBases
};

double GetVolume(const Corners& p)
{
  std::array<Vec, 3> u{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      u[i][c] = p[i + 1][c] - p[0][c];
    }
  }
  return std::abs(u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) +
           u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
           u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0])) /
    6;
}

bool Contains(const Corners& tet, const Vec& place)
{
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    Corners part = tet;
    part[i] = place;
    sum += GetVolume(part);
  }
  return sum <= GetVolume(tet) * (1 + 1e-9);
}

Vec GetCenter(const Corners& tet)
{
  Vec center{};
  for (const Vec& corner : tet)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      center[c] += corner[c] / 4;
    }
  }
  return center;
}

/** What a view shows at most. */
RayView LookFrom(const Vec& eye, bool isParallel = false)
{
  RayFrustum frustum;
  frustum.Parallel = isParallel;
  frustum.Near = 0.01;
  frustum.Far = 1000;
  const double wide = isParallel ? 100 : 3;
  frustum.Left = frustum.Bottom = -wide;
  frustum.Right = frustum.Top = wide;
  return { { { { 1, 0, 0, -eye[0] }, { 0, 1, 0, -eye[1] }, { 0, 0, 1, -eye[2] } } }, frustum, 500,
    500, 0.1 };
}

std::shared_ptr<const DetailView> MakeView(const RayView& view, double pixelError = 0)
{
  return std::make_shared<const DetailView>(DetailView{ view, pixelError, nullptr });
}

/** A cube with flat sides. */
TestMesh MakeBox()
{
  auto mesh = MakeCubes(Side, 0.2);
  for (double& x : mesh.Coordinates)
  {
    const double place = std::round(x);
    x = place == 0 || place == static_cast<double>(Side) ? place : x;
  }
  return mesh;
}

class DetailLevels : public testing::TestWithParam<Origin>
{
protected:
  DetailLevels()
    : Mesh(MakeBox())
    , Reference(ToReference(this->Mesh))
    , Tree(BuildMergeTree(
        { this->Reference.Points, this->Reference.Tets, { { this->Reference.Values, 1 } } }))
  {
    if (GetParam() == Origin::Memory)
    {
      const RayValuesInput values{ Association::Point, ScalarType::Float64, 1, 0,
        this->Reference.Values.data() };
      this->Levels = std::make_unique<MemoryLevelsOfDetail>(
        std::make_shared<const MemoryRayMesh>(this->Mesh.GetInput(), values, nullptr), this->Tree,
        PlentyForDetail);
      return;
    }
    std::vector<ArrayDescription> arrays(1);
    arrays[0].Type = ScalarType::Float64;
    WriterOptions options;
    options.ChunkSize = 500;
    options.Tree = &this->Tree;
    options.Levels = GetParam() == Origin::File ? 0 : 5;
    const auto path = TempPath(GetParam() == Origin::File ? "detail.gtn" : "bases.gtn");
    FileWriter writer(path, this->Mesh.GetInput(), arrays, options);
    const void* const values = this->Reference.Values.data();
    writer.WriteStep({ &values, 1 });
    writer.Finish();
    this->File = std::make_shared<const FileReader>(path);
    this->Levels = std::make_unique<FileLevelsOfDetail>(
      std::make_shared<SharedFile>(this->File, PlentyForDetail), RayValues{});
  }

  std::uint64_t GetPoints() const { return this->Reference.Points.size(); }

  DetailLevel Make(std::uint64_t points, std::shared_ptr<const DetailView> view)
  {
    return this->Levels->MakeLevel({ points, std::move(view) }, {});
  }

  static std::vector<std::shared_ptr<const RayBlock>> GetBlocks(RaySource& source)
  {
    std::vector<std::size_t> all(source.GetNumberOfBlocks());
    std::iota(all.begin(), all.end(), std::size_t{ 0 });
    return source.GetBlocks(all, {});
  }

  static std::vector<Corners> GetTets(RaySource& source)
  {
    std::vector<Corners> tets;
    const auto blocks = GetBlocks(source);
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      const Bounds& box = source.GetBounds(b);
      const Range range = source.GetRange(b);
      for (const auto& tet : blocks[b]->Tets)
      {
        Corners& corners = tets.emplace_back();
        for (std::size_t i = 0; i < 4; ++i)
        {
          const RayPoint& p = blocks[b]->Points[tet[i]];
          corners[i] = { p.X, p.Y, p.Z };
          EXPECT_TRUE(range.Min <= p.Value && p.Value <= range.Max);
          for (std::size_t c = 0; c < 3; ++c)
          {
            EXPECT_TRUE(box[c].Min <= corners[i][c] && corners[i][c] <= box[c].Max);
          }
        }
        std::sort(corners.begin(), corners.end());
      }
    }
    std::sort(tets.begin(), tets.end());
    return tets;
  }

  /** Whether tetrahedra fill the cube but for what its edges lose, no place twice: each of their
   * faces belongs to two of them, or has its corners on the sides of the cube. */
  static void ExpectToFill(const std::vector<Corners>& tets)
  {
    const auto side = static_cast<double>(Side);
    const auto isOutside = [&](const Vec& p)
    { return std::any_of(p.begin(), p.end(), [&](double x) { return x == 0 || x == side; }); };
    std::map<std::array<Vec, 3>, int> faces;
    double volume = 0;
    for (const Corners& tet : tets)
    {
      volume += GetVolume(tet);
      for (std::size_t i = 0; i < 4; ++i)
      {
        ++faces[{ tet[i == 0 ? 1 : 0], tet[i <= 1 ? 2 : 1], tet[i <= 2 ? 3 : 2] }];
      }
    }
    EXPECT_GT(volume, 0.95 * side * side * side);
    for (const auto& [face, count] : faces)
    {
      EXPECT_TRUE(count == 2 || (count == 1 && std::all_of(face.begin(), face.end(), isOutside)));
    }
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(0, side);
    for (int i = 0; i < 300; ++i)
    {
      const Vec place{ any(random), any(random), any(random) };
      EXPECT_LE(std::count_if(
                  tets.begin(), tets.end(), [&](const auto& tet) { return Contains(tet, place); }),
        1);
    }
  }

  TestMesh Mesh;
  ReferenceMesh Reference;
  MergeTree Tree;
  std::shared_ptr<const FileReader> File;
  std::unique_ptr<LevelsOfDetail> Levels;
};

/** Blocks in memory are cut anew for each view. */
class DetailLevelsOfFiles : public DetailLevels
{
};

class DetailLevelsOfBases : public DetailLevels
{
};

constexpr double S = Side;

TEST_P(DetailLevels, FillTheMeshFromEverywhere)
{
  for (const Vec& eye :
    { Vec{ S / 2, S / 2, S + 1 }, Vec{ S, S, S }, Vec{ 4, 4, 8 }, Vec{ 3 * S, S / 2, 2 * S } })
  {
    for (const auto points : { this->GetPoints() / 3, this->GetPoints() / 20 })
    {
      const auto level = this->Make(points, MakeView(LookFrom(eye)));
      const auto tets = GetTets(*level.Source);
      ExpectToFill(tets);
      // About as many as wanted, as merges are done with all that they need or not at all.
      EXPECT_GE(level.Points, points / 2);
      EXPECT_LE(level.Points, 2 * points);
      std::set<Vec> corners;
      for (const Corners& tet : tets)
      {
        corners.insert(tet.begin(), tet.end());
      }
      EXPECT_EQ(corners.size(), level.Points);
    }
  }
}

TEST_P(DetailLevels, AreFineNearTheEye)
{
  const Vec eye{ S / 2, S / 2, S + 1 };
  const auto level = this->Make(this->GetPoints() / 8, MakeView(LookFrom(eye)));
  // Mean volumes of tetrahedra that are near, and of those at the far side.
  std::array<double, 2> volumes{};
  std::array<double, 2> counts{};
  for (const Corners& tet : GetTets(*level.Source))
  {
    const Vec center = GetCenter(tet);
    const double depth = eye[2] - center[2];
    if (std::hypot(center[0] - eye[0], center[1] - eye[1]) < 4 && (depth < 4 || depth > 12))
    {
      const std::size_t where = depth > 12 ? 1 : 0;
      volumes[where] += GetVolume(tet);
      counts[where] += 1;
    }
  }
  EXPECT_GT(volumes[1] / counts[1], 2 * volumes[0] / counts[0]);
}

TEST_P(DetailLevels, AreUniformWhereAllIsAsNear)
{
  // In a parallel projection each place counts alike.
  const auto view = MakeView(LookFrom({ 0, 0, 2 * S }, true));
  for (const auto points : { this->GetPoints() / 2, this->GetPoints() / 7 })
  {
    const auto level = this->Make(points, view);
    // Of merges with the same error, all are done.
    EXPECT_LE(level.Points, points);
    EXPECT_GT(level.Points, points - points / 50);
    const auto uniform = this->Make(level.Points, nullptr);
    EXPECT_TRUE(GetTets(*level.Source) == GetTets(*uniform.Source));
  }
}

TEST_P(DetailLevels, HaveAtMostThePixelErrorOfTheView)
{
  const auto everywhere = LookFrom({ 0, 0, 2 * S }, true);
  // The size of the cube in pixels.
  const double pixels = S * std::sqrt(3) * 500 / 200;
  for (const double part : { 0.1, 0.5, 0.9 })
  {
    const auto merges =
      static_cast<std::size_t>(part * static_cast<double>(this->Tree.GetMerges().size()));
    const double error = this->Tree.GetLargestError(merges);
    const auto level =
      this->Make(this->GetPoints(), MakeView(everywhere, error * pixels * (1 + 1e-6)));
    EXPECT_EQ(level.Points, this->GetPoints() - this->Tree.CountMergesForError(error));
  }
  // All merges, where nothing may be seen of the errors.
  const auto coarsest = this->Make(this->GetPoints(), MakeView(everywhere, 1e6));
  EXPECT_EQ(coarsest.Points, this->Levels->GetFewestPoints());
  // Without an error, and with one that is none, nothing is merged.
  for (const double none : { 0.0, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_EQ(this->Make(this->GetPoints(), MakeView(everywhere, none)).Points, this->GetPoints());
  }
}

TEST_P(DetailLevels, DoNotDependOnTheViewsBefore)
{
  const auto points = this->GetPoints() / 6;
  const auto get = [&](double x) {
    return GetTets(*this->Make(points, MakeView(LookFrom({ x, S / 3, S + 2 }))).Source);
  };
  const auto before = get(2);
  EXPECT_TRUE(get(14) != before);
  EXPECT_TRUE(get(9) != before);
  EXPECT_TRUE(get(2) == before);
}

TEST_P(DetailLevelsOfFiles, TakeTheBlocksThatStay)
{
  const auto points = this->GetPoints() / 4;
  const auto first = this->Make(points, MakeView(LookFrom({ S / 2, S / 2, S + 2 })));
  const auto before = GetBlocks(*first.Source);
  const auto second = this->Make(points, MakeView(LookFrom({ S / 2 + 0.5, S / 2, S + 2 })));
  const auto after = GetBlocks(*second.Source);
  const std::set<std::shared_ptr<const RayBlock>> known(before.begin(), before.end());
  const auto same = std::count_if(
    after.begin(), after.end(), [&](const auto& block) { return known.contains(block); });
  EXPECT_GT(same, 0);
  EXPECT_LT(static_cast<std::size_t>(same), after.size());
}

TEST_P(DetailLevelsOfBases, ReadWhatTheViewNeeds)
{
  const auto whole = std::make_shared<const FileReader>(this->File->GetPath());
  FileLevelsOfDetail all(std::make_shared<SharedFile>(whole), {});
  GetTets(*all.MakeLevel({ this->GetPoints(), {} }, {}).Source);
  const auto before = this->File->GetBytesRead();
  GetTets(*this->Make(this->GetPoints() / 30, MakeView(LookFrom({ 2, 2, S + 1 }))).Source);
  EXPECT_LT(this->File->GetBytesRead() - before, whole->GetBytesRead() / 2);
}

TEST_P(DetailLevels, StopWhenTheyMust)
{
  int calls = 0;
  const auto stop = [&](double)
  {
    ++calls;
    return false;
  };
  const DetailRequest request{ this->GetPoints() / 10, MakeView(LookFrom({ 0, 0, 2 * S })) };
  try
  {
    this->Levels->MakeLevel(request, stop);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Aborted);
    EXPECT_EQ(calls, 1);
  }
  ExpectToFill(GetTets(*this->Levels->MakeLevel(request, {}).Source));
}

std::string GetName(const testing::TestParamInfo<Origin>& origin)
{
  switch (origin.param)
  {
    case Origin::Memory:
      return "Memory";
    case Origin::File:
      return "File";
    default:
      return "FileWithBases";
  }
}

INSTANTIATE_TEST_SUITE_P(Origins, DetailLevels,
  testing::Values(Origin::Memory, Origin::File, Origin::FileWithBases), GetName);
INSTANTIATE_TEST_SUITE_P(
  Origins, DetailLevelsOfFiles, testing::Values(Origin::File, Origin::FileWithBases), GetName);
INSTANTIATE_TEST_SUITE_P(
  Origins, DetailLevelsOfBases, testing::Values(Origin::FileWithBases), GetName);
}
}
