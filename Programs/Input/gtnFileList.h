// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnFileList_h
#define gtnFileList_h

// ParaView's lists of files: .pvd, in XML, and .series, in JSON.

#include <string>
#include <vector>

namespace gtn
{
/** A time step of a mesh in files. */
struct SeriesStep
{
  double Time = 0;
  std::vector<std::string> Files; ///< the parts of the mesh
  std::string List = {};          ///< the file that lists them, for messages
};

/** The times of steps. */
std::vector<double> TimesOf(const std::vector<SeriesStep>& steps);

/** Whether a file is a list of time steps (.pvd, .series), by its extension. */
bool IsFileList(const std::string& file);

/** "2 files at time 1, and 1 at time 0", or nothing if all steps have as many. */
std::string DescribeUnequal(const std::vector<SeriesStep>& steps);

/** The steps that it lists, by ascending time. A file counts once per time. Throws Failure. */
std::vector<SeriesStep> ReadFileList(const std::string& file);
}

#endif
