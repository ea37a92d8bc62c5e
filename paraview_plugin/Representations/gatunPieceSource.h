// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceSource_h
#define gatunPieceSource_h

#include "gatunFilePiece.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAlgorithm;
class vtkDataObject;
class vtkDataSet;
class vtkGatunFileHandle;
class vtkGatunHandleSource;
class vtkGatunMeshReader;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The handle in the information of a source; null if there is none. */
vtkGatunFileHandle* GetHandle(vtkAlgorithm* source);

/** The file that a representation draws in place of its piece: by the handle of the reader in this
 * process, or opened by its name if another process has read the piece. */
class PieceSource
{
public:
  /** Reader: opens files that other processes read. */
  explicit PieceSource(vtkSmartPointer<vtkGatunMeshReader> reader);
  ~PieceSource();

  /** Looks at the input of a representation. Returns its handle if it is a file on demand. */
  vtkGatunFileHandle* FindFile(vtkAlgorithm* representation);

  /** The file to be drawn in place of a piece, if it is marked. A process that reads the input
   * itself believes a mark only if that input is a file on demand. */
  DrawnFile GetMark(vtkDataObject* piece) const;

  /** The source to draw in place of a piece; null if the file is not open. */
  vtkAlgorithm* Connect(vtkAlgorithm* representation, vtkDataSet* piece, const DrawnFile& file);

  vtkGatunMeshReader* GetReader() const { return this->OtherFile; }

private:
  vtkNew<vtkGatunHandleSource> OwnFile;          // of the reader in this process
  vtkSmartPointer<vtkGatunMeshReader> OtherFile; // of a reader in another process
  vtkSmartPointer<vtkGatunFileHandle> Handle;    // of the piece, if it comes from a file on demand
  bool HasInput = false;                         // of the representation, in this process
};
}

#endif
