// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunMeshReaderInternals_h
#define vtkGatunMeshReaderInternals_h

#include "gatunArrayChoice.h"
#include "gatunFileSignature.h"
#include "gatunPieceReader.h"
#include "gatunPublishedFile.h"
#include "gatunSimplifyTarget.h"
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
  std::shared_ptr<gatun::SharedFile> File;
  // Bumped when the file changed on disk, or when what was read last must not be kept.
  vtkTimeStamp FileTime;
  bool ReadAgain = false;

  gatun::ArrayChoice PointArrays;
  gatun::ArrayChoice CellArrays;
  gatun::PieceReader Pieces;
  gatun::SurfaceCells Cells; // of the surface that was read last

  void Close()
  {
    this->Pieces.Close();
    this->Cells = {};
    this->File.reset();
    this->Table = nullptr;
  }

  bool IsOpen(const std::string& path) const { return this->File && this->Path == path; }
  const gatun::FileReader& GetFile() const { return *this->File->GetFile(); }

  static std::uint64_t GetBudget(const vtkGatunMeshReader& reader);
  void Open(const vtkGatunMeshReader& reader);

  /** The table of chunks, made at the first call. Null if no file is open. */
  vtkTable* GetTable();

  static gatun::SimplifyProperties GetProperties(const vtkGatunMeshReader& reader);
  static bool Simplifies(const vtkGatunMeshReader& reader);
  std::size_t CountMerges(const vtkGatunMeshReader& reader) const;
  bool IsOnDemand(const vtkGatunMeshReader& reader) const;
  gatun::PublishedFile Describe(const vtkGatunMeshReader& reader) const;
  static void Publish(gatun::PublishedFile contents, vtkInformation* outInfo);
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
