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

/** Reads a page and links its chunks to those of their blocks that are in it. */
void ReadPage(const Bytes& bytes, std::size_t number, const MeshIndex& mesh,
  const ChunkSummaries& chunks, std::uint8_t keep)
{
  const auto page = MeshPage::Read(bytes, number, mesh, chunks.Lengths, keep);
  const auto first = mesh.Pages[number].FirstBlock;
  for (std::size_t c = 0; c < page.Chunks.size(); ++c)
  {
    const auto chunk = static_cast<std::uint32_t>(number * ChunksPerPage + c);
    ChunkEntry entry;
    for (const auto block : page.Chunks[c].Blocks)
    {
      if (block >= first && block - first < page.Blocks.size())
      {
        AddParts(page.Blocks[block - first], block, chunk, entry.Shared);
      }
    }
    for (const auto& part : entry.Shared)
    {
      entry.Info.SharedPoints += part.Points;
    }
    const auto groupOf = [&](const ChunkEntry::Part& part) -> const SharedGroup&
    { return page.Blocks[part.Block - first].Groups[part.Group]; };
    CheckGroups(entry, groupOf);
    if (entry.Info.SharedPoints < 10000 &&
      FindSharedUsers(entry, chunk, groupOf).size() != entry.Info.SharedPoints)
    {
      std::abort();
    }
  }
}

void ReadTables(fuzz::Input& in)
{
  const auto next = [&] { return test::Store(fuzz::Copy(in.TakePart())); };
  const auto meta = MetaTable::Read(next());
  CheckAgain([&] { return meta.Write(); },
    [&](const Bytes& bytes)
    {
      const auto again = MetaTable::Read(bytes);
      if (again.Arrays != meta.Arrays || again.PointArray != meta.PointArray)
      {
        std::abort();
      }
    });
  auto mesh = MeshIndex::Read(next(), meta);
  CheckAgain([&] { return mesh.Write(meta.Keep); },
    [&](const Bytes& bytes) { MeshIndex::Read(bytes, meta); });
  ChunkSummaries chunks;
  for (std::size_t page = 0; page < mesh.Pages.size(); ++page)
  {
    chunks.Add(next(), mesh, nullptr);
  }
  chunks.Finish(mesh, meta, std::uint64_t{ 1 } << 32);
  for (std::size_t page = 0; page < mesh.Pages.size(); ++page)
  {
    ReadPage(next(), page, mesh, chunks, meta.Keep);
  }
  const auto step = StepIndex::Read(next(), meta, mesh, nullptr);
  CheckAgain([&] { return step.Write(meta); },
    [&](const Bytes& bytes) { StepIndex::Read(bytes, meta, mesh, nullptr); });
  for (std::size_t page = 0; page < step.Pages.size(); ++page)
  {
    StepPage::Read(next(), page, step, meta, mesh);
  }
  const auto tree = TreeTable::Read(next(), meta, mesh.Chunks);
  CheckAgain([&] { return tree.Write(); },
    [&](const Bytes& bytes) { TreeTable::Read(bytes, meta, mesh.Chunks); });
  if (tree.FindMergeCount(tree.Merges) + 1 != tree.MergeCounts.size() && tree.Merges > 0)
  {
    std::abort();
  }
  const auto ranges = TreeStepTable::Read(next(), meta, mesh.Chunks, tree);
  CheckAgain([&] { return ranges.Write(); },
    [&](const Bytes& bytes) { TreeStepTable::Read(bytes, meta, mesh.Chunks, tree); });
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  fuzz::Accepts([&] { ReadTables(in); });
  return 0;
}
