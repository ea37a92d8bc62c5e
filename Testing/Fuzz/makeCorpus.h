// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef makeCorpus_h
#define makeCorpus_h

// What the parts of the program makeCorpus share.

#include "gatunFileImage.h"

#include <filesystem>
#include <fstream>
#include <span>
#include <string>

/** A folder of seeds for each target. */
class Corpus
{
public:
  explicit Corpus(std::filesystem::path folder)
    : Folder(std::move(folder))
  {
  }

  void Add(const std::string& target, std::span<const std::uint8_t> bytes)
  {
    std::filesystem::create_directories(this->Folder / target);
    std::ofstream out(
      this->Folder / target / ("seed-" + std::to_string(this->Count++)), std::ios::binary);
    out.write(
      reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  std::filesystem::path GetFolder() const { return this->Folder; }

private:
  std::filesystem::path Folder;
  unsigned Count = 0;
};

/** The tables of a file as one input: of the mesh and its pages, then of the first step. */
gatun::Bytes GetTables(gatun::test::FileImage image);

/** Smooth values at some steps, with and without bounds of errors, which quadratic functions
 * predict. */
void AddSmoothFiles(Corpus& corpus);

/** Meshes that change over time. */
void AddSeriesFiles(Corpus& corpus);

/** Meshes of which cells die, and meshes that return. */
void AddDeletedCellFiles(Corpus& corpus);

/** Hexahedra and surfaces, with boundaries. */
void AddCellFiles(Corpus& corpus);

#endif
