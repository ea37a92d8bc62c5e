// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPageSection_h
#define gatunPageSection_h

#include "gatunBytes.h"
#include "gatunContainer.h"
#include "gatunOutputFile.h"

#include <cstddef>

namespace gatun
{
/** Writes pages of tables into sections of limited size. Nothing else may be added to the file
 * before Write. */
class PageSection
{
public:
  explicit PageSection(OutputFile& file)
    : File(file)
  {
  }

  /** Adds a page. Returns where it will be. */
  StreamRef Put(const Bytes& page)
  {
    if (this->Payload.Data.size() >= MostBytes)
    {
      this->Write();
    }
    const auto begin = this->File.GetSize() + SectionHeaderSize;
    const StreamRef where{ begin + this->Payload.Data.size(), page.size(), Checksum(page) };
    this->Payload.PutBytes(page);
    return where;
  }

  /** Writes the pages that have been added, if any. */
  void Write()
  {
    if (!this->Payload.Data.empty())
    {
      this->File.AddSection(SectionPages, this->Payload.Data);
      this->Payload.Data.clear();
    }
  }

private:
  static constexpr std::size_t MostBytes = 16u << 20;

  OutputFile& File;
  ByteWriter Payload;
};
}

#endif
