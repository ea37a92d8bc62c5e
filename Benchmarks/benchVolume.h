// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchVolume_h
#define benchVolume_h

// Regular volumes to measure with, and how they are looked at.

#include "gatunHartleyProjector.h"
#include "gatunHartleyVolume.h"
#include "gatunVolumeReference.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;

namespace bench
{
/** Rotations about x, y and z, in units of pi. */
using Turns = std::array<double, 3>;

/** A volume with its voxels, once in its own type and once as floats. */
class Volume
{
public:
  /** A .vti or NIfTI file; or head:96, which is made with so many voxels along
   * its longest axis. Throws Failure. */
  explicit Volume(const std::string& name);
  ~Volume();
  Volume(const Volume&) = delete;
  Volume& operator=(const Volume&) = delete;

  vtkImageData* GetImage() const;
  const std::array<std::uint32_t, 3>& GetSize() const { return this->Size; }
  std::size_t GetNumberOfVoxels() const { return this->Voxels.size(); }
  const std::vector<float>& GetVoxels() const { return this->Voxels; }

  /** What Gatun compresses; this volume must be there as long as it is used. */
  gatun::VolumeInput GetInput() const;

  double GetLowest() const { return this->Lowest; }
  double GetHighest() const { return this->Highest; }
  double GetRange() const { return this->Highest - this->Lowest; }
  bool IsInteger() const;

  /** The volume in the reference's eyes, whole. */
  gatun::test::ReferenceVolume GetReference() const;

  /** Looked at in space, with its spacing; the shortest spacing is the length of a sample, and,
   * times the scale, of a pixel. */
  gatun::HartleyView MakeView(const Turns& turns, unsigned pixels, double scale) const;

  /** Pixels of the smallest square image that shows all of the volume from any side. */
  unsigned GetPixels(double scale) const;

private:
  vtkSmartPointer<vtkImageData> Image;
  std::array<std::uint32_t, 3> Size{};
  std::vector<float> Voxels;
  double Lowest = 0;
  double Highest = 0;
};

/** Gray from the lowest density to the highest. The most opaque sample has this opacity, and under
 * the exponential model it goes by that, else linearly. */
gatun::HartleyShading MakeGray(
  const Volume& volume, gatun::HartleyOpacityModel model, double opacity);

/** Lossless for 0, else so many bits a voxel. */
gatun::HartleyRateControl MakeQuality(double rate);

/** The four rotations of the dissertation's tables, by their number. */
const std::array<Turns, 4>& GetPaperTurns();

/** 10 log10(range^2 / mean square error). */
double GetPSNR(double range, double meanSquareError);
}

#endif
