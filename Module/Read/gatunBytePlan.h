// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBytePlan_h
#define gatunBytePlan_h

#include "gatunByteSource.h"
#include "gatunError.h"
#include "gatunExport.h"
#include "gatunFileReader.h"
#include "gatunPieceRequest.h"

#include <vector>

namespace gatun
{
/** The bytes of a file that an operation needs, as positions in the whole file. */
struct BytePlan
{
  std::vector<ByteRange> Ranges;

  /** Tables that are not here yet. They say what else is needed: plan again when they have come. */
  std::vector<ByteRange> Missing;

  /** Runs a part of the planning, and notes the bytes that are missing for it. */
  template <typename Part>
  void Try(Part&& part)
  {
    try
    {
      part();
    }
    catch (const Error& error)
    {
      if (error.Code != ErrorCode::NotHere)
      {
        throw;
      }
      this->Missing.push_back({ error.Offset.value_or(0), error.Length });
    }
  }
};

/** Adds what a PieceDecoder reads for a request: mesh, shared points, original numbers and arrays
 * of its chunks; after merges all chunks, and around ghosts those of others. Reads tables only. */
GATUN_EXPORT void PlanPiece(const FileReader& file, const PieceRequest& request, BytePlan& plan);

/** Tells a remote source what will be read for a request. Does nothing for other sources. */
void FetchPiece(const FileReader& file, const PieceRequest& request);
}

#endif
