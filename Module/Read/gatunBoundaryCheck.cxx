// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBoundaryCheck.h"

#include "gatunBytes.h"
#include "gatunContainer.h"
#include "gatunFileReaderInternals.h"
#include "gatunPieceCells.h"
#include "gatunPieceDecoder.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

namespace gatun
{
namespace
{
MeshInput MakeInput(
  const FileReader& file, const PieceTarget& target, std::size_t points, std::size_t cells)
{
  MeshInput input;
  input.Points = points;
  input.CoordinateType = file.GetCoordinateType();
  input.Coordinates = target.Points;
  input.Cells = cells;
  input.Connectivity = target.Connectivity;
  input.WideIds = target.WideIds;
  input.Types = target.Types;
  input.Offsets = target.Offsets;
  input.FaceLocations = target.FaceLocations;
  input.Faces = target.Faces;
  return input;
}

/** Hashes faces by what a file has at their points and for their cells. */
class FaceHasher
{
public:
  FaceHasher(const FileReader& file, const PieceRequest& request, const PieceTarget& target)
  {
    this->Points.push_back(
      { static_cast<const std::uint8_t*>(target.Points), 3 * SizeOf(file.GetCoordinateType()) });
    for (std::size_t i = 0; i < request.Arrays.size(); ++i)
    {
      const auto& array = file.GetArrays()[request.Arrays[i]];
      auto& values = array.Where == Association::Point ? this->Points : this->Cells;
      values.push_back({ static_cast<const std::uint8_t*>(target.Arrays[i]),
        array.Components * SizeOf(array.Type) });
    }
  }

  /** Does not depend on the order of the corners. before: that of the time step before. */
  std::uint64_t Hash(std::uint64_t before, std::span<const std::uint32_t> corners, std::size_t cell)
  {
    std::uint64_t sum = corners.size();
    for (const auto corner : corners)
    {
      sum += this->HashTuples(this->Points, corner);
    }
    ByteWriter all;
    all.Put(before);
    all.Put(sum);
    all.Put(this->HashTuples(this->Cells, cell));
    return Checksum(all.Data);
  }

private:
  struct Tuples
  {
    const std::uint8_t* Values;
    std::size_t Size;
  };

  std::uint64_t HashTuples(const std::vector<Tuples>& arrays, std::size_t tuple)
  {
    this->Buffer.clear();
    for (const auto& array : arrays)
    {
      const auto* const first = array.Values + tuple * array.Size;
      this->Buffer.insert(this->Buffer.end(), first, first + array.Size);
    }
    return Checksum(this->Buffer);
  }

  std::vector<Tuples> Points;
  std::vector<Tuples> Cells;
  Bytes Buffer;
};
}

//------------------------------------------------------------------------------
BoundaryCheck::BoundaryCheck(const FileReader& file)
  : File(file)
{
  if (file.HasBoundary() && file.GetNumberOfPoints() > std::numeric_limits<std::uint32_t>::max())
  {
    InternalsOf(file).File.Fail(
      ErrorCode::Corrupt, "there is a boundary of a mesh of more than 2^32 points");
  }
}

//------------------------------------------------------------------------------
void BoundaryCheck::BeginPart(bool isOneOfMany)
{
  this->EndPart();
  this->IsOneOfMany = isOneOfMany;
  this->HasFaces = false;
}

//------------------------------------------------------------------------------
void BoundaryCheck::FindFaces(
  const MeshAccess& mesh, const PieceRequest& request, const std::int64_t* numbers)
{
  // The points of several chunks come first, then those of one.
  auto own = request.WithUnusedPoints ? this->File.GetNumberOfUnusedPoints() : 0;
  for (const auto chunk : request.Chunks)
  {
    own += this->File.GetChunks()[chunk].OwnPoints;
  }
  const auto shared = this->IsOneOfMany ? mesh.GetMesh().Points - own : 0;
  std::vector<std::uint32_t> all(static_cast<std::size_t>(mesh.GetMesh().Cells));
  std::iota(all.begin(), all.end(), 0u);
  this->Faces = FindOpenFaces(
    mesh, all, [&](std::uint32_t point) { return static_cast<std::uint32_t>(numbers[point]); },
    [&](std::uint32_t point) { return point < shared; });
  std::vector<std::uint32_t> corners;
  std::erase_if(
    all, [&](std::uint32_t cell) { return !FindSurfaceCell(mesh, cell, corners).has_value(); });
  this->Cells = std::move(all);
  this->Hashes.assign(this->Faces.size() + this->Cells.size(), 0);
  this->HasFaces = true;
}

//------------------------------------------------------------------------------
void BoundaryCheck::AddStep(
  const PieceRequest& request, const PieceTarget& target, std::size_t points, std::size_t cells)
{
  if (!this->File.HasBoundary())
  {
    return;
  }
  const MeshAccess mesh(MakeInput(this->File, target, points, cells));
  if (!this->HasFaces)
  {
    this->FindFaces(mesh, request, target.GlobalPointIds);
  }
  FaceHasher hasher(this->File, request, target);
  std::vector<std::uint32_t> corners;
  auto hash = this->Hashes.begin();
  for (const auto& face : this->Faces)
  {
    FindCorners(mesh, face, corners);
    *hash = hasher.Hash(*hash, corners, face.Cell);
    ++hash;
  }
  for (const auto cell : this->Cells)
  {
    FindSurfaceCell(mesh, cell, corners);
    *hash = hasher.Hash(*hash, corners, cell);
    ++hash;
  }
}

//------------------------------------------------------------------------------
/** Moves what is known of the current part to that of all parts. */
void BoundaryCheck::EndPart()
{
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    auto& face = this->AllFaces.emplace_back(this->Faces[i]);
    face.Cell = static_cast<std::uint32_t>(this->FaceHashes.size());
    this->FaceHashes.push_back(this->Hashes[i]);
  }
  this->CellHashes.insert(this->CellHashes.end(),
    this->Hashes.begin() + static_cast<std::ptrdiff_t>(this->Faces.size()), this->Hashes.end());
  this->Faces.clear();
  this->Cells.clear();
  this->Hashes.clear();
}

//------------------------------------------------------------------------------
/** The hashes of the faces of the boundary in the file. */
std::vector<std::uint64_t> BoundaryCheck::HashBoundary() const
{
  const auto file = this->File.OpenBoundary();
  PieceDecoder decoder(file);
  PieceRequest request;
  request.Form = PieceForm::Original;
  request.Chunks.resize(file->GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  for (std::uint32_t a = 0; file->GetNumberOfSteps() > 0 && a < file->GetArrays().size(); ++a)
  {
    request.Arrays.push_back(a);
  }
  std::vector<std::uint64_t> hashes;
  for (std::size_t step = 0; step < std::max<std::size_t>(1, file->GetNumberOfSteps()); ++step)
  {
    request.Step = step;
    decoder.SetRequest(request);
    const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
    const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
    PieceCells memory(decoder.IsTetrahedral(), cells,
      static_cast<std::size_t>(decoder.GetConnectivitySize()),
      static_cast<std::size_t>(decoder.GetFacesSize()));
    PieceTarget target = memory.GetTarget();
    Bytes coordinates(points * 3 * SizeOf(file->GetCoordinateType()));
    target.Points = coordinates.data();
    std::vector<Bytes> values;
    for (const auto a : request.Arrays)
    {
      const auto& array = file->GetArrays()[a];
      values.emplace_back((array.Where == Association::Point ? points : cells) * array.Components *
        SizeOf(array.Type));
      target.Arrays.push_back(values.back().data());
    }
    decoder.Fill(target);
    hashes.resize(cells);
    const MeshAccess mesh(MakeInput(*file, target, points, cells));
    FaceHasher hasher(*file, request, target);
    std::vector<std::uint32_t> corners;
    for (std::uint32_t cell = 0; cell < cells; ++cell)
    {
      corners.clear();
      mesh.ForEachPoint(
        cell, [&](std::uint64_t point) { corners.push_back(static_cast<std::uint32_t>(point)); });
      hashes[cell] = hasher.Hash(hashes[cell], corners, cell);
    }
  }
  return hashes;
}

//------------------------------------------------------------------------------
void BoundaryCheck::Compare()
{
  if (!this->File.HasBoundary())
  {
    return;
  }
  this->EndPart();
  KeepSingleFaces(this->AllFaces);
  std::vector<std::uint64_t> expected = std::move(this->CellHashes);
  for (const auto& face : this->AllFaces)
  {
    expected.push_back(this->FaceHashes[face.Cell]);
  }
  auto found = this->HashBoundary();
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  if (found != expected)
  {
    InternalsOf(this->File)
      .File.Fail(ErrorCode::Corrupt,
        found.size() != expected.size()
          ? "the boundary in the file has " + std::to_string(found.size()) +
            " faces, and that of the mesh " + std::to_string(expected.size())
          : "the boundary in the file has other faces or values than that of the mesh");
  }
}
}
