// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFilePiece_h
#define gatunFilePiece_h

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAlgorithm;
class vtkDataObject;
class vtkGatunReader;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

// What goes from where a file is read to where it is drawn, instead of its mesh.

namespace gatun
{
struct DrawnFile
{
  std::string Path; ///< empty for none
  double Time = 0;
  double Simplification = 0; ///< the part of the points that is merged away
};

/** The algorithm that the input of a representation or filter comes from, with nothing in between
 * that may have changed the data; null if there is none. */
vtkAlgorithm* FindProducer(vtkAlgorithm* consumer);

/** The reader that the input of a representation or filter comes from in this way; null if there is
 * none. */
vtkGatunReader* FindReader(vtkAlgorithm* consumer);

/** The reader's file, at the time of what it made, simplified as the reader is to. */
DrawnFile DescribeFile(vtkGatunReader* reader, vtkDataObject* made);

/** Adds to the piece's field data what file is to be drawn in its place. */
void MarkPiece(vtkUnstructuredGrid* piece, const DrawnFile& file);

/** The file to be drawn in place of a piece, if it is marked. */
DrawnFile GetMark(vtkUnstructuredGrid* piece);
}

#endif
