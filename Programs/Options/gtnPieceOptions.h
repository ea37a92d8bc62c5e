// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPieceOptions_h
#define gtnPieceOptions_h

// How a mesh is packed piece by piece.

#include "gtnCommandLine.h"

#include <string>

class vtkGatunWriter;

namespace gtn
{
class Input;
struct Settings;

struct PieceOptions
{
  int Pieces = 0; ///< 0: not given
  int Memory = 0; ///< in MiB, 0: not given
  std::string SpillFolder;

  /** Whether the files of a mesh may be read one by one. */
  bool AreGiven() const { return this->Memory > 0 || this->Pieces > 1; }
};

/** Adds --memory, --pieces and --spill. */
void AddPieceOptions(CLI::App* command, PieceOptions& options);

/** Divides a mesh as the options say, and sets up the writer for the pieces, whose file name and
 * other options have been set. Returns
 * whether the mesh comes in pieces. Throws Failure, also if memory does not suffice. */
bool SetPieces(
  vtkGatunWriter* writer, Input& input, const PieceOptions& options, const Settings& settings);
}

#endif
