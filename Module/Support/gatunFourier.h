// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFourier_h
#define gatunFourier_h

// Fourier transforms by KissFFT, of any size, without scaling. An object keeps working memory: one
// a thread.

#include <complex>
#include <cstddef>
#include <memory>

namespace gatun
{
/** out[u] = sum over x of in[x] exp(-2 pi i u x / size). Several threads may use one. */
class FourierTransform
{
public:
  explicit FourierTransform(std::size_t size);
  ~FourierTransform();

  /** In and out may not be the same. */
  void Forward(const std::complex<double>* in, std::complex<double>* out) const;

private:
  struct Free
  {
    void operator()(void* plan) const;
  };
  std::unique_ptr<void, Free> Plan;
};

/** Spectra of real pictures back to pictures: out[y][x] = sum over v, u of F(v, u)
 * exp(2 pi i (u x / width + v y / height)). Both sizes are even. It keeps working memory: one a
 * thread. */
class InversePlaneTransform
{
public:
  InversePlaneTransform(std::size_t height, std::size_t width);
  ~InversePlaneTransform();

  /** Of in, in each row only the frequencies 0 to width / 2; it is overwritten. */
  void Run(std::complex<double>* in, double* out);

private:
  struct Free
  {
    void operator()(void* plan) const;
  };
  std::unique_ptr<void, Free> Plan;
};

/** The next size that is not smaller and has no prime factors above 5. */
std::size_t GetFastSize(std::size_t size);
}

#endif
