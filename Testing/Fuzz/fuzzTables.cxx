// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The tables of a file, written without compression: META, then TABL, STEP, TREE, TRNG.

#include "fuzzInput.h"
#include "gatunFileImage.h"
#include "gatunTreeTable.h"

#include <cstdlib>

namespace
{
using namespace gatun;

/** A table that was read must be read again from what it writes. */
template <typename Write, typename Read>
void CheckAgain(Write&& write, Read&& read)
{
  const auto once = write();
  if (!fuzz::Accepts([&] { read(once); }))
  {
    std::abort();
  }
}

void ReadTables(fuzz::Input& in)
{
  const auto next = [&] { return test::Store(fuzz::Copy(in.TakePart())); };
  const auto meta = MetaTable::Read(next());
  CheckAgain([&] { return meta.Write(); }, [](const Bytes& bytes) { MetaTable::Read(bytes); });
  const auto mesh = MeshTable::Read(next(), meta);
  CheckAgain([&] { return mesh.Write(meta.Keep); },
    [&](const Bytes& bytes) { MeshTable::Read(bytes, meta); });
  for (std::size_t chunk = 0; chunk < mesh.Chunks.size(); ++chunk)
  {
    if (mesh.Chunks[chunk].Info.SharedPoints < 10000 &&
      mesh.GetSharedUsers(chunk).size() != mesh.Chunks[chunk].Info.SharedPoints)
    {
      std::abort();
    }
  }
  const auto step = StepTable::Read(next(), meta, mesh);
  CheckAgain(
    [&] { return step.Write(); }, [&](const Bytes& bytes) { StepTable::Read(bytes, meta, mesh); });
  const auto tree = TreeTable::Read(next(), meta, mesh);
  CheckAgain(
    [&] { return tree.Write(); }, [&](const Bytes& bytes) { TreeTable::Read(bytes, meta, mesh); });
  if (tree.FindRung(tree.Merges) + 1 != tree.Rungs.size() && tree.Merges > 0)
  {
    std::abort();
  }
  const auto ranges = TreeStepTable::Read(next(), meta, mesh, tree);
  CheckAgain([&] { return ranges.Write(); },
    [&](const Bytes& bytes) { TreeStepTable::Read(bytes, meta, mesh, tree); });
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  fuzz::Accepts([&] { ReadTables(in); });
  return 0;
}
