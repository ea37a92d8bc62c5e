// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSlices_h
#define gtnSlices_h

// Volumes as images: one slice a file, or several in a file. The first slice is at the smallest z.
// Rows of an image go down, and rows of a volume go up.

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;

namespace gtn
{
class Progress;

/** Extensions of files with slices. */
extern const char* const SliceFormats;
bool IsSlice(const std::string& file);

/** Returns the slices in a folder, those that a pattern of glob(7) matches, or the file itself,
 * sorted by the numbers in their names. Throws Failure if there are none. */
std::vector<std::string> FindSlices(const std::string& folderOrPattern);

/** Sorts names; numbers in them are compared as numbers. */
std::vector<std::string> SortByNumbers(const std::vector<std::string>& files);

/** Reads slices of one size and type. Throws Failure. */
vtkSmartPointer<vtkImageData> ReadSlices(const std::vector<std::string>& files, Progress& progress);

/** Whether a name has a %d, with or without a number of digits, for the number of a slice. Throws
 * UsageError for any other percent sign. */
bool HasNumber(const std::string& name);

/** Returns the names of a given number of slices. */
std::vector<std::string> NameSlices(const std::string& name, int count);

/** Writes a volume as slices. Each file gets its name when it is complete. Throws Failure. */
void WriteSlices(vtkImageData* volume, const std::vector<std::string>& files, Progress& progress);
}

#endif
