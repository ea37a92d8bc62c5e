// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunMeshReader
 * @brief Common superclass of the readers of `.gtn` files.
 *
 * A `.gtn` file holds an unstructured grid, which vtkGatunReader reads, or a surface, which
 * vtkGatunSurfaceReader reads. This class has what both share: the properties, the open file
 * and its cache, pieces, time steps, selections, regions of interest and reading on demand. The
 * output has the values of the input of vtkGatunWriter bit for bit: points as float or double,
 * connectivity with 32- or 64-bit ids (as in the input), point, cell and field arrays of their VTK
 * types with component names and roles (active scalars, vectors, ..., global ids). Information keys
 * of arrays are not stored in `.gtn` files. Points and cells come in the order of the file, or in
 * that of the input if the file keeps it and RestoreOrder is on.
 *
 * *Pieces.* A file consists of chunks. If C of them pass the region of interest, piece p of n
 * consists of the chunks floor(p C / n) to floor((p + 1) C / n) - 1. Only these are read. Points
 * that no cell uses belong to piece 0. With more pieces than chunks some pieces are empty. On
 * request the reader adds layers of ghost cells; vtkGhostType then marks the points and cells of
 * other pieces. Global ids are the same in all pieces.
 *
 * *Regions of interest.* With a box or a value range, the chunks that pass form the mesh, as if the
 * file had no others. Pieces divide them, ghost cells are taken from them, and each of their points
 * is owned by exactly one piece. The region ends without ghost cells, and the output has a surface
 * there.
 *
 * *Arrays.* Only the selected arrays are read from the file. All are selected by default.
 *
 * *Time.* The reader gives the last step that is not later than the requested time, or the first
 * step if all are later. vtkDataObject::DATA_TIME_STEP() of the output is its time. While the piece
 * stays the same, all steps share their points and cells.
 *
 * *Consumers.* Several filters behind the reader may request different pieces, ghost levels and
 * times in turn. Each gets exactly what it requests. A filter that requests no time gets the time
 * that was requested last, as everywhere in VTK.
 *
 * *Consumers of the file.* UpdateInformation publishes a vtkGatunFileHandle in the information of
 * the output. vtkGatunContour, vtkGatunSimplify, vtkGatunRayCaster and vtkGatunVolumeMapper take
 * what they need from there. They share the open file, the decoded chunks and the memory budget of
 * the reader, and the reader decodes nothing for them. With a region of interest they use the
 * output.
 *
 * *Change on disk.* Each update checks whether the file was replaced or rewritten. If so, the
 * reader opens it anew.
 *
 * *On demand.* Of a mesh that is larger than LargeMesh, the output is the outline:
 * the 8 corners of its bounds and 12 lines. The outline has the selected arrays. Their values span
 * the ranges of those of the mesh at the current step, component by component and, for up to three
 * components, in length. Piece 0 has the outline, all others are empty. Nothing is decoded.
 * If the file has the boundary of the mesh (vtkGatunWriter::WriteBoundary), the output is the
 * boundary instead: faces as triangles, quadrilaterals and polygons with the selected arrays, in
 * pieces as the mesh. Nothing else is decoded. The 8 corners of the outline are there as points
 * that no cell has, so that point arrays have the ranges of those of the mesh; cell arrays have
 * those of the boundary. The boundary has no order or global ids of the mesh. If it consists of
 * triangles and the file has a hierarchy, it is simplified as the mesh, and further until
 * MemoryBudget is enough for it. Without a hierarchy, the output is the outline if the budget is
 * not enough.
 *
 * ON_DEMAND() in the information of the output and GetIsOnDemand distinguish both from a mesh. The
 * consumers of the file use the mesh all the same. With a region of interest the output is always a
 * mesh.
 *
 * *Simplification.* Files with a hierarchy (vtkGatunWriter::Hierarchy) can be read with any number
 * of points; see SimplificationRatio. The tetrahedra, or the cells of a surface, of all pieces
 * together are those that vtkGatunSimplify leaves of the whole mesh, so that pieces fit together. A
 * surface can have a few points more than the target, so that its seams stay closed. If the file
 * has base meshes (vtkGatunWriter::Levels), only the coarsest one that is fine enough is decoded,
 * unless the original order is to be restored, which base meshes do not have. Time, arrays, regions
 * and ghost cells work as on the whole mesh. Global ids are those of the base mesh if one is read.
 *
 * *Cost.* Memory: the output, the same again while ghost cells are chosen, and the mesh that was
 * read last. Decoded chunks are kept within MemoryBudget, so that other pieces, arrays and time
 * steps need not decode them again. They are not kept when the whole mesh of a file without time
 * steps is read in one piece; if the choice of arrays changes later, the chunks are decoded once
 * more and then kept. Decoding uses all threads.
 *
 * *Errors.* Errors are reported by vtkErrorMacro with a message that begins with the name of the
 * file. GetErrorCode is then one of vtkErrorCode::NoFileNameError, FileNotFoundError,
 * CannotOpenFileError (a folder, no permission), UnrecognizedFileTypeError (not a `.gtn` file),
 * PrematureEndOfFileError (truncated), FileFormatError (damaged), UnknownError (such as too little
 * memory), or of vtkGatunErrorCode: InvalidInputError for a file of the other reader, which the
 * message names. The output is then empty.
 *
 * @warning With a region of interest the output consists of whole chunks and has cells outside.
 * @warning The original order can be restored only if the whole mesh is requested.
 *
 * @sa vtkGatunReader vtkGatunSurfaceReader vtkGatunWriter vtkGatunFileHandle
 */

#ifndef vtkGatunMeshReader_h
#define vtkGatunMeshReader_h

#include "vtkAlgorithm.h"
#include "vtkGatunIOModule.h" // For export macro

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataArraySelection;
class vtkInformationIntegerKey;
class vtkInformationObjectBaseKey;
class vtkTable;

class VTKGATUNIO_EXPORT vtkGatunMeshReader : public vtkAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkGatunMeshReader, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether this reader is the one for the file: 1 or 0. See the subclasses.
   */
  virtual int CanReadFile(VTK_FILEPATH const char* name) = 0;

  ///@{
  /**
   * Extension and name of the file type, for lists of readers.
   */
  virtual const char* GetFileExtensions() { return ".gtn"; }
  virtual const char* GetDescriptiveName() = 0;
  ///@}

  ///@{
  /**
   * Which arrays to read, by name; known once UpdateInformation was called. A selection made before
   * that holds if the file has such an array. An array without a name is always read. Default: all.
   */
  vtkDataArraySelection* GetPointDataArraySelection();
  vtkDataArraySelection* GetCellDataArraySelection();
  ///@}

  ///@{
  /**
   * The same selections by index, 0 to number - 1, and by name; status 1: to be read, 0: not.
   */
  int GetNumberOfPointArrays();
  const char* GetPointArrayName(int index);
  int GetPointArrayStatus(const char* name);
  void SetPointArrayStatus(const char* name, int status);
  int GetNumberOfCellArrays();
  const char* GetCellArrayName(int index);
  int GetCellArrayStatus(const char* name);
  void SetCellArrayStatus(const char* name, int status);
  ///@}

  ///@{
  /**
   * Whether points, cells and corners come in the order that the writer's input had, as far as the
   * file keeps it (vtkGatunWriter::SetKeepOrder) and the whole mesh is asked for. Default: on.
   */
  vtkSetMacro(RestoreOrder, bool);
  vtkGetMacro(RestoreOrder, bool);
  vtkBooleanMacro(RestoreOrder, bool);
  ///@}

  ///@{
  /**
   * Whether to make the arrays GlobalPointIds and GlobalCellIds (vtkIdTypeArray, also set as global
   * ids): the place of each point and cell in the whole mesh, from 0; where the file keeps the
   * order of points or cells, the place in the writer's input. Off: only if a part is asked for
   * (more pieces than one), where they tell which points and cells of two parts are the same; they
   * are then marked with vtkAbstractArray::GUI_HIDE, which keeps them out of ParaView's lists.
   * Nothing is made where the output has global ids of the file, or an array of that name.
   * Default: off.
   */
  vtkSetMacro(GenerateGlobalIds, bool);
  vtkGetMacro(GenerateGlobalIds, bool);
  vtkBooleanMacro(GenerateGlobalIds, bool);
  ///@}

  ///@{
  /**
   * Region of interest: xmin, xmax, ymin, ymax, zmin, zmax, in the units of the coordinates. Chunks
   * whose bounds do not touch it are left out, and so are points without cells. If a minimum is
   * larger than its maximum, there is no box. Default: 1, -1, 1, -1, 1, -1, as
   * vtkMath::UninitializeBounds has it.
   */
  vtkSetVector6Macro(Box, double);
  vtkGetVector6Macro(Box, double);
  ///@}

  ///@{
  /**
   * Name of the array by whose values chunks are left out, and points without cells: a point array,
   * or else a cell array. It need not be selected. An array that the file does not have is an
   * error. Empty or null: none are left out. Default: null.
   */
  vtkSetStringMacro(ValueRangeArray);
  vtkGetStringMacro(ValueRangeArray);
  ///@}

  ///@{
  /**
   * Smallest and largest value of interest, in the units of the array: chunks without a value of
   * ValueRangeArray in this range at the current step are left out. Of arrays with several
   * components, the Euclidean length of the tuple counts. Default: 0, 1.
   */
  vtkSetVector2Macro(ValueRange, double);
  vtkGetVector2Macro(ValueRange, double);
  ///@}

  ///@{
  /**
   * Memory for decoded chunks, in MiB, 0 or more. Neighboring pieces with ghost cells, other
   * arrays and other time steps reuse these chunks; the least recently used ones are dropped first.
   * With 0 no chunk is kept. If the mesh needs more, part of it is decoded again for each time
   * step. The output does not depend on the budget, except on demand, and a change does not modify
   * the reader. Default: 512, enough for about ten million tetrahedra with one or two arrays.
   */
  void SetMemoryBudget(int mebibytes);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * Whether to decode the arrays of the next time step in the background when a step has been read,
   * if MemoryBudget is enough for the mesh and three steps. The next step is the one in the
   * direction from the step before. The output is the same. Default: off; on in ParaView.
   */
  void SetPrefetchTimeSteps(bool prefetch);
  vtkGetMacro(PrefetchTimeSteps, bool);
  vtkBooleanMacro(PrefetchTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Largest mesh that is read in full: the number of tetrahedra of a grid, or of cells of a
   * surface, after simplification. Of larger ones, the output is the boundary or the outline, so
   * that nothing is decoded before somebody draws the file. 0: never in full. -1: always. No effect
   * with Box or ValueRangeArray. Default: -1; 5,000,000 in ParaView.
   */
  vtkSetClampMacro(LargeMesh, vtkIdType, -1, VTK_ID_MAX);
  vtkGetMacro(LargeMesh, vtkIdType);
  ///@}

  ///@{
  /**
   * Fraction of points to remove, from 0 (none) to 1 (as many as possible). NaN is an error. No
   * effect if one of the other two targets is given. Default: 0.
   */
  vtkSetClampMacro(SimplificationRatio, double, 0.0, 1.0);
  vtkGetMacro(SimplificationRatio, double);
  ///@}

  ///@{
  /**
   * Number of points of the result, as far as possible; a larger number than that of the mesh keeps
   * all. 0: SimplificationRatio is the target. Default: 0.
   */
  vtkSetClampMacro(SimplificationNumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(SimplificationNumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Largest root mean square error of the result: an estimate for the values, relative to their
   * range, and for the shape of the boundary. 0: one of the other two is the target. Default: 0.
   */
  vtkSetClampMacro(SimplificationRMSError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SimplificationRMSError, double);
  ///@}

  /**
   * Whether the file has a hierarchy (vtkGatunWriter::Hierarchy), after UpdateInformation.
   */
  bool GetHasHierarchy();

  /**
   * Whether the output is the boundary or the outline of the mesh, with the file and the properties
   * as they are: true or false, after UpdateInformation. False without a readable file.
   */
  bool GetIsOnDemand();

  /**
   * What the output is on demand.
   */
  enum OnDemandOutputs
  {
    ON_DEMAND_OUTLINE = 1,
    ON_DEMAND_BOUNDARY = 2
  };

  /**
   * Key in the information of the output (vtkDataObject::GetInformation): one of OnDemandOutputs.
   * It is not there where the output is the mesh.
   */
  static vtkInformationIntegerKey* ON_DEMAND();

  /**
   * Statistics: a new table of one row, with 0 without an open file. Columns (vtkTypeUInt64Array):
   * - BytesRead: what the reader and its consumers have read from the file since it was opened,
   * which happens in UpdateInformation when the name or the file has changed;
   * - DecodedChunks: chunks whose mesh was decoded for the reader's output since then;
   * - CachedBytes: cache memory in use by the reader and its consumers, at most MemoryBudget.
   */
  vtkTable* GetStatistics();

  /**
   * Key in the output information, set by UpdateInformation: a vtkTable with a row for each chunk,
   * from which a sink can choose what to ask for; with the number of chunks as the number of pieces
   * and no region of interest, row i is piece i. Columns:
   *
   *  - Cells, FirstCell, Points (vtkIdTypeArray): cells, global id of the first one, and points,
   *    those that other chunks use too included;
   *  - Bounds (vtkDoubleArray, 6 components): xmin, xmax, ymin, ymax, zmin, zmax, over all time
   *    steps if the points move;
   *  - Point:name, Cell:name (vtkDoubleArray) for each array of the file, selected or not: min and
   *    max of each component and, if there is more than one, of the length of the tuple; over all
   *    time steps; without NaN.
   *
   * Where min > max there is nothing: no finite coordinate, only NaN. The table must not be
   * changed. Files of more than 65,536 chunks have no such key, but GetChunkTable() gives the
   * table.
   */
  static vtkInformationObjectBaseKey* CHUNK_TABLE();

  /**
   * The table that CHUNK_TABLE() describes, after UpdateInformation; nullptr if there is no
   * readable file. Made at the first call, which reads the ranges of all arrays.
   */
  vtkTable* GetChunkTable();

  /**
   * Modified, too, when a selection of arrays is.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Looks, too, whether the file has changed on disk.
   */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inInfoVec,
    vtkInformationVector* outInfoVec, int requestFromOutputPort, vtkMTimeType* mtime) override;

  /**
   * Calls RequestInformation and RequestData.
   */
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkGatunMeshReader();
  ~vtkGatunMeshReader() override;

  virtual int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);
  virtual int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);

  /**
   * Whether the subclass reads surfaces, in place of grids.
   */
  virtual bool ReadsSurfaces() const = 0;

  /**
   * Whether to read tetrahedra in place of the cells of a grid.
   */
  virtual bool GetSplitsCells() const { return false; }

  char* FileName = nullptr;
  bool RestoreOrder = true;
  bool GenerateGlobalIds = false;
  double Box[6] = { 1, -1, 1, -1, 1, -1 };
  char* ValueRangeArray = nullptr;
  double ValueRange[2] = { 0, 1 };
  int MemoryBudget = 512;
  bool PrefetchTimeSteps = false;
  vtkIdType LargeMesh = -1;
  double SimplificationRatio = 0;
  vtkIdType SimplificationNumberOfPoints = 0;
  double SimplificationRMSError = 0;

private:
  vtkGatunMeshReader(const vtkGatunMeshReader&) = delete;
  void operator=(const vtkGatunMeshReader&) = delete;

  void Fail(vtkInformationVector* outputVector) noexcept;
  void PublishFailure(vtkInformation* outInfo) noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
