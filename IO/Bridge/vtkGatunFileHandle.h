// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunFileHandle
 * @brief The open file of a vtkGatunReader, as its consumers find it in the pipeline.
 *
 * vtkGatunReader publishes a handle in the information of its output, under FILE_HANDLE(), when
 * UpdateInformation is called. vtkGatunContour, vtkGatunSimplify, vtkGatunRayCaster and
 * vtkGatunVolumeMapper look for it in the information of their input. If it is there, they take
 * what they need from the file, and the reader decodes nothing for them. All of them share the
 * reader's open file, its cache of decoded chunks and its memory budget; none opens the file again.
 *
 * A handle describes the file and the settings of the reader: selected arrays, number of merges,
 * order of points and cells. It never changes. When the file or the settings change, the reader
 * publishes another one. Nothing that a consumer asks for, such as a piece or a time, is part of
 * it; consumers read that from the same information as always. Hence the request of one consumer
 * does not change what another one gets.
 *
 * *Meshes that change.* A file may have another mesh at some of its time steps. The numbers and
 * bounds of a handle are those of the first mesh; consumers use the mesh of the time that they ask
 * for.
 *
 * *Filters in between.* The executive does not pass the key on. Consumers behind another filter
 * therefore use that filter's output, as they must, since it may have changed the mesh. A filter
 * that passes on its input unchanged may copy the handle from the information of its input to that
 * of its output in RequestInformation.
 *
 * @sa vtkGatunReader
 */

#ifndef vtkGatunFileHandle_h
#define vtkGatunFileHandle_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::unique_ptr

namespace gatun
{
class SharedFile;
struct FileSettings;
struct PublishedFile;
}
#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkInformationObjectBaseKey;

class VTKGATUNIO_EXPORT vtkGatunFileHandle : public vtkObject
{
public:
  static vtkGatunFileHandle* New();
  vtkTypeMacro(vtkGatunFileHandle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Key in the output information of vtkGatunReader: a vtkGatunFileHandle. It is not there as long
   * as the reader has no FileName.
   */
  static vtkInformationObjectBaseKey* FILE_HANDLE();

  /**
   * Name of the file.
   */
  const char* GetFileName();

  /**
   * Whether the file is open. If not, GetReason() returns the error.
   */
  bool GetIsOpen();

  /**
   * Reason why consumers must use the reader's output in place of the file, such as a region of
   * interest; empty if they can use the file.
   */
  const char* GetReason();

  /**
   * Whether consumers can use the file in place of the reader's output: it is open, and GetReason()
   * is empty.
   */
  bool GetCanReplaceOutput();

  ///@{
  /**
   * Size of the whole mesh in the file; 0 if it is not open.
   */
  vtkIdType GetNumberOfPoints();
  vtkIdType GetNumberOfTetrahedra();
  ///@}

  /**
   * Bounds of the whole mesh in the file: xmin, xmax, ymin, ymax, zmin, zmax. Uninitialized bounds
   * (as of vtkMath) if it is not open, or has no finite coordinates.
   */
  void GetBounds(double bounds[6]);

  /**
   * Whether the mesh in the file has a hierarchy, by which it can be simplified.
   */
  bool GetHasHierarchy();

  /**
   * Number of merges that the reader makes to simplify the mesh.
   */
  vtkIdType GetNumberOfMerges();

  /**
   * Whether the reader's output is an outline or the boundary, see vtkGatunReader::LargeMesh.
   */
  bool GetIsOnDemand();

  ///@{
  /**
   * Memory that the reader and all consumers of the file use for decoded chunks and for what they
   * derive from them, and its budget, in bytes.
   */
  vtkTypeUInt64 GetMemory();
  vtkTypeUInt64 GetMemoryBudget();
  ///@}

  /**
   * Bytes that the reader and all consumers have read since the file was opened.
   */
  vtkTypeUInt64 GetBytesRead();

  ///@{
  /**
   * Meshes of chunks that the reader and all consumers have decoded since the file was opened, and
   * those that they have found decoded.
   */
  vtkTypeUInt64 GetDecodedChunks();
  vtkTypeUInt64 GetFoundChunks();
  ///@}

  ///@{
  /**
   * Contents of the handle, for Gatun's own classes: those of the first mesh, or of the mesh at a
   * time. They are set once, before the handle is published: a file with the settings of its
   * reader, or the failure to open it. The mesh at a time is opened when it is first asked for.
   */
  const gatun::PublishedFile& GetContents() const;
  const gatun::PublishedFile& GetContents(double time) const;
  void SetContents(gatun::PublishedFile&& failure);
  void SetContents(
    const std::shared_ptr<gatun::SharedFile>& file, const gatun::FileSettings& settings);
  ///@}

protected:
  vtkGatunFileHandle();
  ~vtkGatunFileHandle() override;

private:
  vtkGatunFileHandle(const vtkGatunFileHandle&) = delete;
  void operator=(const vtkGatunFileHandle&) = delete;

  class vtkInternals;
  const std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
