// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// pieces: the mesh in parts, as the ranks of a parallel program read it. region: a part of it only.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunFileReader.h"
#include "gatunParallel.h"
#include "vtkGatunReader.h"
#include "vtkGatunWriter.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <memory>

namespace bench
{
namespace
{

struct PiecesOptions
{
  std::string File;
  int Rounds = 3;
};

/** What one reader, made anew, was asked for and what it gave. */
struct Reading
{
  std::uint64_t Tets = 0;
  std::uint64_t Bytes = 0;
};

Reading Measure(vtkGatunReader* reader, const std::string& file)
{
  if (reader->GetErrorCode() != 0)
  {
    throw Failure(file, "cannot be read");
  }
  return { static_cast<std::uint64_t>(reader->GetOutput()->GetNumberOfCells()),
    reader->GetBytesRead() };
}

Reading ReadPiece(const std::string& file, int piece, int pieces, int ghostLevels)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  reader->UpdatePiece(piece, pieces, ghostLevels);
  return Measure(reader, file);
}

struct PieceCase
{
  int Pieces;
  int GhostLevels;
  std::uint64_t Tets = 0;
  std::uint64_t Bytes = 0;
  std::vector<double> Each = {}; ///< seconds of the slowest piece, one a round
};

void TimePieces(const PiecesOptions& options)
{
  std::vector<PieceCase> cases;
  for (const int pieces : { 1, 2, 4, 8 })
  {
    for (const int ghostLevels : { 0, 1 })
    {
      if (pieces > 1 || ghostLevels == 0)
      {
        cases.push_back({ pieces, ghostLevels });
      }
    }
  }
  std::vector<Operation> operations;
  for (PieceCase& one : cases)
  {
    operations.push_back({ "pieces",
      [&one, &options]
      {
        one.Tets = 0;
        one.Bytes = 0;
        double slowest = 0;
        for (int piece = 0; piece < one.Pieces; ++piece)
        {
          slowest = std::max(slowest,
            SecondsOf(
              [&]
              {
                const Reading reading = ReadPiece(options.File, piece, one.Pieces, one.GhostLevels);
                one.Tets += reading.Tets;
                one.Bytes += reading.Bytes;
              }));
        }
        one.Each.push_back(slowest);
      } });
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["fileBytes"] = FileSize(options.File);
      json["cases"] = Json::arrayValue;
      for (std::size_t i = 0; i < cases.size(); ++i)
      {
        Json::Value caseJson;
        caseJson["pieces"] = cases[i].Pieces;
        caseJson["ghostLevels"] = cases[i].GhostLevels;
        caseJson["tets"] = cases[i].Tets;
        caseJson["bytesRead"] = cases[i].Bytes;
        AddTimes(caseJson, operations[i]);
        caseJson["slowestPiece"] = Json::arrayValue;
        for (std::size_t round = 1; round < cases[i].Each.size(); ++round)
        {
          caseJson["slowestPiece"].append(cases[i].Each[round]);
        }
        json["cases"].append(caseJson);
      }
    });
}

struct Region
{
  std::string Name;
  std::string File;
  bool UseBox = false;
  double Box[6] = {};
  bool UseRange = false;
  double Range[2] = {};
  Reading Result = {};
};

Reading ReadRegion(const Region& region, const std::string& array)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(region.File.c_str());
  reader->SetUseBox(region.UseBox);
  reader->SetBox(region.Box);
  reader->SetUseValueRange(region.UseRange);
  reader->SetValueRangeArray(array.c_str());
  reader->SetValueRange(region.Range);
  reader->Update();
  return Measure(reader, region.File);
}

/** The whole; a box of a tenth of each side in the middle of the bounds, and one in the corner of
 * half of each side; the values around the median, and the highest tenth of the range. */
std::vector<Region> MakeRegions(const std::string& file, vtkUnstructuredGrid* grid)
{
  Region whole;
  whole.Name = "whole";
  whole.File = file;
  std::vector<Region> regions(5, whole);
  double bounds[6];
  grid->GetBounds(bounds);
  regions[1].Name = "box in the middle, 1/10 of each side";
  regions[2].Name = "box in a corner, 1/2 of each side";
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis];
    const double side = bounds[2 * axis + 1] - low;
    regions[1].Box[2 * axis] = low + 0.45 * side;
    regions[1].Box[2 * axis + 1] = low + 0.55 * side;
    regions[2].Box[2 * axis] = low;
    regions[2].Box[2 * axis + 1] = low + 0.5 * side;
  }
  regions[1].UseBox = regions[2].UseBox = true;

  vtkDataArray* array = grid->GetPointData()->GetArray(0);
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  std::sort(values.begin(), values.end());
  regions[3].Name = "values: the middle hundredth of the points";
  regions[3].Range[0] = values[values.size() * 495 / 1000];
  regions[3].Range[1] = values[values.size() * 505 / 1000];
  regions[4].Name = "values: the highest tenth of the range";
  regions[4].Range[0] = 0.1 * values.front() + 0.9 * values.back();
  regions[4].Range[1] = values.back();
  regions[3].UseRange = regions[4].UseRange = true;
  return regions;
}

void TimeRegions(const PiecesOptions& options, const std::string& scratch)
{
  const Grid grid = Load(options.File);
  vtkDataArray* array = grid->GetPointData()->GetArray(0);
  if (!array || !array->GetName() || array->GetNumberOfComponents() != 1)
  {
    throw Failure(options.File, "has no scalars on points to choose by");
  }
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(scratch.c_str());
  std::vector<int> chunkTets{ 65536, 8192 };
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["tets"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
      json["array"] = array->GetName();
      json["files"] = Json::arrayValue;
      for (const int chunk : chunkTets)
      {
        writer->SetChunkTets(chunk);
        if (!writer->Write())
        {
          throw Failure(scratch, "cannot be written");
        }
        std::vector<Region> regions = MakeRegions(scratch, grid);
        std::vector<Operation> operations;
        for (Region& region : regions)
        {
          operations.push_back({ region.Name,
            [&region, array] { region.Result = ReadRegion(region, array->GetName()); } });
        }
        WarmUpAndRunInterleaved(operations, options.Rounds);
        Json::Value fileJson;
        fileJson["chunkTets"] = chunk;
        fileJson["chunks"] =
          static_cast<std::uint64_t>(gatun::FileReader(scratch).GetChunks().size());
        fileJson["fileBytes"] = FileSize(scratch);
        fileJson["regions"] = Json::arrayValue;
        for (std::size_t i = 0; i < regions.size(); ++i)
        {
          Json::Value regionJson;
          regionJson["region"] = regions[i].Name;
          regionJson["tets"] = regions[i].Result.Tets;
          regionJson["bytesRead"] = regions[i].Result.Bytes;
          AddTimes(regionJson, operations[i]);
          fileJson["regions"].append(regionJson);
        }
        json["files"].append(fileJson);
      }
    });
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddPieces(CLI::App& app)
{
  auto options = std::make_shared<PiecesOptions>();
  CLI::App* command = app.add_subcommand(
    "pieces", "Time and bytes to read a mesh whole and in pieces, one after the other");
  command->add_option("FILE", options->File, "A .gtn file")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->callback([options] { TimePieces(*options); });
}

//------------------------------------------------------------------------------
void AddRegion(CLI::App& app)
{
  auto options = std::make_shared<PiecesOptions>();
  auto scratch = std::make_shared<std::string>();
  CLI::App* command =
    app.add_subcommand("roi", "Time and bytes to read boxes and value ranges of a mesh");
  command->add_option("IN", options->File, "A .vtu or .gtn file of tetrahedra")->required();
  command->add_option("SCRATCH", *scratch, "A .gtn file to write")->required();
  command->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  command->callback([options, scratch] { TimeRegions(*options, *scratch); });
}
}
