// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLayerTable_h
#define gatunLayerTable_h

// The LAYR section: the layers that a file is organized by. See Documentation/format.md, 14.

#include "gatunBytes.h"
#include "gatunLayers.h"
#include "gatunMetaTable.h"

#include <span>

namespace gatun
{
Bytes WriteLayers(const Layers& layers, const MetaTable& meta);

Layers ReadLayers(
  std::span<const std::uint8_t> bytes, const MetaTable& meta, std::size_t numberOfChunks);

/** Whether a range of values lies within a span of layers. */
bool IsInside(const Layers& layers, const LayerSpan& span, const Range& values);
}

#endif
