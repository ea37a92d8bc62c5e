// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPiece_h
#define gatunPiece_h

#include "gatun.h"
#include "gatunOpenFile.h"
#include "gatunPieceRequest.h"
#include "gatunRegion.h"

#include <functional>
#include <memory>
#include <vector>

/** A part of a mesh that was decoded or is ready for it. */
struct gatun_piece
{
  using Progress = std::function<bool(double)>;

  gatun_piece() = default;
  virtual ~gatun_piece() = default;
  gatun_piece(const gatun_piece&) = delete;
  gatun_piece& operator=(const gatun_piece&) = delete;

  virtual gatun_sizes GetSizes() const = 0;
  virtual void Read(const gatun_buffers& buffers, const Progress& progress) = 0;

protected:
  /** The buffers of arrays with some numbers of a file; none if they are left out. */
  static std::vector<void*> TakeArrays(const gatun_buffers& buffers,
    const std::vector<gatun::ArrayDescription>& arrays, std::uint64_t points, std::uint64_t cells);
};

namespace gatun
{
/** A request of C as one of the core, with the mesh that it is for. */
struct FoundRequest
{
  FoundRequest(gatun_file& file, const gatun_request& request);

  std::shared_ptr<SharedFile> Mesh;       // or its boundary
  std::shared_ptr<const FileReader> File; // the mesh or a base mesh of it
  gatun::Region Region;
  bool IsExact = false;
  PieceRequest Request;
  std::vector<ArrayDescription> Arrays; // those of the request

  std::shared_ptr<ChunkCache> MakeCache() const { return this->Mesh->MakeView(this->File, true); }
};
}

#endif
