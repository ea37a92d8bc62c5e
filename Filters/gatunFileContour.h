// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileContour_h
#define gatunFileContour_h

#include "gatunContourSettings.h"
#include "gatunFileSurface.h"

#include <cstddef>
#include <cstdint>
#include <memory>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkInformation;
class vtkPolyData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
struct PublishedFile;
class SharedFile;

/** Makes isosurfaces of the file behind a reader. Keeps decoded data for the next isovalues. */
class FileContour
{
public:
  /** InInfo: of the input, with the time; outInfo: with the piece. Throws Error. */
  void Fill(const PublishedFile& handle, const ContourSettings& settings, vtkInformation* inInfo,
    vtkInformation* outInfo, const ContourProgress& progress, vtkPolyData* output);

  /** Lets go of the file. */
  void Close();

  std::size_t GetNumberOfChunks() const;
  std::uint64_t GetBytesRead() const;

  /** The number of cells if none are 3D, else 0. */
  std::uint64_t CountFlatCells() const;

  /** Of the surface made last. */
  const FileSurfaceStatistics& GetStatistics() const { return this->Statistics; }
  void ClearStatistics() { this->Statistics = {}; }

private:
  void Open(const PublishedFile& handle);

  std::shared_ptr<SharedFile> File;
  std::size_t Merges = 0;
  std::unique_ptr<FileSurface> Extractor; // of that file after these merges
  FileSurfaceStatistics Statistics;
};
}

#endif
