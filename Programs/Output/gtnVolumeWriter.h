// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnVolumeWriter_h
#define gtnVolumeWriter_h

// Volumes as files.

#include <string>

class vtkImageData;

namespace gtn
{
class Progress;

/** What help texts say of the formats that WriteVolume knows. */
extern const char* const VolumeOutputFormats;
bool IsVolumeOutput(const std::string& file);

/** Writes a volume in a format that is not that of slices. The file gets its name when it is
 * complete. Throws Failure. */
void WriteVolume(vtkImageData* volume, const std::string& file, Progress& progress);
}

#endif
