// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnFileSteps.h"

#include "gtnStep.h"

#include "gatunFileReader.h"

#include <algorithm>

namespace gtn
{
//------------------------------------------------------------------------------
FileSteps::FileSteps(const std::string& path)
  : File(std::make_shared<const gatun::FileReader>(path))
  , Times(File->GetSeriesTimes())
  , Mesh(File)
{
}

//------------------------------------------------------------------------------
FileSteps::Place FileSteps::Find(std::size_t step)
{
  if (this->Times.empty())
  {
    return { this->File, 0, {} };
  }
  const double time = this->Times.at(step);
  const auto& series = this->File->GetSeries();
  const std::size_t number = series.empty() ? 0 : series[step].Mesh;
  if (number != this->Number)
  {
    this->Mesh = number == 0 ? this->File : this->File->OpenMesh(number);
    this->Number = number;
  }
  const auto& own = this->Mesh->GetTimes();
  const auto place = std::lower_bound(own.begin(), own.end(), time) - own.begin();
  return { this->Mesh, static_cast<std::size_t>(place), time };
}

//------------------------------------------------------------------------------
FileSteps::Place OpenStep(const std::string& path, const StepOptions& options, bool quiet)
{
  FileSteps steps(path);
  return steps.Find(ChooseStep(options, path, steps.GetTimes(), quiet));
}
}
