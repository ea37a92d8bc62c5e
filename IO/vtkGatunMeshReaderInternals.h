// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunMeshReaderInternals_h
#define vtkGatunMeshReaderInternals_h

#include "gatunArrayChoice.h"
#include "gatunFileSettings.h"
#include "gatunFileSignature.h"
#include "gatunPieceReader.h"
#include "gatunPublishedFile.h"
#include "gatunSimplifyProperties.h"
#include "gatunStatistics.h"
#include "gatunStepPrefetcher.h"
#include "gatunSurfaceGrid.h"
#include "vtkGatunMeshReader.h"

#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/** The file of a reader, and the settings of the reader as the core takes them. Methods throw
 * gatun::Error. */
class vtkGatunMeshReader::vtkInternals
{
public:
  // The file, as it was when opened.
  std::string Path;
  gatun::FileSignature Signature;
  std::shared_ptr<gatun::SharedFile> Series; // the file, and its first mesh
  std::shared_ptr<gatun::SharedFile> File;   // the mesh in use
  // Bumped when the file changed on disk, or when what was read last must not be kept.
  vtkTimeStamp FileTime;
  bool ReadAgain = false;

  gatun::ArrayChoice PointArrays;
  gatun::ArrayChoice CellArrays;
  gatun::PieceReader Pieces;
  gatun::StepPrefetcher Prefetcher;
  gatun::Statistics Statistics;
  gatun::SurfaceCells Cells; // of the surface that was read last

  void Close()
  {
    this->Prefetcher.Stop();
    this->Pieces.Close();
    this->Cells = {};
    this->File.reset();
    this->Series.reset();
    this->Table = nullptr;
  }

  bool IsOpen(const std::string& path) const { return this->File && this->Path == path; }

  /** The mesh in use. */
  const gatun::FileReader& GetFile() const { return *this->File->GetFile(); }

  static std::uint64_t GetBudget(const vtkGatunMeshReader& reader);
  void Open(const vtkGatunMeshReader& reader);

  /** Uses the mesh of the time step that is asked for in the information of an output. */
  void UseMesh(vtkInformation* outInfo);

  /** The same, but if that mesh is damaged, uses the first one: the time may be an earlier one. */
  void TryMesh(vtkInformation* outInfo);

  /** The table of chunks of the mesh in use, made at the first call. Null if no file is open. */
  vtkTable* GetTable();

  /** Publishes the table of chunks of the mesh in use, unless it is large. */
  void PublishTable(vtkInformation* outInfo);

  static bool HasValueRange(const vtkGatunMeshReader& reader);
  static bool HasRegion(const vtkGatunMeshReader& reader);
  static gatun::SimplifyProperties GetProperties(const vtkGatunMeshReader& reader);
  gatun::FileSettings GetSettings(const vtkGatunMeshReader& reader) const;
  void Publish(const vtkGatunMeshReader& reader, vtkInformation* outInfo) const;
  std::vector<std::uint32_t> ChunksOf(const vtkGatunMeshReader& reader, std::size_t step) const;
  void MakeOutline(const gatun::PublishedFile& handle, const gatun::PortRequest& port,
    vtkUnstructuredGrid* output);
  std::optional<std::size_t> FindBoundaryMerges(const gatun::PublishedFile& handle) const;
  void ReadBoundary(const gatun::PublishedFile& handle, std::size_t merges,
    const gatun::PortRequest& port, vtkUnstructuredGrid* output,
    const gatun::PieceReader::Progress& progress);
  void MakeSurface(vtkUnstructuredGrid* grid, vtkPolyData* output);

private:
  vtkSmartPointer<vtkTable> Table;
};

#endif
