// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPieceOptions.h"

#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnProgress.h"
#include "gtnSettings.h"
#include "gtnSpooledMesh.h"

#include "gatunParallel.h"
#include "gatunPartWriter.h"
#include "vtkGatunWriter.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>

namespace gtn
{
namespace
{

// Of the program itself, in MiB, and of a mesh that is written.
constexpr std::uint64_t ProgramMiB = 160;
constexpr std::uint64_t Copies = 4;

// What writing takes in MiB. pieceBytes: of the largest piece. moreBytes: of what stays.
std::uint64_t NeededMiB(std::uint64_t pieceBytes, std::uint64_t moreBytes)
{
  // The writer sorts the points on the boundaries of pieces, and then those that it joins.
  const std::uint64_t spillBytes = 2 * gatun::PartWriterOptions().SpillMemory;
  return ProgramMiB + ((spillBytes + Copies * pieceBytes + moreBytes) >> 20);
}

// What a thread takes to find the hierarchy of a mesh in pieces.
constexpr std::uint64_t GroupMiB = 320;

// What the tables of a hierarchy take: some 90 bytes a point. bytes: of the mesh.
std::uint64_t TableMiB(std::uint64_t bytes)
{
  return bytes / 3 >> 20;
}

// The same with the hierarchy of a mesh that is written in pieces. allBytes: of all pieces.
std::uint64_t NeededMiB(
  vtkGatunWriter* writer, std::uint64_t pieceBytes, std::uint64_t moreBytes, std::uint64_t allBytes)
{
  const auto needed = NeededMiB(pieceBytes, moreBytes);
  return writer->GetHierarchy() ? std::max(needed, ProgramMiB + GroupMiB + TableMiB(allBytes))
                                : needed;
}

// Divides a mesh in one file.
void Divide(
  vtkGatunWriter* writer, Input& input, const PieceOptions& options, const Settings& settings)
{
  if (writer->GetLayerArray())
  {
    throw Failure(input.GetName(), "layers need the whole mesh, which is divided into pieces");
  }
  if (writer->GetKeepOrder() != vtkGatunWriter::KEEP_NONE)
  {
    throw Failure(input.GetName(),
      "the original order needs the whole mesh, or one in several files; the mesh is divided into "
      "pieces");
  }
  SpoolSettings spool;
  spool.Folder = options.SpillFolder;
  if (spool.Folder.empty())
  {
    spool.Folder = std::filesystem::path(writer->GetFileName()).parent_path().string();
  }
  spool.Folder = spool.Folder.empty() ? "." : spool.Folder;
  spool.Pieces = static_cast<std::size_t>(std::max(1, options.Pieces));
  spool.Memory = std::numeric_limits<std::uint64_t>::max();
  spool.PieceBytes = spool.Memory;
  if (options.Memory > 0)
  {
    constexpr std::uint64_t leastPiece = 1 << 20;
    const auto limit = static_cast<std::uint64_t>(options.Memory);
    const std::uint64_t fixed = NeededMiB(0, 0);
    const std::uint64_t least = NeededMiB(leastPiece, 0);
    if (least > limit)
    {
      throw Failure(input.GetName(),
        fmt::format("packing a mesh in pieces takes at least {} MiB of memory, and --memory allows "
                    "{}",
          least, limit));
    }
    spool.Reserved = ProgramMiB << 20;
    spool.Memory = limit > ProgramMiB ? (limit - ProgramMiB) << 20 : 0;
    // Pieces become a little larger than their share of the mesh.
    spool.PieceBytes = ((limit - fixed) << 20) / Copies / 10 * 9;
  }
  Progress progress("reading", settings.ShowProgress);
  // Pieces with many points that others have, too, are larger than expected.
  constexpr int mostAttempts = 3;
  for (int attempt = 0; attempt < mostAttempts; ++attempt)
  {
    input.Spool(spool, progress);
    const std::uint64_t largest = std::max<std::uint64_t>(1, input.EstimateLargestPart());
    if (options.Memory == 0 || NeededMiB(largest, 0) <= static_cast<std::uint64_t>(options.Memory))
    {
      break;
    }
    const double target = static_cast<double>(spool.PieceBytes);
    spool.PieceBytes = static_cast<std::uint64_t>(target * target / static_cast<double>(largest));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddPieceOptions(CLI::App* command, PieceOptions& options)
{
  command
    ->add_option("--memory", options.Memory,
      "Limit of memory in MiB. The files of a .pvtu or .pvtp file, or of each time step of a .pvd "
      "file, are packed one after the other, and so are the blocks of a .vtm, .vtpc or Exodus "
      "file. "
      "A .vtu file that is too large is divided into pieces on the disk first. The whole mesh is "
      "never in memory. If that would take more than the limit, nothing is done (default: none; "
      "all "
      "of the mesh is read)")
    ->check(CLI::Range(1, 1 << 30))
    ->option_text("MIB");
  command
    ->add_option("--pieces", options.Pieces,
      "Number of pieces that are packed one after the other, for .vtu files and files that can be "
      "read in pieces (default: with --memory, as many as needed, or the number of files or "
      "blocks of the mesh; otherwise 1)")
    ->check(CLI::Range(1, 1 << 24))
    ->option_text("N");
  command
    ->add_option("--spill", options.SpillFolder,
      "Folder for the temporary copy of a .vtu file that is divided (default: that of the .gtn "
      "file)")
    ->check(CLI::ExistingDirectory)
    ->option_text("DIR");
}

//------------------------------------------------------------------------------
bool SetPieces(
  vtkGatunWriter* writer, Input& input, const PieceOptions& options, const Settings& settings)
{
  const auto limit = static_cast<std::uint64_t>(options.Memory);
  const bool isTooLarge = limit > 0 && NeededMiB(input.EstimateLargestPart(), 0) > limit;
  if (input.CanSpool() && (options.Pieces > 1 || isTooLarge))
  {
    Divide(writer, input, options, settings);
  }
  const auto parts = static_cast<int>(input.GetNumberOfParts());
  const int pieces = input.IsSpooled() ? parts
    : options.Pieces > 0               ? options.Pieces
    : options.Memory > 0               ? parts
                                       : 1;
  writer->SetNumberOfPieces(pieces);
  if (limit > 0)
  {
    const auto files = static_cast<std::uint64_t>((parts + pieces - 1) / pieces);
    const auto pieceBytes = parts > 1 || pieces == 1
      ? input.EstimateLargestPart() * files
      : input.EstimateLargestPart() / static_cast<std::uint64_t>(pieces);
    const auto allBytes = pieceBytes * static_cast<std::uint64_t>(pieces);
    const auto needed = pieces > 1 ? NeededMiB(writer, pieceBytes, input.GetBytesForAll(), allBytes)
                                   : NeededMiB(pieceBytes, input.GetBytesForAll());
    if (needed > limit)
    {
      throw Failure(input.GetName(),
        fmt::format("packing the largest of {} takes about {} MiB of memory, and --memory allows "
                    "{}; smaller pieces would take less",
          pieces > 1 ? fmt::format("{} pieces", pieces) : "one piece", needed, limit));
    }
    if (pieces > 1 && writer->GetHierarchy())
    {
      const auto threads = (limit - ProgramMiB - TableMiB(allBytes)) / GroupMiB;
      if (threads < static_cast<std::uint64_t>(gatun::GetNumberOfThreads()))
      {
        gatun::SetNumberOfThreads(static_cast<int>(std::max<std::uint64_t>(1, threads)));
      }
    }
  }
  return pieces > 1 || input.IsSpooled();
}
}
