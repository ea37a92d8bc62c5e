// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPortMesh.h"

#include "gatunError.h"
#include "gatunMergeBuilder.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <optional>
#include <utility>

namespace gatun::port
{
namespace
{
constexpr std::uint32_t SmallestChunk = 64;

/** The points and tetrahedra that a builder of merges needs. */
struct Tets
{
  std::vector<std::array<double, 3>> Points;
  std::vector<MergeTree::Tet> Cells;
  std::vector<double> Field;
};

Tets MakeTets(const PortPiece& piece, ScalarType type)
{
  Tets tets;
  tets.Points.resize(static_cast<std::size_t>(piece.Points));
  tets.Cells.resize(piece.Ids.size() / 4);
  for (std::size_t i = 0; i < 3 * tets.Points.size(); ++i)
  {
    float single = 0;
    double number = 0;
    const auto* const bytes = piece.Coordinates.data() + i * SizeOf(type);
    if (type == ScalarType::Float32)
    {
      std::memcpy(&single, bytes, sizeof(single));
      number = single;
    }
    else
    {
      std::memcpy(&number, bytes, sizeof(number));
    }
    tets.Points[i / 3][i % 3] = number;
  }
  for (std::size_t i = 0; i < piece.Ids.size(); ++i)
  {
    tets.Cells[i / 4][i % 4] = static_cast<std::uint32_t>(piece.Ids[i]);
  }
  for (const auto& x : tets.Points)
  {
    tets.Field.push_back(x[0] * x[1] - x[2]);
  }
  return tets;
}

MergeTree MakeTree(const PortPiece& piece, ScalarType type)
{
  const auto tets = MakeTets(piece, type);
  return BuildMergeTree({ tets.Points, tets.Cells, { { tets.Field, 1 } } });
}

std::vector<const void*> GetPointers(const PortPiece& piece)
{
  std::vector<const void*> pointers;
  for (const auto& array : piece.Arrays)
  {
    pointers.push_back(array.data());
  }
  return pointers;
}
}

//------------------------------------------------------------------------------
void PortPiece::AddTo(Hash& hash) const
{
  hash.Add(this->Coordinates);
  hash.Add(this->Ids);
  if (!this->IsTetrahedral)
  {
    hash.Add(this->Offsets);
    hash.Add(this->Types);
    hash.Add(this->FaceLocations);
    hash.Add(this->Faces);
  }
  hash.Add(this->GlobalPointIds);
  hash.Add(this->GlobalCellIds);
  for (const auto& array : this->Arrays)
  {
    hash.Add(array);
  }
}

//------------------------------------------------------------------------------
MeshInput PortPiece::GetInput(const FileReader& file) const
{
  MeshInput input;
  input.Points = this->Points;
  input.CoordinateType = file.GetCoordinateType();
  input.Coordinates = this->Coordinates.data();
  input.PointArray = file.GetPointArray();
  input.Cells = this->Cells;
  input.Connectivity = this->Ids.data();
  if (!this->IsTetrahedral)
  {
    input.Types = this->Types.data();
    input.Offsets = this->Offsets.data();
    input.FaceLocations = this->Faces.empty() ? nullptr : this->FaceLocations.data();
    input.Faces = this->Faces.empty() ? nullptr : this->Faces.data();
    input.FacesSize = this->Faces.size();
  }
  return input;
}

//------------------------------------------------------------------------------
bool PortPiece::IsSameMesh(const PortPiece& other) const
{
  return this->Coordinates == other.Coordinates && this->Ids == other.Ids &&
    this->Types == other.Types && this->Offsets == other.Offsets && this->Faces == other.Faces &&
    this->Arrays == other.Arrays;
}

//------------------------------------------------------------------------------
PortPiece Decode(const std::shared_ptr<const FileReader>& file, const PortRequest& how)
{
  PieceRequest request;
  request.Chunks.resize(file->GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.Form = how.Form;
  request.RestoreOrder = how.RestoreOrder;
  request.WithUnusedPoints = how.Form == PieceForm::Original;
  request.Step = how.Step;
  request.Merges = how.Merges;
  request.Tree = how.Tree;
  if (how.Step < file->GetNumberOfSteps())
  {
    request.Arrays.resize(file->GetArrays().size());
    std::iota(request.Arrays.begin(), request.Arrays.end(), 0u);
  }
  PieceDecoder decoder(file);
  decoder.SetRequest(request);

  PortPiece piece;
  piece.Points = decoder.GetNumberOfPoints();
  piece.Cells = decoder.GetNumberOfCells();
  piece.IsTetrahedral = decoder.IsTetrahedral();
  const auto points = static_cast<std::size_t>(piece.Points);
  const auto cells = static_cast<std::size_t>(piece.Cells);
  piece.Coordinates.resize(3 * points * SizeOf(file->GetCoordinateType()));
  piece.Ids.resize(static_cast<std::size_t>(decoder.GetConnectivitySize()));
  piece.GlobalPointIds.resize(points);
  piece.GlobalCellIds.resize(cells);
  PieceTarget target;
  target.Points = piece.Coordinates.data();
  target.Connectivity = piece.Ids.data();
  target.GlobalPointIds = piece.GlobalPointIds.data();
  target.GlobalCellIds = piece.GlobalCellIds.data();
  if (!piece.IsTetrahedral)
  {
    piece.Offsets.resize(cells + 1);
    piece.Types.resize(cells);
    piece.FaceLocations.resize(cells);
    piece.Faces.resize(static_cast<std::size_t>(decoder.GetFacesSize()));
    target.Offsets = piece.Offsets.data();
    target.Types = piece.Types.data();
    target.FaceLocations = piece.FaceLocations.data();
    target.Faces = piece.Faces.data();
  }
  for (const auto index : request.Arrays)
  {
    const auto& array = file->GetArrays()[index];
    const auto tuples = array.Where == Association::Point ? points : cells;
    piece.Arrays.emplace_back(tuples * array.Components * SizeOf(array.Type));
  }
  for (auto& array : piece.Arrays)
  {
    target.Arrays.push_back(array.data());
  }
  decoder.Fill(target);
  return piece;
}

//------------------------------------------------------------------------------
PortMesh::PortMesh(std::shared_ptr<const FileReader> file)
  : File(std::move(file))
{
  if (this->File->GetNumberOfMerges() > 0)
  {
    this->Tree = std::make_shared<const MergeTree>(this->File->GetMergeTree());
  }
  for (std::size_t i = 0; i < std::max<std::size_t>(1, this->File->GetNumberOfSteps()); ++i)
  {
    this->Steps.push_back(Decode(this->File, { .Step = i, .RestoreOrder = false, .Tree = {} }));
  }
}

//------------------------------------------------------------------------------
void PortMesh::AddDecoded(Hash& hash) const
{
  for (std::size_t i = 0; i < this->Steps.size(); ++i)
  {
    this->Steps[i].AddTo(hash);
    Decode(this->File, { .Step = i, .Tree = {} }).AddTo(hash);
    if (!this->File->IsSurface())
    {
      Decode(this->File, { .Step = i, .Form = PieceForm::Tetrahedra, .Tree = {} }).AddTo(hash);
    }
  }
  if (this->Tree)
  {
    const auto half = this->Tree->CountWholeMerges(this->Tree->GetMerges().size() / 2);
    Decode(this->File,
      { .Form = this->File->IsSurface() ? PieceForm::Original : PieceForm::Tetrahedra,
        .Merges = half,
        .Tree = this->Tree })
      .AddTo(hash);
  }
}

//------------------------------------------------------------------------------
WriterOptions PortMesh::GetOptions() const
{
  WriterOptions options;
  options.Keep = KeepAll;
  options.KeyStepInterval = 2;
  options.PointsMove = this->File->HasMovingPoints();
  options.IsSurface = this->File->IsSurface();
  options.Boundary = this->File->HasBoundary();
  options.Tree = this->Tree.get();
  options.Dependencies = this->File->HasDependencies();
  if (const auto chunks = this->File->GetChunks().size(); chunks > 1)
  {
    options.ChunkSize =
      std::max(SmallestChunk, static_cast<std::uint32_t>(this->File->GetNumberOfTets() / chunks));
  }
  if (this->File->HasLayers() && !this->Steps[0].Arrays.empty())
  {
    const auto& layers = this->File->GetLayers();
    options.Layers.emplace();
    options.Layers->Array = layers.Array;
    options.Layers->Component = layers.Component;
    options.Layers->Count = layers.GetCount();
    options.Layers->Values = this->Steps[0].Arrays[layers.Array].data();
  }
  return options;
}

//------------------------------------------------------------------------------
void PortMesh::Write(const std::string& path, const WriterOptions& options) const
{
  FileWriter writer(path, this->Steps[0].GetInput(*this->File), this->File->GetArrays(), options);
  for (std::size_t i = 0; i < this->File->GetNumberOfSteps(); ++i)
  {
    const bool hasTime = this->File->HasTime();
    writer.WriteStep(GetPointers(this->Steps[i]), this->File->GetFieldData(i), hasTime,
      hasTime ? this->File->GetTimes()[i] : 0, {},
      options.PointsMove ? this->Steps[i].Coordinates.data() : nullptr);
  }
  writer.Finish();
}

//------------------------------------------------------------------------------
void PortMesh::Compare(const std::string& path) const
{
  const auto file = std::make_shared<const FileReader>(path);
  for (std::size_t i = 0; i < this->Steps.size(); ++i)
  {
    if (!Decode(file, { .Step = i, .Tree = {} }).IsSameMesh(this->Steps[i]))
    {
      throw Error(ErrorCode::Corrupt, "the mesh does not come back");
    }
  }
}

//------------------------------------------------------------------------------
void AddEncoded(Line& line, const PortMesh& mesh)
{
  auto options = mesh.GetOptions();
  const auto write = [&](const std::string& path) { mesh.Write(path, options); };
  const auto compare = [&](const std::string& path) { mesh.Compare(path); };
  options.Coding = Profile::Small;
  AddBytesOf(line.Encoded["small"], write, compare);
  options.Coding = Profile::Fast;
  AddBytesOf(line.Encoded["fast"], write, compare);
  options.Errors.push_back({ "*", { ErrorKind::Relative, 1e-3 } });
  AddBytesOf(line.Encoded["bounded"], write);
  options.Coding = Profile::Small;
  AddBytesOf(line.Encoded["bounded"], write);
  options.Errors.clear();

  const auto& first = mesh.Steps[0];
  if (first.IsTetrahedral && !first.Ids.empty() && mesh.File->HasAllCells())
  {
    const auto tree = MakeTree(first, mesh.File->GetCoordinateType());
    options.Tree = &tree;
    options.Dependencies = true;
    options.Boundary = true;
    options.Levels = 2;
    AddBytesOf(line.Encoded["tree"], write, compare);
  }
}
}
