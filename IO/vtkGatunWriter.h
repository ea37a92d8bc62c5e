// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunWriter
 * @brief Writes a vtkUnstructuredGrid or vtkPolyData as a compressed mesh (`.gtn`), without loss.
 *
 * Input: a vtkUnstructuredGrid of vtkTetra cells with 32- or 64-bit ids and float or double points,
 * which goes into the file without a copy, or a surface, see below. Other integer types of points
 * are converted to double, with a warning, and refused where that is not exact. Meshes without
 * points or cells are valid, as are unused and duplicate points, NaN and infinite coordinates,
 * flat, inverted and duplicate tetrahedra, and faces shared by more than two.
 *
 * Arrays: point, cell and field arrays of every numeric VTK type, bits included, and field arrays
 * of strings, with component names and roles (active scalars, ..., global ids). Arrays that do not
 * lie in memory tuple by tuple are copied. String and variant arrays of points or cells are refused
 * with an error; field arrays of variants are left out with a warning.
 *
 * Cells: those of all types, also unknown to VTK; SplitCells splits 3D cells into tetrahedra. A
 * wrong number of points, or points or faces that do not exist, are an error that names the cell.
 *
 * Surfaces: a vtkPolyData with polygons, vertices, lines and triangle strips of any size. If more
 * than one of these lists has cells, they are copied. A surface with a hierarchy must have no
 * polygons other than triangles and no strips: vtkTriangleFilter divides them. Files of surfaces
 * have no layers, and SplitCells is an error. vtkGatunSurfaceReader reads them.
 *
 * Ghosts: cells marked DUPLICATECELL in vtkGhostType are written as all others, with their marks.
 * With SplitCells, NumberOfPieces or several processes they are left out, and so are points that
 * only they use and the marks for duplicates; a warning tells their number. Other marks (hidden
 * cells and points) are kept.
 *
 * Names and keys: the names of arrays, of the points, and of their components are kept, and so are
 * their information keys with numbers, texts, lists of them (vtkDataArray::UNITS_LABEL() and keys
 * of an application) and quadrature schemes. Other keys are left out with a warning.
 *
 * Time: with WriteAllTimeSteps, all time steps of the input go into one file. If points move, the
 * writer requests the first time steps twice. Cells and the number of points may change: then
 * the file has another mesh from that step on. Arrays may have another order at each step, and have
 * the order and roles of the first step with values, and the first names of components that occur.
 * vtkGhostType may come and go, and a step without points or cells needs no arrays of them. If the
 * arrays turn out to be more, the rest of the steps is looked at, and all are requested again. If
 * another array comes or goes (but see FillMissingArrays), or changes its type, that is an error
 * naming array and step; so are points that move and meshes that change with NumberOfPieces or
 * several processes. Without, the step at hand is written, with its time if it has one
 * (vtkDataObject::DATA_TIME_STEP()).
 *
 * The file appears under its name once it is complete; after an error or an abort, an existing
 * file is left unchanged. A read-only file is not replaced.
 *
 * Pieces: with NumberOfPieces, the input is asked for one piece after the other, twice, and the
 * whole mesh is never in memory. Points of several pieces become one if they have the same global
 * id (or number of the array with JOIN_POINTS), or without ids the same coordinates, and the same
 * values of all arrays at all steps. Without ids, points inside of pieces are not compared, which
 * matters for lines and surfaces of one piece that touch the inside of another one. Points that
 * differ stay apart, with a warning. An input that does not know pieces is one piece. The time
 * steps of a piece follow each other. Layers need the whole mesh and are an error, and so is a
 * hierarchy with several processes. Points that need more than 64 MiB go into unnamed
 * temporary files in the folder of the file.
 *
 * Processes: with Controller, each process writes its own piece; there is one piece per process.
 * Points of several pieces become one as above. Only the points on the boundaries of pieces and
 * tables are sent. A piece may have no cells; it then needs no arrays. An error of one process is
 * one of all, and no file appears. NumberOfPieces has no effect.
 *
 * *Cost.* Peak memory below 3 times the mesh and one step of its arrays, the input included; when
 * cells are split, that of the split mesh in addition. All threads are used; the
 * bytes written do not depend on their number.
 *
 * *Errors.* Reported by vtkErrorMacro with a message that begins with the file's name; Write then
 * returns 0 and GetErrorCode is one of vtkErrorCode::NoFileNameError, CannotOpenFileError (no such
 * folder, no permission, or a read-only file is there), OutOfDiskSpaceError, UnknownError (such as
 * too little memory, or the input's pipeline failed or threw), or of vtkGatunErrorCode.
 *
 * @warning The whole mesh must fit into memory, or with NumberOfPieces the largest piece.
 * @warning Unless KeepOrder says otherwise, points and cells come back in another order.
 *
 * @sa vtkGatunReader vtkGatunSurfaceReader vtkGatunMergeBlocks
 */

#ifndef vtkGatunWriter_h
#define vtkGatunWriter_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkGatunUpdateResult.h"
#include "vtkWriter.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataArraySelection;
class vtkDataObject;
class vtkInformationIntegerKey;
class vtkMultiProcessController;
class vtkTable;

class VTKGATUNIO_EXPORT vtkGatunWriter : public vtkWriter
{
public:
  static vtkGatunWriter* New();
  vtkTypeMacro(vtkGatunWriter, vtkWriter);
  using vtkAlgorithm::Update;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Flags for SetKeepOrder.
   */
  enum KeepOrderFlags
  {
    KEEP_NONE = 0,
    KEEP_POINTS = 1,  ///< points and their arrays
    KEEP_CELLS = 2,   ///< tetrahedra and their arrays
    KEEP_CORNERS = 4, ///< corners of each tetrahedron and triangle
    KEEP_ALL = 7
  };

  ///@{
  /**
   * Name of the file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Which arrays to write, by name. Arrays that a selection does not list are written as its
   * UnknownArraySetting says (vtkDataArraySelection; 1: written), arrays without a name always.
   * Default: empty selections with a setting of 1, so all are written.
   */
  vtkDataArraySelection* GetPointDataArraySelection();
  vtkDataArraySelection* GetCellDataArraySelection();
  ///@}

  ///@{
  /**
   * Which original order the file keeps, for readers to restore: a sum of flags, 0 to 7, each of
   * which costs file size. With KEEP_ALL every array read equals the one written. It is the order
   * after cells were split, ghosts dropped or quadratic cells made linear. Default: KEEP_NONE.
   */
  vtkSetClampMacro(KeepOrder, int, KEEP_NONE, KEEP_ALL);
  vtkGetMacro(KeepOrder, int);
  void SetKeepOrderToNone() { this->SetKeepOrder(KEEP_NONE); }
  void SetKeepOrderToPoints() { this->SetKeepOrder(KEEP_POINTS); }
  void SetKeepOrderToCells() { this->SetKeepOrder(KEEP_CELLS); }
  void SetKeepOrderToPointsAndCells() { this->SetKeepOrder(KEEP_POINTS | KEEP_CELLS); }
  void SetKeepOrderToAll() { this->SetKeepOrder(KEEP_ALL); }
  ///@}

  ///@{
  /**
   * Largest number of cells in a chunk, the smallest part that can be read: 64 to 1048576, or 0 for
   * 65536 (131072 for meshes of over one million, 262144 for over 10 million; a quarter of it with
   * layers). In the fast profile, chunks have 65535 points at most, too; in the small one, cells
   * count as the tetrahedra that they can be split into. Of a mesh in pieces, each counts as an
   * equal share of the mesh. Small chunks make larger files. Default: 0.
   */
  virtual void SetChunkSize(int cells);
  vtkGetMacro(ChunkSize, int);
  ///@}

  /**
   * Kinds of tolerances, with their values.
   */
  enum ToleranceKind
  {
    TOLERANCE_NONE = 0,      ///< stored without loss; the value is not used
    TOLERANCE_ABSOLUTE = 1,  ///< largest difference, above 0, in the units of what is stored
    TOLERANCE_RELATIVE = 2,  ///< the same, by the range of values or the longest side of the bounds
    TOLERANCE_POINTWISE = 3, ///< the same, by the magnitude of each value, above 0 and below 1
    TOLERANCE_BITS = 4       ///< binary digits to keep
  };

  ///@{
  /**
   * Lets the values of an array differ from those of the input. name: that of an array, or "*" for
   * all arrays of floating-point numbers without a tolerance of their own.
   * - TOLERANCE_RELATIVE: at most 1; by the range of the finite values of the component at the time
   *   step. Constant components are exact.
   * - TOLERANCE_BITS: the first 1 to 52 significant digits are right after rounding.
   *
   * With keepZeros, values of 0 stay exactly 0. Every value is checked while it is written. NaN,
   * infinities, ids (global, pedigree, and all of type vtkIdType) and vtkGhostType stay exact, and
   * so do integers with tolerances below 1. An unknown kind, a value out of its range and the name
   * of no array are errors when the file is written. Default: none; all is stored without loss.
   */
  virtual void SetArrayTolerance(const char* name, int kind, double value, bool keepZeros = false);
  virtual void ClearArrayTolerances();
  ///@}

  ///@{
  /**
   * Whether the file is optimized for size or for reading speed. Fast files are read several times
   * faster and take up to twice the space. Default: PROFILE_FAST.
   */
  enum ProfileType
  {
    PROFILE_SMALL = 0,
    PROFILE_FAST = 1
  };
  vtkSetClampMacro(Profile, int, PROFILE_SMALL, PROFILE_FAST);
  vtkGetMacro(Profile, int);
  void SetProfileToSmall() { this->SetProfile(PROFILE_SMALL); }
  void SetProfileToFast() { this->SetProfile(PROFILE_FAST); }
  ///@}

  ///@{
  /**
   * Interval of key steps, which are stored without reference to the step before, in time steps, 1
   * or more. A short one makes jumps to any step faster, a long one files smaller. Default: 8.
   */
  vtkSetClampMacro(KeyStepInterval, int, 1, VTK_INT_MAX);
  vtkGetMacro(KeyStepInterval, int);
  ///@}

  enum HierarchyType
  {
    HIERARCHY_OFF = 0,
    HIERARCHY_ON = 1,
    HIERARCHY_WITH_DEPENDENCIES = 2
  };

  ///@{
  /**
   * Whether to store a hierarchy, so that the mesh can be read and drawn with any number of points
   * (vtkGatunReader::SimplificationRatio, vtkGatunVolumeMapper): the order in which
   * vtkGatunSimplify merges points, with the defaults of that filter and the values of the first
   * time step. This takes the time and memory of that filter. Default: off.
   *
   * HIERARCHY_WITH_DEPENDENCIES: Also which merges depend on which, some 3 bytes a point. Readers
   * need that to simplify some places more than others. They find it by decoding meshes of up to 4
   * million tetrahedra, or cells of a surface; of larger ones, they take the finest base mesh
   * (Levels) that is not larger.
   *
   * Of a mesh in pieces (NumberOfPieces) the merges are found in groups of tetrahedra. Each thread
   * has one in memory, of 320 MB. Beside them, some 90 bytes a point are needed, and 44 bytes a
   * tetrahedron and 70 a point of temporary files in the folder of the file. Errors are within some
   * percent of those of the whole mesh.
   */
  vtkSetClampMacro(Hierarchy, int, HIERARCHY_OFF, HIERARCHY_WITH_DEPENDENCIES);
  vtkGetMacro(Hierarchy, int);
  vtkBooleanMacro(Hierarchy, int);
  ///@}

  ///@{
  /**
   * Largest number of base meshes to store with the hierarchy, 0 to 64: with an eighth of the
   * points, or with half of those of a surface, and each further one with half (about, if the mesh
   * comes in pieces), as long as more than 20,000 tetrahedra, or cells of a surface, remain. A
   * coarse mesh then costs as much as one with at most twice as many points. Together they make the
   * file up to a third larger. No effect if Hierarchy is off. Default: 0.
   */
  vtkSetClampMacro(Levels, int, 0, 64);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Whether to store the boundary of the mesh with all arrays and time steps, which readers can
   * show without decoding the mesh (vtkGatunMeshReader::LargeMesh): the faces that only one 3D cell
   * has (of nonlinear cells, the linear faces with their corners), and the cells of a lower
   * dimension. Several processes, and surfaces, are refused. Default: off.
   */
  vtkSetMacro(WriteBoundary, bool);
  vtkGetMacro(WriteBoundary, bool);
  vtkBooleanMacro(WriteBoundary, bool);
  ///@}

  /**
   * Spacing of layers: equal parts of the range, quantiles of the normal distribution with the mean
   * and deviation of the values, or about equal numbers of tetrahedra.
   */
  enum LayerSpacingType
  {
    LAYERS_UNIFORM = 1,
    LAYERS_NORMAL = 2,
    LAYERS_HISTOGRAM = 3
  };

  ///@{
  /**
   * The point array whose range of values, at the first time step, is cut into layers. Tetrahedra
   * of the same layers are put into the same chunks, so that an isosurface needs few of them. The
   * file and its base meshes are organized in this way, and become larger with the number of
   * layers. Empty or null: the file is organized by position only. Default: null.
   *
   * component: that of the array, or -1 for the length of its tuples (of arrays with one component,
   * that component). number: largest number of layers, 0 to 4096, where empty ones are left out; 0:
   * by the size of the mesh, 4 below 5.8 million tetrahedra. spacing: one of LayerSpacingType.
   * Numbers out of these ranges are clamped.
   */
  virtual void SetLayers(
    const char* array, int component = -1, int number = 0, int spacing = LAYERS_HISTOGRAM);
  const char* GetLayerArray() const
  {
    return this->LayerArray.empty() ? nullptr : this->LayerArray.c_str();
  }
  vtkGetMacro(LayerComponent, int);
  vtkGetMacro(NumberOfLayers, int);
  vtkGetMacro(LayerSpacing, int);
  ///@}

  ///@{
  /**
   * Weight of a point array for the hierarchy relative to that of others, 0 or more. If none is
   * set, the active scalars count, or without active scalars all point arrays equally.
   */
  void SetArrayWeight(const char* name, double weight);
  double GetArrayWeight(const char* name);
  void ClearArrayWeights();
  ///@}

  ///@{
  /**
   * Whether to write all time steps of an input that has any, in place of the one at hand.
   * Default: off.
   */
  vtkSetMacro(WriteAllTimeSteps, bool);
  vtkGetMacro(WriteAllTimeSteps, bool);
  vtkBooleanMacro(WriteAllTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Whether the time steps are added to the file, if it exists. It has to have time and the same
   * arrays, and its last time has to be before theirs. Profile, KeepOrder, ChunkSize and
   * KeyStepInterval are then those of the file. Its bytes are copied; meshes that are in the file
   * already, written with the same options, are stored once. Not with NumberOfPieces or several
   * processes. Default: off.
   */
  vtkSetMacro(Append, bool);
  vtkGetMacro(Append, bool);
  vtkBooleanMacro(Append, bool);
  ///@}

  ///@{
  /**
   * Whether arrays may come and go with WriteAllTimeSteps: a time step that does not have an array
   * of another one gets it, with NaN, or 0 if it is of integers. No effect with NumberOfPieces or
   * several processes. Default: off.
   */
  vtkSetMacro(FillMissingArrays, bool);
  vtkGetMacro(FillMissingArrays, bool);
  vtkBooleanMacro(FillMissingArrays, bool);
  ///@}

  ///@{
  /**
   * Whether to write tetrahedra in place of the cells, with warnings: 3D cells are split
   * (Documentation/cells.md), nonlinear ones by their corners alone, and all other cells are left
   * out. The cell array OriginalCellIds holds the id of the input cell (an array of that name is
   * kept as it is), and global ids of cells, no longer unique, lose that role. Default: off.
   */
  vtkSetMacro(SplitCells, bool);
  vtkGetMacro(SplitCells, bool);
  vtkBooleanMacro(SplitCells, bool);
  ///@}

  ///@{
  /**
   * Lets coordinates differ from those of the input. They are rounded before anything else is done;
   * values of arrays stay. Coordinates that are not finite, and integers, stay. A file becomes
   * smaller where a coordinate has at most 65,536 different values.
   * - TOLERANCE_ABSOLUTE: to multiples of the largest power of two that keeps the tolerance, so
   * that points of pieces are joined by the rounded coordinates.
   * - TOLERANCE_RELATIVE: the same, below 1, by the longest side of the bounds. The mesh must be in
   *   one piece and one process.
   * - TOLERANCE_BITS: 1 to 31 bits; to multiples of the longest side divided by 2^bits - 1, from
   * the least corner on. The mesh must be in one piece and one process.
   *
   * Other kinds, and values out of range, are errors when the file is written. Default:
   * TOLERANCE_NONE.
   *
   * No cell turns over: tetrahedra, and those at the corners of hexahedra, voxels, wedges and
   * pyramids, keep their orientation, and flat ones stay flat, in exact arithmetic. Where they
   * would not, coordinates have finer steps, or stay. It is an error if more than 1 % of the points
   * (and more than 16) need that, or any point of a mesh in several pieces; the message suggests a
   * tolerance that works.
   */
  virtual void SetPointTolerance(int kind, double value);
  int GetPointToleranceKind() const { return this->PointToleranceKind; }
  double GetPointTolerance() const { return this->PointTolerance; }
  ///@}

  ///@{
  /**
   * The number of pieces to ask the input for, 1 or more. 1: the whole mesh at once. Default: 1.
   */
  vtkSetClampMacro(NumberOfPieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  ///@{
  /**
   * The processes that write the file together, each one its piece of the input. All must have an
   * input and the same options, and call Write. Null: this process alone. Default: null, not the
   * global controller as in ParaView's Save Data, so that one process may write by itself.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Writes the file, even if nothing has changed since it was last written. Write returns 1 on
   * success and 0 on failure; GetErrorCode then gives the reason.
   */
  int Write() override;
  VTK_GATUN_UPDATE_RESULT Update() override;
  VTK_GATUN_UPDATE_RESULT Update(int port) override;
  ///@}

  /**
   * Statistics of the last file written: a table of one row, with 0 before the first file. Columns
   * (vtkTypeUInt64Array, but PointError):
   * - Points, Cells: of all of its meshes; Meshes: 1 unless the mesh changes over time; TimeSteps:
   * 1 without time;
   * - FileBytes, and the bytes of its parts, which add up to it: of the first mesh
   *   ConnectivityBytes, GeometryBytes, OrderBytes, ArrayBytes, FieldDataBytes, HierarchyBytes,
   *   DependencyBytes, LevelBytes and BoundaryBytes; OtherMeshBytes: the other meshes with all of
   *   this; DirectoryBytes: headers and tables;
   * - PointError (vtkDoubleArray): largest difference between a coordinate of the file and that of
   *   the input, of the pieces of this process;
   * - JoinedPoints: points of pieces that are the points of other pieces;
   * - BytesSent: what this process has sent to the others of Controller. A broadcast counts once
   * per receiver.
   */
  vtkTable* GetStatistics();

  /**
   * Key in the information of a point array of integers (vtkAbstractArray::GetInformation): if it
   * is 1, points of pieces are joined by this array, in place of their global ids or coordinates:
   * those with equal numbers of 0 and more. A point with a negative number is in no other piece.
   * The array has one component, and is not written; a piece without it is an error. No effect if
   * the mesh does not come in pieces.
   */
  static vtkInformationIntegerKey* JOIN_POINTS();

protected:
  vtkGatunWriter();
  ~vtkGatunWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /** Not used: RequestData does the work, a time step a call. */
  void WriteData() override {}

  char* FileName = nullptr;
  int KeepOrder = KEEP_NONE;
  int ChunkSize = 0;
  int KeyStepInterval = 8;
  int Profile = PROFILE_FAST;
  int Hierarchy = HIERARCHY_OFF;
  int Levels = 0;
  bool WriteBoundary = false;
  std::string LayerArray;
  int LayerComponent = -1;
  int NumberOfLayers = 0;
  int LayerSpacing = LAYERS_HISTOGRAM;
  bool WriteAllTimeSteps = false;
  bool FillMissingArrays = false;
  bool Append = false;
  bool SplitCells = false;
  int PointToleranceKind = TOLERANCE_NONE;
  double PointTolerance = 0;
  int NumberOfPieces = 1;
  vtkMultiProcessController* Controller = nullptr;

private:
  vtkGatunWriter(const vtkGatunWriter&) = delete;
  void operator=(const vtkGatunWriter&) = delete;

  bool WriteSteps();
  bool WritePieces();
  void WriteTogether();
  void WritePiece(vtkDataObject* input);
  void WriteStep(vtkDataObject* input);
  bool HandleFailure() noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
