// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunWriter
 * @brief Writes a tetrahedral vtkUnstructuredGrid as a compressed mesh (`.gtn`), without loss.
 *
 * *Input.* A vtkUnstructuredGrid of vtkTetra cells with 32- or 64-bit ids and float or double
 * points, which is not copied. Points of integer types are converted to double with a warning. It
 * is an error if the conversion is not exact. Meshes without points or cells are valid, and so are
 * unused and duplicate points, NaN and infinite coordinates, flat, inverted and duplicate
 * tetrahedra, and faces shared by more than two tetrahedra.
 *
 * *Arrays.* Point, cell and field arrays of all numeric VTK types including bits, and field arrays
 * of strings, are written with component names and attribute roles (active scalars, ..., global
 * ids). Arrays with a memory layout other than consecutive tuples are copied. String and variant
 * arrays of points or cells are an error. Field arrays of variants are skipped with a warning.
 *
 * *Other cells.* Linear 3D cells (vtkHexahedron, vtkVoxel, vtkWedge, vtkPyramid,
 * vtkPentagonalPrism, vtkHexagonalPrism) are split by vtkDataSetTriangleFilter with a warning. The
 * new cell array OriginalCellIds contains the cells of the input, unless the input has an array of
 * that name. Global ids of cells lose their role, because they are no longer unique.
 * vtkQuadraticTetra needs LinearizeQuadratic. All other cells are an error that names their types.
 *
 * *Ghosts.* Cells marked DUPLICATECELL in vtkGhostType are skipped, and so are points that only
 * they use. The marks of duplicates are cleared. Other marks (hidden cells and points) are kept.
 *
 * *Time.* With WriteAllTimeSteps, one file contains all time steps of the input over one mesh. It
 * is an error if the mesh or the list of arrays changes. Otherwise the current step is written,
 * with its time if it has one (vtkDataObject::DATA_TIME_STEP()).
 *
 * The file appears at its path when it is complete. After an error or an abort, an existing file is
 * unchanged. A read-only file is replaced with ReplaceReadOnly only.
 *
 * *Cost.* Peak memory is below 3 times the size of the mesh and one step of its arrays, including
 * the input. If cells are split, the split mesh is additional. The writer uses all threads of
 * vtkSMPTools. The bytes do not depend on their number.
 *
 * *Errors.* Reported by vtkErrorMacro with a message that begins with the file's name; Write then
 * returns 0 and GetErrorCode is one of vtkErrorCode::NoFileNameError, CannotOpenFileError (the
 * folder is missing, no permission, or a read-only file is there), OutOfDiskSpaceError,
 * UnknownError (such as too little memory, or because the input's pipeline failed or threw),
 * WrongInputError or AbortedError (without a message).
 *
 * @warning The whole mesh must fit into memory.
 * @warning Readers return points and cells in another order unless KeepOrder is set.
 *
 * @sa vtkGatunReader vtkGatunMergeBlocks
 */

#ifndef vtkGatunWriter_h
#define vtkGatunWriter_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkWriter.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkDataArraySelection;
class vtkUnstructuredGrid;

class VTKGATUNIO_EXPORT vtkGatunWriter : public vtkWriter
{
public:
  static vtkGatunWriter* New();
  vtkTypeMacro(vtkGatunWriter, vtkWriter);
  using vtkAlgorithm::Update;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Error codes beyond those of vtkErrorCode.
   */
  enum ErrorIds
  {
    WrongInputError = 40007, ///< the grid cannot be written as it is
    AbortedError = 40008     ///< AbortExecute was set
  };

  /**
   * Flags for SetKeepOrder.
   */
  enum KeepOrderFlags
  {
    KEEP_NONE = 0,
    KEEP_POINTS = 1,  ///< points and their arrays
    KEEP_CELLS = 2,   ///< tetrahedra and their arrays
    KEEP_CORNERS = 4, ///< corners of each tetrahedron
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
   * The arrays to write, by name. WriteUnlistedArrays determines whether arrays that the selection
   * does not list are written. Arrays without a name are always written. Default: empty.
   */
  vtkDataArraySelection* GetPointDataArraySelection();
  vtkDataArraySelection* GetCellDataArraySelection();
  ///@}

  ///@{
  /**
   * Whether to write arrays that the selections do not list. Default: on.
   */
  vtkSetMacro(WriteUnlistedArrays, bool);
  vtkGetMacro(WriteUnlistedArrays, bool);
  vtkBooleanMacro(WriteUnlistedArrays, bool);
  ///@}

  ///@{
  /**
   * The parts of the original order that the file keeps for the reader to restore: KEEP_NONE,
   * KEEP_ALL, or a sum of flags. Each flag increases the file size. With KEEP_ALL, all arrays are
   * read as they were written. The order is that after splitting cells, skipping ghosts and
   * linearizing quadratic cells. Range: 0 to 7. Default: KEEP_NONE.
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
   * The maximum number of tetrahedra in a chunk, the smallest part that can be read: 64 to 1048576,
   * or 0 for 65536 (262144 for meshes of more than 10 million tetrahedra; half of that with
   * layers). Small chunks make larger files. Default: 0.
   */
  virtual void SetChunkTets(int tets);
  vtkGetMacro(ChunkTets, int);
  ///@}

  ///@{
  /**
   * The interval of key steps, which are stored without reference to the previous step. With a
   * small interval, readers access arbitrary steps faster. With a large one, files are smaller.
   * Range: 1 and more. Default: 8.
   */
  vtkSetClampMacro(KeyStepInterval, int, 1, VTK_INT_MAX);
  vtkGetMacro(KeyStepInterval, int);
  ///@}

  ///@{
  /**
   * Whether to store a merge tree, so that the mesh can be read and drawn with any number of points
   * (vtkGatunReader::SimplificationRatio, vtkGatunVolumeMapper). The tree contains the edge
   * collapses that vtkGatunSimplify performs for the values of the first time step. It takes the
   * time and memory of that filter. Default: off.
   */
  vtkSetMacro(Hierarchy, bool);
  vtkGetMacro(Hierarchy, bool);
  vtkBooleanMacro(Hierarchy, bool);
  ///@}

  ///@{
  /**
   * The maximum number of base meshes to store with the hierarchy: with half of the points, a
   * quarter, an eighth and so on, down to 20,000 tetrahedra. With them, reading a coarse mesh costs
   * as much as reading a mesh with at most twice as many points. They make the file up to twice as
   * large. Without effect if Hierarchy is off. Range: 0 to 64. Default: 0.
   */
  vtkSetClampMacro(Levels, int, 0, 64);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * The error metric of the hierarchy, METRIC_MASS or METRIC_DENSITY (default: METRIC_MASS), and
   * the weight of the shape of the boundary, 0 to 1 (default: 0.5). See vtkGatunSimplify.
   */
  enum MetricType
  {
    METRIC_MASS = 0,
    METRIC_DENSITY = 1
  };
  vtkSetClampMacro(Metric, int, METRIC_MASS, METRIC_DENSITY);
  vtkGetMacro(Metric, int);
  vtkSetMacro(BoundaryWeight, double);
  vtkGetMacro(BoundaryWeight, double);
  ///@}

  ///@{
  /**
   * The point array that organizes the file by layers. The range of its values at the first time
   * step is divided into layers, and tetrahedra of the same layers are in the same chunks.
   * Isosurfaces then need few chunks. The file size grows with the number of layers. Base meshes
   * have layers, too. Empty or null: no layers. Default: null.
   */
  vtkSetStringMacro(LayerArray);
  vtkGetStringMacro(LayerArray);
  ///@}

  ///@{
  /**
   * The component of LayerArray that defines the layers, or -1 for the length of its tuples. For
   * arrays with one component, -1 is that component. Range: -1 to 65535. Default: -1.
   */
  vtkSetClampMacro(LayerComponent, int, -1, 65535);
  vtkGetMacro(LayerComponent, int);
  ///@}

  ///@{
  /**
   * The maximum number of layers. Empty layers are left out. 0: a number that suits the size of the
   * mesh, such as 4 below 5.8 million tetrahedra. Range: 0 to 4096. Default: 0.
   */
  vtkSetClampMacro(NumberOfLayers, int, 0, 4096);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  ///@{
  /**
   * The spacing of the layers: layers of equal width, quantiles of the normal distribution with the
   * values' mean and deviation, or about equal numbers of tetrahedra. Default: LAYERS_HISTOGRAM.
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
   * The weight of a point array in the hierarchy relative to others, 0 or more. If no weights are
   * set, the active scalars have weight 1, or all point arrays if there are no active scalars.
   */
  void SetArrayWeight(const char* name, double weight);
  double GetArrayWeight(const char* name);
  void ClearArrayWeights();
  ///@}

  ///@{
  /**
   * Whether to write all time steps of the input instead of the current one. Default: off.
   */
  vtkSetMacro(WriteAllTimeSteps, bool);
  vtkGetMacro(WriteAllTimeSteps, bool);
  vtkBooleanMacro(WriteAllTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Whether to write quadratic tetrahedra as linear ones, without mid-edge points. If off, they are
   * an error. Default: off.
   */
  vtkSetMacro(LinearizeQuadratic, bool);
  vtkGetMacro(LinearizeQuadratic, bool);
  vtkBooleanMacro(LinearizeQuadratic, bool);
  ///@}

  ///@{
  /**
   * Whether to replace an existing file that is marked read-only or that the user may not write. If
   * off, such a file is an error. Default: off.
   */
  vtkSetMacro(ReplaceReadOnly, bool);
  vtkGetMacro(ReplaceReadOnly, bool);
  vtkBooleanMacro(ReplaceReadOnly, bool);
  ///@}

  /**
   * Writes the file, even if nothing has changed since the last time. Returns 1 on success and 0 on
   * failure. GetErrorCode returns the reason.
   */
  int Write() override;

  ///@{
  /**
   * Equivalent to Write.
   */
  void Update() override;
  void Update(int port) override;
  ///@}

  ///@{
  /**
   * Statistics of the last successful Write: numbers of points, tetrahedra and time steps (1
   * without time), and sizes in bytes of the file, connectivity, coordinates, the kept order, all
   * point and cell arrays, field data, merge tree, base meshes, and the rest. Initially 0.
   */
  vtkGetMacro(WrittenPoints, vtkTypeUInt64);
  vtkGetMacro(WrittenTets, vtkTypeUInt64);
  vtkGetMacro(WrittenSteps, vtkTypeUInt64);
  vtkGetMacro(FileBytes, vtkTypeUInt64);
  vtkGetMacro(ConnectivityBytes, vtkTypeUInt64);
  vtkGetMacro(GeometryBytes, vtkTypeUInt64);
  vtkGetMacro(OrderBytes, vtkTypeUInt64);
  vtkGetMacro(ArrayBytes, vtkTypeUInt64);
  vtkGetMacro(FieldDataBytes, vtkTypeUInt64);
  vtkGetMacro(HierarchyBytes, vtkTypeUInt64);
  vtkGetMacro(LevelBytes, vtkTypeUInt64);
  vtkGetMacro(DirectoryBytes, vtkTypeUInt64);
  ///@}

  /**
   * Returns the statistics as lines of text, with bits per tetrahedron and a line for each array.
   */
  std::string GetStatistics() const;

protected:
  vtkGatunWriter();
  ~vtkGatunWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Not used. Each call of RequestData writes a time step.
   */
  void WriteData() override {}

  char* FileName = nullptr;
  bool WriteUnlistedArrays = true;
  int KeepOrder = KEEP_NONE;
  int ChunkTets = 0;
  int KeyStepInterval = 8;
  bool Hierarchy = false;
  int Levels = 0;
  int Metric = METRIC_MASS;
  double BoundaryWeight = 0.5;
  char* LayerArray = nullptr;
  int LayerComponent = -1;
  int NumberOfLayers = 0;
  int LayerSpacing = LAYERS_HISTOGRAM;
  bool WriteAllTimeSteps = false;
  bool LinearizeQuadratic = false;
  bool ReplaceReadOnly = false;

  vtkTypeUInt64 WrittenPoints = 0;
  vtkTypeUInt64 WrittenTets = 0;
  vtkTypeUInt64 WrittenSteps = 0;
  vtkTypeUInt64 FileBytes = 0;
  vtkTypeUInt64 ConnectivityBytes = 0;
  vtkTypeUInt64 GeometryBytes = 0;
  vtkTypeUInt64 OrderBytes = 0;
  vtkTypeUInt64 ArrayBytes = 0;
  vtkTypeUInt64 FieldDataBytes = 0;
  vtkTypeUInt64 HierarchyBytes = 0;
  vtkTypeUInt64 LevelBytes = 0;
  vtkTypeUInt64 DirectoryBytes = 0;

private:
  vtkGatunWriter(const vtkGatunWriter&) = delete;
  void operator=(const vtkGatunWriter&) = delete;

  bool WriteSteps();
  void WriteStep(vtkUnstructuredGrid* input);
  bool HandleFailure() noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
