// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A chunk of cells of any type from any shapes, counts, box, shared points and streams, in both
// profiles.

#include "fuzzMeshes.h"
#include "gatunCellCodec.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  fuzz::Input in(data, size);
  auto frame = fuzz::TakeFrame(in, 400);
  frame.Cells = { frame.Tets, in.Take<std::uint16_t>(), in.Take<std::uint16_t>() };
  frame.Tets = 0;
  const auto table = fuzz::Copy(in.TakePart());
  const auto connectivity = fuzz::Copy(in.TakePart());
  const auto geometry = fuzz::Copy(in.TakePart());
  const auto corners = fuzz::Copy(in.TakeRest());
  fuzz::Accepts(
    [&]
    {
      const auto shapes = ShapeTable::Read(table);
      auto mesh = DecodeCells(frame, shapes, connectivity, geometry);
      fuzz::CheckCells(frame, mesh);
      ArrayContext(mesh, fuzz::GetFits(mesh));
      RestoreCorners(mesh.Cells, corners);
      fuzz::CheckCells(frame, mesh);
      fuzz::CheckTets(mesh);
    });
  return 0;
}
