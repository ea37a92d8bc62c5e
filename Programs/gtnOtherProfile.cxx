// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnOtherProfile.h"

#include "gtnFailure.h"
#include "gtnMessages.h"

#include "gatunQuantizer.h"

#include "vtkGatunReader.h"
#include "vtkGatunSurfaceReader.h"
#include "vtkGatunWriter.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

namespace gtn
{
namespace
{
/** A folder that goes with this object. */
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::error_code failed;
    const auto parent = std::filesystem::temp_directory_path(failed);
    if (failed)
    {
      throw Failure("no folder for temporary files: " + failed.message());
    }
    this->Path = (parent / "gtn-XXXXXX").string();
    if (!::mkdtemp(this->Path.data()))
    {
      throw Failure(this->Path, std::string("cannot be made: ") + std::strerror(errno));
    }
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string GetFile() const { return this->Path + "/piece.gtn"; }

private:
  std::string Path;
};

bool HasBounds(const gatun::FileReader& file)
{
  for (std::size_t array = 0; file.GetNumberOfSteps() > 0 && array < file.GetArrays().size();
       ++array)
  {
    for (std::size_t c = 0; c < file.GetArrays()[array].Components; ++c)
    {
      if (file.GetRounding(array, c, 0))
      {
        return true;
      }
    }
  }
  return false;
}

double FindBytes(
  vtkAlgorithm* reader, const gatun::FileReader& file, bool isFast, const std::string& path)
{
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->SetKeepOrder(file.GetKeptOrder());
  writer->SetProfile(isFast ? vtkGatunWriter::PROFILE_FAST : vtkGatunWriter::PROFILE_SMALL);
  const bool isWritten = writer->Write() != 0;
  if (const auto errors = TakeErrors(); !isWritten || !errors.empty())
  {
    throw Failure(path, errors.empty() ? "cannot write" : errors.front());
  }
  return writer->GetStatistics()->GetValueByName(0, "FileBytes").ToDouble();
}
}

//------------------------------------------------------------------------------
std::optional<std::uint64_t> EstimateOtherProfile(const gatun::FileReader& file)
{
  // Enough for a chunk of full size.
  constexpr std::uint64_t cellsOfPiece = 200'000;
  if (file.GetNumberOfCells() == 0 || HasBounds(file))
  {
    return {};
  }
  const auto pieces = static_cast<int>(
    std::min<std::uint64_t>(1 + file.GetNumberOfCells() / cellsOfPiece, VTK_INT_MAX));
  const auto reader = file.IsSurface()
    ? vtkSmartPointer<vtkGatunMeshReader>(vtkSmartPointer<vtkGatunSurfaceReader>::New())
    : vtkSmartPointer<vtkGatunMeshReader>(vtkSmartPointer<vtkGatunReader>::New());
  reader->SetFileName(file.GetPath().c_str());
  reader->UpdatePiece(pieces / 2, pieces, 0);
  if (const auto errors = TakeErrors(); !errors.empty())
  {
    throw Failure(file.GetPath(), errors.front());
  }
  const TemporaryFolder folder;
  const bool isFast = file.GetProfile() == gatun::Profile::Fast;
  const double now = FindBytes(reader, file, isFast, folder.GetFile());
  const double other = FindBytes(reader, file, !isFast, folder.GetFile());
  return static_cast<std::uint64_t>(
    static_cast<double>(file.GetStatistics().FileBytes) * other / now);
}
}
