// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Pieces of a mesh that are simplified apart fit together if their common points are kept.

#include "gatunMergeBuilder.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace gatun::test
{
namespace
{
using Tet = MergeTree::Tet;
using Face = std::array<std::uint32_t, 3>;

/** A mesh whose tetrahedra are dealt out to two pieces, in no simple shapes. */
struct TwoPieces
{
  std::vector<std::array<double, 3>> Points;
  std::vector<double> Values;
  std::array<std::vector<Tet>, 2> Tets;
  std::vector<std::uint8_t> IsCommon;

  TwoPieces()
  {
    const auto mesh = MakeCubes(12, 0.2);
    for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
    {
      const auto* const x = mesh.Coordinates.data() + 3 * i;
      this->Points.push_back({ x[0], x[1], x[2] });
      this->Values.push_back(std::sin(0.7 * x[0]) + 0.3 * x[1] * x[2]);
    }
    std::array<std::vector<bool>, 2> isUsed;
    isUsed.fill(std::vector<bool>(this->Points.size()));
    for (std::size_t t = 0; t < mesh.GetTets(); ++t)
    {
      Tet tet{};
      for (std::size_t i = 0; i < 4; ++i)
      {
        tet[i] = static_cast<std::uint32_t>(mesh.Ids[4 * t + i]);
      }
      const auto& x = this->Points[tet[0]];
      const std::size_t piece = x[0] + 2 * std::sin(x[1]) + std::cos(x[2]) < 6 ? 0 : 1;
      this->Tets[piece].push_back(tet);
      for (const auto point : tet)
      {
        isUsed[piece][point] = true;
      }
    }
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      this->IsCommon.push_back(isUsed[0][i] && isUsed[1][i]);
    }
  }

  /** The faces of some tetrahedra that one of them has. */
  static std::set<Face> FindBoundary(const std::vector<Tet>& tets)
  {
    std::map<Face, int> met;
    for (const Tet& tet : tets)
    {
      for (std::size_t out = 0; out < 4; ++out)
      {
        Face face{ tet[(out + 1) % 4], tet[(out + 2) % 4], tet[(out + 3) % 4] };
        std::sort(face.begin(), face.end());
        ++met[face];
      }
    }
    std::set<Face> boundary;
    for (const auto& [face, times] : met)
    {
      if (times == 1)
      {
        boundary.insert(face);
      }
    }
    return boundary;
  }

  std::vector<Face> FindFacesBetween() const
  {
    const auto one = FindBoundary(this->Tets[0]);
    const auto other = FindBoundary(this->Tets[1]);
    std::vector<Face> both;
    std::set_intersection(
      one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(both));
    return both;
  }

  /** The boundary of a piece after all merges. */
  std::set<Face> SimplifyAndFindBoundary(std::size_t piece, bool keepsCommon)
  {
    MergeInput input{ this->Points, this->Tets[piece], { { this->Values, 1 } } };
    if (keepsCommon)
    {
      input.IsKept = this->IsCommon;
    }
    const auto tree = BuildMergeTree(input);
    const auto ancestors = tree.FindAncestors(tree.GetMerges().size());
    std::vector<Tet> left;
    for (auto tet : this->Tets[piece])
    {
      if (Simplify(tet, ancestors))
      {
        left.push_back(tet);
      }
    }
    this->Left += left.size();
    return FindBoundary(left);
  }

  /** The number of faces between the pieces that one of them does not have any more. */
  std::size_t CountCracks(bool keepsCommon)
  {
    this->Left = 0;
    std::size_t cracks = 0;
    const auto between = this->FindFacesBetween();
    EXPECT_GT(between.size(), 200u);
    for (const std::size_t piece : { 0, 1 })
    {
      const auto boundary = this->SimplifyAndFindBoundary(piece, keepsCommon);
      cracks += static_cast<std::size_t>(std::count_if(between.begin(), between.end(),
        [&](const Face& face) { return boundary.count(face) == 0; }));
    }
    return cracks;
  }

  std::size_t Left = 0;
};
}

TEST(MergePieces, FitTogetherIfCommonPointsAreKept)
{
  TwoPieces pieces;
  EXPECT_GT(pieces.CountCracks(false), 100u);
  EXPECT_EQ(pieces.CountCracks(true), 0u);
  EXPECT_LT(pieces.Left, (pieces.Tets[0].size() + pieces.Tets[1].size()) / 2);
}
}
