// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSlices_h
#define gtnSlices_h

// Volumes as pictures, one a slice, or several in a file. The first one is at the smallest z; rows
// go down in a picture, and up in a volume.

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;

namespace gtn
{
class Progress;

/** Extensions of files that hold slices. */
extern const char* const SliceFormats;
bool IsSlice(const std::string& file);

/** The slices that are meant, in the order of the numbers in their names: those in a folder, those
 * that a pattern with * and ? in the last part of a path fits, or the file itself. Throws Failure
 * if there are none. */
std::vector<std::string> FindSlices(const std::string& folderOrPattern);

/** Whether a name comes before another one, where numbers in them count as such. */
bool IsBefore(const std::string& one, const std::string& other);

/** Reads slices of one size and type. Throws Failure. */
vtkSmartPointer<vtkImageData> ReadSlices(const std::vector<std::string>& files, Progress& progress);

/** Whether a name has a %d, with or without a number of digits, for that of a slice. Throws
 * UsageError for anything else behind a percent sign. */
bool HasNumber(const std::string& name);

/** Names of so many slices. */
std::vector<std::string> NameSlices(const std::string& name, int count);

/** Writes a volume as slices, each of which gets its name when it is complete. Throws Failure. */
void WriteSlices(vtkImageData* volume, const std::vector<std::string>& files, Progress& progress);
}

#endif
