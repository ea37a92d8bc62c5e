// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLanes_h
#define gatunHartleyLanes_h

// Lines of complex numbers, eight side by side in the lanes of vectors, and the loops over them,
// which have a version for each instruction set.

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** One complex number of each of eight lines. */
struct alignas(32) ComplexLanes
{
  static constexpr std::size_t Count = 8;

  /** The number of such groups for a number of lines. */
  static constexpr std::size_t CountGroups(std::size_t lines)
  {
    return (lines + Count - 1) / Count;
  }

  float Re[Count];
  float Im[Count];
};

/** A step of a Fourier transform: Count * Stride transforms of Radix numbers. */
struct FourierStage
{
  std::size_t Radix = 0;
  std::size_t Count = 0;
  std::size_t Stride = 0;
  const float* Turns = nullptr; ///< Radix - 1 complex factors for each of Count
  const float* Roots = nullptr; ///< of unity, Radix of them
};

/** A point of a slice, interpolated from eight points of a spectrum along one axis. */
struct HartleySample
{
  std::uint32_t First =
    0;                  ///< the first of the eight, in complex numbers from the begin of the values
  std::uint32_t To = 0; ///< where it is added, in floats; the imaginary part follows 8 later
  float Position = 0;   ///< in steps of the table of weights
  float Scale = 0;      ///< of the real part
  float ImaginaryScale = 0; ///< of the imaginary part; mirrored points have the opposite sign
};

/** Interpolation of an image between the points of a lattice. */
struct HartleyResampling
{
  static constexpr std::size_t Taps = 4;

  const float* Lattice = nullptr;
  std::size_t Stride = 0;         ///< from one row of the lattice to the next
  const float* Weights = nullptr; ///< Taps for each of Steps + 1 positions
  float Steps = 0;
};

/** A box of trilinear voxels of the value 1, and rays through it. */
struct HartleyBox
{
  float HalfSize[3]; ///< half of the voxels plus 1
  float Column[3];   ///< from one ray to the next
  float PerStep[3];  ///< voxels for each step along a ray, not negative
  float PerVoxel[3]; ///< steps for each voxel
};

struct HartleyLaneLoops
{
  /** Transforms lines without scaling. Room: as long as values. Returns where the result is, which
   * is one of the two. */
  ComplexLanes* (*Transform)(const FourierStage* stages, std::size_t count, bool inverse,
    ComplexLanes* values, ComplexLanes* room);

  /** Multiplies the numbers of lines by count complex factors. */
  void (*Turn)(ComplexLanes* values, const float* factors, std::size_t count);

  /** Transposes 8 rows of 8 floats. The strides are between rows, in floats. */
  void (*Transpose)(const float* from, std::size_t fromStride, float* to, std::size_t toStride);

  /** Separates the transforms of two real lines, of which the transformed line was the real and the
   * imaginary part. Here, there: its values at a frequency and at the opposite one; factor: of
   * both. */
  void (*Separate)(const ComplexLanes& here, const ComplexLanes& there, const float* factor,
    ComplexLanes& first, ComplexLanes& second);

  /** Adds the frequencies from 0 to count - 1 of two real lines, the second times i, and those of
   * the opposite frequencies; size: of the transform, at least 2 * count. */
  void (*Join)(const ComplexLanes* first, const ComplexLanes* second, std::size_t count,
    std::size_t size, ComplexLanes* to);

  /** Floats in half precision, times a scale; count is a multiple of 8. */
  void (*ToHalf)(const float* from, std::size_t count, float scale, std::uint16_t* to);
  void (*FromHalf)(const std::uint16_t* from, std::size_t count, float* to);

  /** Stores eight lines of eight complex numbers, given lane by lane, in half precision, each as a
   * row of real and imaginary parts. Rows: number of rows; columns: numbers of each row. */
  void (*StoreRows)(const ComplexLanes* from, float scale, std::size_t rows, std::size_t columns,
    std::uint16_t* to, std::size_t stride);

  /** Interpolates points of a slice and adds them. Values: real and imaginary parts; weights: 16
   * for each step, each twice; stride: from one of the eight points to the next, in complex
   * numbers. */
  void (*Sample)(const HartleySample* samples, std::size_t count, const std::uint16_t* values,
    const float* weights, std::ptrdiff_t stride, float* to);

  /** Interpolates count pixels at (x, y), (x + stepX, y + stepY), ..., in lattice points. All of
   * their taps are in the lattice. */
  void (*Resample)(const HartleyResampling& resampling, double x, double y, double stepX,
    double stepY, std::size_t count, float* to);

  /** Integrals of a box of ones along count rays. Origin: a point on the first one, relative to the
   * middle of the box. */
  void (*Measure)(const HartleyBox& box, const float* origin, std::size_t count, float* to);
};

/** The fastest version that this processor supports. */
const HartleyLaneLoops& GetBestHartleyLanes();
const HartleyLaneLoops& GetPortableHartleyLanes();
const HartleyLaneLoops* GetAVX2HartleyLanes(); ///< null if it was not compiled
}

#endif
