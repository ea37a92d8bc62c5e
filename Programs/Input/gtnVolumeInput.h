// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnVolumeInput_h
#define gtnVolumeInput_h

// Regular volumes of whatever format, and slices.

#include "gtnCommandLine.h"

#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace gtn
{
class Progress;
struct Settings;

struct VolumeInputOptions
{
  std::vector<std::string> Files; ///< one volume, or slices of one
  std::string Array;              ///< its name; empty: the active scalars, or else the first one
  std::optional<std::array<double, 3>> Spacing;
};

/** What help texts say of readable formats. */
extern const char* const VolumeFormats;

/** --array and --spacing. */
void AddVolumeInput(CLI::App* command, VolumeInputOptions& options);

/** Reads a volume; the array that was chosen is its only point array and the active scalars. Throws
 * Failure. */
vtkSmartPointer<vtkImageData> ReadVolume(
  const VolumeInputOptions& options, const Settings& settings);

/** "64 x 64 x 20". */
std::string SizeOf(const std::array<std::uint32_t, 3>& size);
}

#endif
