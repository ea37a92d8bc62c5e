// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A walk over surfaces, as the specification has it.

#include "gatunTestCells.h"

#include "gatunEntropy.h"
#include "gatunError.h"
#include "gatunNumberModel.h"

#include <gtest/gtest.h>

#include <array>

using namespace gatun;
using namespace gatun::test;

TEST(SurfaceStream, DecodesAStreamWrittenByHand)
{
  // Two triangles as section 9 of the specification has them. The angles are different everywhere.
  TestCells mesh;
  mesh.AddPoint(0, 0, 0);
  mesh.AddPoint(4, 0, 0);
  mesh.AddPoint(1, 2, 0);
  mesh.AddPoint(2, -2, 0);
  mesh.Add(5, { 0, 1, 2 });
  mesh.Add(5, { 0, 1, 3 });
  const auto chunk = MakeCellCase(mesh);
  const auto geometry = EncodeCells(chunk.Frame, chunk.Cells, {}, chunk.OwnKeys, false).Geometry;
  const auto decode = [&](unsigned turn, unsigned type)
  {
    EntropyEncoder coder;
    BitModel more, triangle, isNew, isShared;
    BitTree<8> types;
    BitTree<3> turns;
    coder.Bit(more, true);
    coder.Bit(triangle, true);
    for (int corner = 0; corner < 3; ++corner)
    {
      coder.Bit(isNew, true);
      coder.Bit(isShared, false);
    }
    types.Code(coder, 5);
    turns.Code(coder, 0); // the polygon's corners in order
    // The gate is the first side, against its direction: from corner 1 to corner 0.
    std::array<BitModel, 6> others;
    coder.Bit(others[0], false); // no border
    coder.Bit(others[1], true);  // a triangle
    coder.Bit(others[2], false); // not the next vertex along the front
    coder.Bit(others[3], false); // nor the last one
    coder.Bit(others[4], true);  // a new one
    coder.Bit(others[5], false); // of its own
    types.Code(coder, type);
    BitTree<3>().Code(coder, turn);
    Bytes stream{ 4 };
    const auto rest = coder.Finish();
    stream.insert(stream.end(), rest.begin(), rest.end());
    const auto decoded = DecodeCells(chunk.Frame, {}, stream, geometry);
    EXPECT_EQ(decoded.Walk.Parents, (Ids{ Topology::NoTet, 0 }));
    const auto corners = decoded.Cells.GetCorners(1);
    return Ids{ corners.begin(), corners.end() };
  };
  EXPECT_EQ(decode(0, 5), (Ids{ 1, 0, 3 }));
  EXPECT_EQ(decode(2, 5), (Ids{ 0, 3, 1 }));
  EXPECT_EQ(decode(3, 5), (Ids{ 0, 1, 3 }));
  EXPECT_EQ(decode(5, 7), (Ids{ 3, 0, 1 }));
  EXPECT_THROW(decode(6, 5), Error); // no such turn
  EXPECT_THROW(decode(0, 9), Error); // no quadrilateral
}
