// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunStepTables.h"

#include "gatunPageSection.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
void StepTables::Add(const StepTable& step, const MetaTable& meta, const MeshIndex& mesh)
{
  Entry entry;
  entry.Index = WriteStepPages(step, meta, mesh,
    [&](const Bytes& page)
    {
      entry.Pages.push_back(page);
      this->Size += page.size();
      return StreamRef(); // until it is written
    });
  for (const auto& array : entry.Index.Arrays)
  {
    this->Size += sizeof(array) + array.Ranges.size() * sizeof(Range) +
      array.Palettes.size() * sizeof(array.Palettes.front());
  }
  this->Size += sizeof(Entry);
  this->Entries.push_back(std::move(entry));
}

//------------------------------------------------------------------------------
void StepTables::AddMerged(Bytes ranges, std::size_t stepsAfter)
{
  this->Size += ranges.size();
  this->Entries[this->Entries.size() - 1 - stepsAfter].Merged = std::move(ranges);
}

//------------------------------------------------------------------------------
void StepTables::Write(OutputFile& file, const MetaTable& meta)
{
  // What is read when a file is opened comes last, next to the other tables.
  PageSection pages(file);
  for (auto& [index, bytes, merged] : this->Entries)
  {
    for (std::size_t p = 0; p < bytes.size(); ++p)
    {
      index.Pages[p] = pages.Put(bytes[p]);
    }
  }
  pages.Write();
  for (const auto& entry : this->Entries)
  {
    file.AddSection(SectionStep, entry.Index.Write(meta));
  }
  for (const auto& entry : this->Entries)
  {
    if (!entry.Merged.empty())
    {
      file.AddSection(SectionTreeStep, entry.Merged, 0);
    }
  }
  this->Entries.clear();
  this->Size = 0;
}
}
