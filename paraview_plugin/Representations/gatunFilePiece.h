// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFilePiece_h
#define gatunFilePiece_h

#include "vtkType.h" // For vtkIdType

#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAlgorithm;
class vtkDataObject;
class vtkGatunFileHandle;
class vtkInformation;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

// The way of a file from the process that reads it to the process that draws it. Within a process
// that is the handle of the file. To another process it is the name of the file, as field data of
// the piece that ParaView delivers, because keys of information do not get there. Files have field
// data, too: a representation removes such arrays from all that it gets, so that only a handle can
// mark a piece.

namespace gatun
{
/** A file to be drawn in place of a piece. */
struct DrawnFile
{
  std::string Path; ///< empty for none
  double Time = 0;
  vtkIdType Merges = 0; ///< number of merges that the reader makes
  vtkIdType Cells = 0;  ///< of the pieces of all processes, which are there in place of the mesh
};

/** The algorithm that the input of a representation or filter comes from, with nothing in between
 * that may have changed the data; of a series of files the reader itself. Null if there is none. */
vtkAlgorithm* FindProducer(vtkAlgorithm* consumer);

/** The information of the output that the input of a representation or filter comes from, with
 * nothing in between that may have changed the data; null if there is none. */
vtkInformation* FindSource(vtkAlgorithm* consumer);

/** The file handle there; null if there is none. */
vtkGatunFileHandle* FindHandle(vtkAlgorithm* consumer);

/** The file of a handle at the time of the reader's output. */
DrawnFile DescribeFile(vtkGatunFileHandle* handle, vtkDataObject* output);

/** Removes what looks like a mark from a piece and its blocks, whoever has made it. */
void UnmarkPiece(vtkDataObject* piece);

/** Adds the file that is to be drawn in place of a piece to the field data of the piece. */
void MarkPiece(vtkDataObject* piece, const DrawnFile& file);

/** The file to be drawn in place of a piece, if it is marked. For pieces that a representation has
 * delivered; see PieceSource::GetMark. */
DrawnFile GetMark(vtkDataObject* piece);
}

#endif
