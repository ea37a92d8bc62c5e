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
 * Ghosts: cells marked DUPLICATECELL in vtkGhostType are left out, and points that only they use;
 * the marks for duplicates then go, too. Other marks (hidden cells and points) are kept.
 *
 * Time: with WriteAllTimeSteps, all time steps of the input go into one file. If points move, the
 * writer requests the first time steps twice. Cells and the number of points may change: then
 * the file has another mesh from that step on. If an array comes, goes or changes its type, that is
 * an error naming the step; so are points that move and meshes that change with NumberOfPieces or
 * several processes. Without, the step at hand is written, with its time if it has one
 * (vtkDataObject::DATA_TIME_STEP()).
 *
 * The file appears under its name once it is complete; after an error or an abort, an existing
 * file is left unchanged. A read-only file is replaced with ReplaceReadOnly only.
 *
 * Pieces: with NumberOfPieces, the input is asked for one piece after the other, twice, and the
 * whole mesh is never in memory. Points of several pieces become one if they have the same global
 * id (or number of JoinArray), or without ids the same coordinates, and the same values of all
 * arrays at all steps. Points that differ stay apart, with a warning. An input that does not know
 * pieces is one piece. The time steps of a piece follow each other. A hierarchy and layers need the
 * whole mesh and are an error.
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
#include "vtkWriter.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataArraySelection;
class vtkDataObject;
class vtkMultiProcessController;

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
   * Which arrays to write, by name. An array that the selection does not list is written or not as
   * WriteUnlistedArrays says; arrays without a name always are. Default: empty, so all are written.
   */
  vtkDataArraySelection* GetPointDataArraySelection();
  vtkDataArraySelection* GetCellDataArraySelection();
  ///@}

  ///@{
  /**
   * Whether to write arrays that the selections do not list, too. Default: on.
   */
  vtkSetMacro(WriteUnlistedArrays, bool);
  vtkGetMacro(WriteUnlistedArrays, bool);
  vtkBooleanMacro(WriteUnlistedArrays, bool);
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
   * Largest number of tetrahedra in a chunk, the smallest part that can be read: 64 to 1048576, or
   * 0 for 65536 (131072 for meshes of over one million, 262144 for over 10 million; a quarter of it
   * with layers). Of a mesh in pieces, each counts as an equal share of the mesh. Small chunks make
   * larger files. Default: 0.
   */
  virtual void SetChunkTets(int tets);
  vtkGetMacro(ChunkTets, int);
  ///@}

  ///@{
  /**
   * Lets the values of an array have an error: "NAME=abs:0.01", where NAME is that of an array, or
   * "*" for all arrays of floating-point numbers that have no error of their own. What follows is
   * - abs:E, every value differs by at most E, above 0, in its own units;
   * - rel:E, by at most E, above 0 and at most 1, times the range of the finite values of the
   * component at the time step. Constant components are exact;
   * - pw:E, by at most E, above 0 and below 1, times its magnitude;
   * - bits:N, the first N significant binary digits are right after rounding, 1 to 52.
   * Every value is checked while it is written. NaN, infinities, ids (global, pedigree, and all of
   * type vtkIdType) and vtkGhostType stay exact, and integers with errors below 1. The text is
   * checked when the file is written: an unknown kind, a number out of its range, or the name of no
   * array is an error. Default: none; all values are stored without loss.
   */
  virtual void AddError(const char* error);
  virtual void ClearErrors();
  int GetNumberOfErrors() const;
  ///@}

  ///@{
  /**
   * Whether arrays are compressed so that they are read faster. Values are not predicted by
   * quadratic functions then. Files are larger, by 2 to 15 percent, and take one to two thirds of
   * the time to read. Default: off.
   */
  vtkSetMacro(FastArrays, bool);
  vtkGetMacro(FastArrays, bool);
  vtkBooleanMacro(FastArrays, bool);
  ///@}

  ///@{
  /**
   * Whether values of 0 stay exactly 0 in arrays that may have an error. Default: off.
   */
  vtkSetMacro(KeepZeros, bool);
  vtkGetMacro(KeepZeros, bool);
  vtkBooleanMacro(KeepZeros, bool);
  ///@}

  ///@{
  /**
   * Interval of key steps, which are stored without reference to the step before, in time steps, 1
   * or more. A short one makes jumps to any step faster, a long one files smaller. Default: 8.
   */
  vtkSetClampMacro(KeyStepInterval, int, 1, VTK_INT_MAX);
  vtkGetMacro(KeyStepInterval, int);
  ///@}

  ///@{
  /**
   * Whether to store a hierarchy, so that the mesh can be read and drawn with any number of points
   * (vtkGatunReader::SimplificationRatio, vtkGatunVolumeMapper): the order in which
   * vtkGatunSimplify merges points, for the values of the first time step. This takes the time and
   * memory of that filter. Default: off.
   */
  vtkSetMacro(Hierarchy, bool);
  vtkGetMacro(Hierarchy, bool);
  vtkBooleanMacro(Hierarchy, bool);
  ///@}

  ///@{
  /**
   * Largest number of base meshes to store with the hierarchy, 0 to 64: with a half of the points,
   * a quarter and so on, as long as more than 20,000 tetrahedra, or cells of a surface, remain. A
   * coarse mesh then costs as much as one with at most twice as many points. Together they make the
   * file up to twice as large. No effect if Hierarchy is off. Default: 0.
   */
  vtkSetClampMacro(Levels, int, 0, 64);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Whether to store with the hierarchy which merges depend on which, so that the mesh need not be
   * decoded to simplify some places more than others. A million tetrahedra take 3 to 5 bits each,
   * about a second of one processor and 140 MB of memory. No effect without Hierarchy. Default: on.
   */
  vtkSetMacro(WriteDependencies, bool);
  vtkGetMacro(WriteDependencies, bool);
  vtkBooleanMacro(WriteDependencies, bool);
  ///@}

  ///@{
  /**
   * Whether to store the boundary of the mesh with all arrays and time steps, which readers can
   * show without decoding the mesh (vtkGatunMeshReader::OnDemand): the faces that only one 3D cell
   * has (of nonlinear cells, the linear faces with their corners), and the cells of a lower
   * dimension. The mesh must be in one piece and one process; surfaces are refused. Default: off.
   */
  vtkSetMacro(WriteBoundary, bool);
  vtkGetMacro(WriteBoundary, bool);
  vtkBooleanMacro(WriteBoundary, bool);
  ///@}

  ///@{
  /**
   * Metric of the hierarchy, METRIC_MASS (the default) or METRIC_DENSITY, and share of the shape in
   * the cost of a merge on the boundary, 0 to 1 (default: 0.5); see vtkGatunSimplify.
   */
  enum MetricType
  {
    METRIC_MASS = 0,
    METRIC_DENSITY = 1
  };
  vtkSetClampMacro(Metric, int, METRIC_MASS, METRIC_DENSITY);
  vtkGetMacro(Metric, int);
  vtkSetClampMacro(BoundaryWeight, double, 0.0, 1.0);
  vtkGetMacro(BoundaryWeight, double);
  ///@}

  ///@{
  /**
   * For the hierarchy of a surface: edges between triangles whose normals differ by more degrees
   * are kept as the border is, 0 to 180. Default: 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Point array whose range of values, at the first time step, is cut into layers. Tetrahedra of
   * the same layers are put into the same chunks, so that an isosurface needs few of them. The file
   * and its base meshes are organized in this way, and become larger with the number of layers.
   * Empty or null: the file is organized by position only. Default: null.
   */
  vtkSetStringMacro(LayerArray);
  vtkGetStringMacro(LayerArray);
  ///@}

  ///@{
  /**
   * The component of LayerArray to make layers of, or -1 for the length of its tuples. Of arrays
   * with one component, -1 is that component. Range: -1 and more. Default: -1.
   */
  vtkSetClampMacro(LayerComponent, int, -1, 65535);
  vtkGetMacro(LayerComponent, int);
  ///@}

  ///@{
  /**
   * Largest number of layers, 0 to 4096; empty layers are left out. 0: chosen by the size of the
   * mesh, 4 below 5.8 million tetrahedra. Default: 0.
   */
  vtkSetClampMacro(NumberOfLayers, int, 0, 4096);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  ///@{
  /**
   * Layers are equal parts of the range, quantiles of the normal distribution with the mean and
   * deviation of the values, or have about equal numbers of tetrahedra. Default: LAYERS_HISTOGRAM.
   */
  enum LayerSpacingType
  {
    LAYERS_UNIFORM = 1,
    LAYERS_NORMAL = 2,
    LAYERS_HISTOGRAM = 3
  };
  vtkSetClampMacro(LayerSpacing, int, LAYERS_UNIFORM, LAYERS_HISTOGRAM);
  vtkGetMacro(LayerSpacing, int);
  void SetLayerSpacingToUniform() { this->SetLayerSpacing(LAYERS_UNIFORM); }
  void SetLayerSpacingToNormal() { this->SetLayerSpacing(LAYERS_NORMAL); }
  void SetLayerSpacingToHistogram() { this->SetLayerSpacing(LAYERS_HISTOGRAM); }
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
   * Largest difference of each coordinate from that of the input, 0 or more, in the units of the
   * coordinates. 0: coordinates are stored without loss. Else they are rounded to multiples of the
   * largest power of two that keeps the error, before anything else is done; values of arrays stay.
   * Coordinates that are not finite, and integers, stay. A file becomes smaller where a coordinate
   * has at most 65,536 different values. Points of pieces are joined by the rounded coordinates.
   * A number that is not finite is an error. Default: 0.
   *
   * No cell turns over: tetrahedra, and those at the corners of hexahedra, voxels, wedges and
   * pyramids, keep their orientation, and flat ones stay flat, in exact arithmetic. Where they
   * would not, coordinates have finer steps, or stay. It is an error if more than 1 % of the points
   * (and more than 16) need that, or any point of a mesh in several pieces; the message suggests a
   * tolerance that works.
   */
  vtkSetClampMacro(PointError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PointError, double);
  ///@}

  ///@{
  /**
   * The same relative to the longest side of the bounding box, from 0 to less than 1. Needs the
   * mesh in one piece and one process. An error together with PointError or PointBits. Default: 0.
   */
  vtkSetMacro(RelativePointError, double);
  vtkGetMacro(RelativePointError, double);
  ///@}

  ///@{
  /**
   * Bits of each coordinate, 0 to 31. 0: coordinates are stored without loss. Else they are rounded
   * to multiples of the longest side of the bounding box divided by 2^PointBits - 1, from its least
   * corner on. The largest error is then GetWrittenPointError, about half of that. Needs the mesh
   * in one piece and one process. An error together with PointError. Default: 0.
   */
  vtkSetClampMacro(PointBits, int, 0, 31);
  vtkGetMacro(PointBits, int);
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
   * The memory for points on the boundaries of pieces, in MiB, 1 and more; further ones are put
   * into temporary files. Default: 64.
   */
  vtkSetClampMacro(SpillMemory, int, 1, VTK_INT_MAX);
  vtkGetMacro(SpillMemory, int);
  ///@}

  ///@{
  /**
   * The folder of temporary files when the mesh comes in pieces. They have no names where the
   * system allows that, and none remains. Empty or null: the folder of the file. Default: null.
   */
  vtkSetFilePathMacro(SpillFolder);
  vtkGetFilePathMacro(SpillFolder);
  ///@}

  ///@{
  /**
   * Whether to look for all points of a piece in other pieces, in place of those on its boundary.
   * Needed only where lines or surfaces of one piece have points inside another one. Default: off.
   */
  vtkSetMacro(JoinAllPoints, bool);
  vtkGetMacro(JoinAllPoints, bool);
  vtkBooleanMacro(JoinAllPoints, bool);
  ///@}

  ///@{
  /**
   * The point array of integers by which points of pieces are joined, in place of their global ids
   * or coordinates: those with equal numbers of 0 and more. A point with a negative number is in no
   * other piece. Points are joined wherever they are in their pieces, and JoinAllPoints has no
   * effect. The array has one component, and is not written; a piece without it is an error. No
   * effect if the mesh does not come in pieces. Empty or null: none. Default: null.
   */
  vtkSetStringMacro(JoinArray);
  vtkGetStringMacro(JoinArray);
  ///@}

  ///@{
  /**
   * Whether to replace an existing file that is read-only: marked so, or of somebody else. Default:
   * off, where that is an error.
   */
  vtkSetMacro(ReplaceReadOnly, bool);
  vtkGetMacro(ReplaceReadOnly, bool);
  vtkBooleanMacro(ReplaceReadOnly, bool);
  ///@}

  ///@{
  /**
   * Writes the file, even if nothing has changed since it was last written. Write returns 1 on
   * success and 0 on failure; GetErrorCode then gives the reason.
   */
  int Write() override;
  void Update() override;
  void Update(int port) override;
  ///@}

  ///@{
  /**
   * Statistics of the last file written: number of points and cells of all of its meshes, of meshes
   * (1 unless the mesh changes over time) and of time steps (1 without time); bytes of the file and
   * of its parts, which add up to it: of the first mesh connectivity, coordinates, original order,
   * point and cell arrays, field data, hierarchy, its dependencies, base meshes and boundary; the
   * other meshes with all of this; headers and tables. 0 before the first file.
   */
  vtkGetMacro(WrittenPoints, vtkTypeUInt64);
  vtkGetMacro(WrittenCells, vtkTypeUInt64);
  vtkGetMacro(WrittenMeshes, vtkTypeUInt64);
  vtkGetMacro(WrittenSteps, vtkTypeUInt64);
  vtkGetMacro(FileBytes, vtkTypeUInt64);
  vtkGetMacro(ConnectivityBytes, vtkTypeUInt64);
  vtkGetMacro(GeometryBytes, vtkTypeUInt64);
  vtkGetMacro(OrderBytes, vtkTypeUInt64);
  vtkGetMacro(ArrayBytes, vtkTypeUInt64);
  vtkGetMacro(FieldDataBytes, vtkTypeUInt64);
  vtkGetMacro(HierarchyBytes, vtkTypeUInt64);
  vtkGetMacro(DependencyBytes, vtkTypeUInt64);
  vtkGetMacro(LevelBytes, vtkTypeUInt64);
  vtkGetMacro(BoundaryBytes, vtkTypeUInt64);
  vtkGetMacro(OtherMeshBytes, vtkTypeUInt64);
  vtkGetMacro(DirectoryBytes, vtkTypeUInt64);
  ///@}

  /**
   * Largest difference between a coordinate of the last file and that of the input, of the pieces
   * of this process. 0 without PointError, RelativePointError and PointBits.
   */
  vtkGetMacro(WrittenPointError, double);

  /**
   * Bytes that this process has sent to the other ones of Controller for the last file. A broadcast
   * counts once per receiver. 0 without other processes.
   */
  vtkGetMacro(BytesSent, vtkTypeUInt64);

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
  bool WriteUnlistedArrays = true;
  int KeepOrder = KEEP_NONE;
  int ChunkTets = 0;
  int KeyStepInterval = 8;
  bool KeepZeros = false;
  bool FastArrays = false;
  bool Hierarchy = false;
  int Levels = 0;
  bool WriteDependencies = true;
  bool WriteBoundary = false;
  int Metric = METRIC_MASS;
  double BoundaryWeight = 0.5;
  double FeatureAngle = 30;
  char* LayerArray = nullptr;
  int LayerComponent = -1;
  int NumberOfLayers = 0;
  int LayerSpacing = LAYERS_HISTOGRAM;
  bool WriteAllTimeSteps = false;
  bool SplitCells = false;
  bool ReplaceReadOnly = false;
  double PointError = 0;
  double RelativePointError = 0;
  int PointBits = 0;
  int NumberOfPieces = 1;
  int SpillMemory = 64;
  char* SpillFolder = nullptr;
  bool JoinAllPoints = false;
  char* JoinArray = nullptr;
  vtkMultiProcessController* Controller = nullptr;

  vtkTypeUInt64 WrittenPoints = 0;
  vtkTypeUInt64 WrittenCells = 0;
  vtkTypeUInt64 WrittenMeshes = 0;
  vtkTypeUInt64 WrittenSteps = 0;
  vtkTypeUInt64 FileBytes = 0;
  vtkTypeUInt64 ConnectivityBytes = 0;
  vtkTypeUInt64 GeometryBytes = 0;
  vtkTypeUInt64 OrderBytes = 0;
  vtkTypeUInt64 ArrayBytes = 0;
  vtkTypeUInt64 FieldDataBytes = 0;
  vtkTypeUInt64 HierarchyBytes = 0;
  vtkTypeUInt64 DependencyBytes = 0;
  vtkTypeUInt64 LevelBytes = 0;
  vtkTypeUInt64 BoundaryBytes = 0;
  vtkTypeUInt64 OtherMeshBytes = 0;
  vtkTypeUInt64 DirectoryBytes = 0;
  double WrittenPointError = 0;
  vtkTypeUInt64 BytesSent = 0;

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
