// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunLayerTable_h
#define gatunLayerTable_h

// What a LAYR section says: by which values a file is organised. See Documentation/format.md, 14.

#include "gatunBytes.h"
#include "gatunLayers.h"
#include "gatunTables.h"

#include <span>

namespace gatun
{
Bytes WriteLayers(const Layers& layers);

Layers ReadLayers(
  std::span<const std::uint8_t> bytes, const MetaTable& meta, const MeshTable& mesh);

/** Whether a chunk whose values are in this range can have this span. */
bool IsInside(const Layers& layers, const LayerSpan& span, const Range& values);
}

#endif
