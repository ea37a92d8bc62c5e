// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnFileSteps_h
#define gtnFileSteps_h

// The time steps of a .gtn file, whose mesh may change.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gatun
{
class FileReader;
}

namespace gtn
{
struct StepOptions;

class FileSteps
{
public:
  /** Throws gatun::Error. */
  explicit FileSteps(const std::string& path);

  /** The first mesh, which knows the others. */
  const gatun::FileReader& GetFile() const { return *this->File; }

  /** Those of all meshes; none without time. */
  const std::vector<double>& GetTimes() const { return this->Times; }

  struct Place
  {
    std::shared_ptr<const gatun::FileReader> Mesh;
    std::size_t Step;           // among those of the mesh
    std::optional<double> Time; // if there is time
  };

  /** The mesh of a step. It is opened anew if another one was found before. */
  Place Find(std::size_t step);

private:
  std::shared_ptr<const gatun::FileReader> File;
  std::vector<double> Times;
  std::size_t Number = 0; // of the mesh that was found last
  std::shared_ptr<const gatun::FileReader> Mesh;
};

/** The time step of a file that is asked for. Throws Failure, as ChooseStep. */
FileSteps::Place OpenStep(const std::string& path, const StepOptions& options, bool quiet);
}

#endif
