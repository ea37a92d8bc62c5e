// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnVolumeSource_h
#define gtnVolumeSource_h

// The volume that is drawn: a .ghv file, which is not decoded to voxels, or a volume in memory.

#include "gtnVolumeInput.h"

#include "gatunTypes.h"
#include "vtkGatunHartleyReader.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>

class vtkGatunDefaults;
class vtkImageAlgorithm;
class vtkImageData;

namespace gtn
{
struct Settings;

class VolumeSource
{
public:
  /** Opens a volume; of a .ghv file only the directory is read. Throws Failure. */
  VolumeSource(const VolumeInputOptions& options, const Settings& settings);
  ~VolumeSource();
  VolumeSource(const VolumeSource&) = delete;
  VolumeSource& operator=(const VolumeSource&) = delete;

  const std::string& GetFile() const { return this->File; }
  const std::string& GetArray() const { return this->Array; }
  const gatun::Range& GetRange() const { return this->Range; }
  const gatun::Bounds& GetBounds() const { return this->Bounds; }
  const std::array<std::uint32_t, 3>& GetSize() const { return this->Size; }

  /** Whether it is a .ghv file. */
  bool IsFile() const { return this->Reader; }

  /** Makes the volume the input of an algorithm. */
  void Connect(vtkImageAlgorithm* algorithm) const;
  void Connect(vtkGatunDefaults* defaults) const;

private:
  void OpenFile();
  void Read(const VolumeInputOptions& options, const Settings& settings);
  void SetPlace(vtkImageData* volume);

  const std::string File;
  vtkSmartPointer<vtkGatunHartleyReader> Reader;
  vtkSmartPointer<vtkImageData> Volume;
  std::string Array;
  gatun::Range Range;
  gatun::Bounds Bounds;
  std::array<std::uint32_t, 3> Size{};
};
}

#endif
