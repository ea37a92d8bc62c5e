// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellTreeWriter_h
#define gatunCellTreeWriter_h

// The streams of a CellTree but the names of vertices.

#include "gatunBytes.h"
#include "gatunCodedCells.h"

namespace gatun
{
class CellTreeWriter
{
public:
  CellTreeWriter(const CellTemplates& templates, const CodedCells& cells);

  void Write(ByteWriter& out) const;

private:
  void WriteIds(ByteWriter& out) const;
  void WriteSources(ByteWriter& out) const;
  void WriteFars(ByteWriter& out) const;
  void WriteRests(ByteWriter& out) const;

  const CellTemplates& Templates;
  const CodedCells& Coded;
};
}

#endif
