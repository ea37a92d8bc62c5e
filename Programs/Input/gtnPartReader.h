// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPartReader_h
#define gtnPartReader_h

// A mesh in several files that are its parts.

#include "gtnInputOptions.h"
#include "gtnPartList.h"

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkPointSet;

namespace gtn
{
/** VTK's reader for a file that is not a list of time steps, with the information that it gives.
 * Throws Failure. */
vtkSmartPointer<vtkAlgorithm> OpenFile(const std::string& file, const InputOptions& options);

/** Reads a part of a mesh in the form of all parts. Throws Failure. */
vtkSmartPointer<vtkDataObject> ReadPart(
  const std::string& file, const PartForm& form, const InputOptions& options);

/** Reads parts one after the other, and appends them: all points stay. Returns a grid, or a surface
 * if all parts are surfaces. Throws Failure. */
vtkSmartPointer<vtkDataObject> ReadParts(
  const std::vector<std::string>& files, const PartForm& form, const InputOptions& options);

/** Adds the point array JoinArrayName, by which vtkGatunWriter joins the points of pieces: with the
 * values of an array, or -1 for points that are joined with no others. */
void AddJoinArray(vtkPointSet* piece, vtkDataArray* values);

/** Reads a .pvtu or .pvtp file as a whole. */
class PartReader : public vtkDataObjectAlgorithm
{
public:
  static PartReader* New();
  vtkTypeMacro(PartReader, vtkDataObjectAlgorithm);

  /** Throws Failure for files that are missing. */
  void SetFile(const std::string& file, const InputOptions& options);

protected:
  PartReader();

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  void Read(vtkDataObject* output);

  std::string File;
  std::vector<std::string> Parts;
  InputOptions Options;
  vtkSmartPointer<vtkAlgorithm> List; // VTK's reader of the file, for its times and field data
};
}

#endif
