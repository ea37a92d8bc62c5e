// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFourier_h
#define gatunFourier_h

// Fourier transforms of any size by KissFFT, without scaling. An object has working memory, so each
// thread needs its own, unless stated otherwise.

#include <complex>
#include <cstddef>
#include <memory>

namespace gatun
{
/** out[u] = sum over x of in[x] exp(-2 pi i u x / size). Thread safe. */
class FourierTransform
{
public:
  explicit FourierTransform(std::size_t size);
  ~FourierTransform();

  /** in and out must differ. */
  void Forward(const std::complex<double>* in, std::complex<double>* out) const;

private:
  struct Internals;
  std::unique_ptr<const Internals> Self;
};

/** Transforms spectra of real images back to images: out[y][x] = sum over v, u of F(v, u)
 * exp(2 pi i (u x / width + v y / height)). Both sizes must be even. Not thread safe. */
class InversePlaneTransform
{
public:
  InversePlaneTransform(std::size_t height, std::size_t width);
  ~InversePlaneTransform();

  /** Rows of in contain the frequencies 0 to width / 2. in is overwritten. */
  void Run(std::complex<double>* in, double* out);

private:
  struct Internals;
  std::unique_ptr<Internals> Self;
};

/** The smallest size that is not below the given one and has no prime factor above 5. */
std::size_t GetFastSize(std::size_t size);
}

#endif
