// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkTable_h
#define gatunChunkTable_h

#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkTable;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class FileReader;

/** The table that vtkGatunReader::CHUNK_TABLE() describes. Decodes nothing. */
vtkSmartPointer<vtkTable> MakeChunkTable(const FileReader& file);
}

#endif
