// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Arrays whose values may have an error: every one is within its bound.

#include "gatunError.h"
#include "gatunHostile.h"
#include "gatunRoundedArrays.h"
#include "gatunTestFile.h"
#include "gatunTestMeshes.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Values that are hard to round, among smooth ones. */
template <typename T>
T MakeValue(std::size_t i, double smooth, std::mt19937& random)
{
  using Limits = std::numeric_limits<T>;
  switch (random() % 40)
  {
    case 0:
      return Limits::quiet_NaN();
    case 1:
      return i % 2 ? Limits::infinity() : -Limits::infinity();
    case 2:
      return Limits::denorm_min() * static_cast<T>(1 + random() % 1000);
    case 3:
      return i % 2 ? Limits::max() : Limits::lowest();
    case 4:
      return i % 3 ? T{ 0 } : -T{ 0 };
    case 5: // another NaN
      return sizeof(T) == 4 ? static_cast<T>(std::bit_cast<float>(0x7fc12345u))
                            : static_cast<T>(std::bit_cast<double>(0xfff8000012345678ull));
    case 6:
      return static_cast<T>(std::ldexp(smooth, static_cast<int>(random() % 120) - 60));
    case 7:
      return static_cast<T>(i % 2 ? -1e7 : 1e7);
    default:
      return static_cast<T>(smooth);
  }
}

struct Arrays
{
  Arrays(const TestMesh& mesh, int step, bool isWild)
  {
    std::mt19937 random(static_cast<unsigned>(7 + step));
    const auto add = [&](std::size_t i, double smooth)
    {
      this->Float.push_back(
        isWild ? MakeValue<float>(i, smooth, random) : static_cast<float>(smooth));
      this->Double.push_back(isWild ? MakeValue<double>(i, smooth, random) : smooth);
    };
    for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
    {
      const double* x = &mesh.Coordinates[3 * p];
      add(p, std::sin(x[0] + 0.1 * step) + 0.3 * x[1] * x[2]);
      this->Integers.push_back(static_cast<std::int64_t>(1000 * std::cos(x[1])) + step +
        (isWild && random() % 30 == 0 ? std::int64_t{ 1 } << (random() % 63) : 0));
    }
    for (std::size_t t = 0; t < mesh.GetTets(); ++t)
    {
      this->Cells.push_back(isWild ? MakeValue<float>(t, std::sin(0.01 * t + step), random)
                                   : static_cast<float>(std::sin(0.01 * t + step)));
      this->Ids.push_back(static_cast<std::int64_t>(t * 7919 % 10007));
    }
  }

  std::array<const void*, 6> Get() const
  {
    return { this->Float.data(), this->Double.data(), this->Integers.data(), this->Cells.data(),
      this->Ids.data(), this->Float.data() };
  }

  std::vector<float> Float;
  std::vector<double> Double;
  std::vector<std::int64_t> Integers;
  std::vector<float> Cells;
  std::vector<std::int64_t> Ids;
};

std::vector<ArrayDescription> Describe()
{
  return { { "float", Association::Point, ScalarType::Float32, 1, 0, 0, {} },
    { "double", Association::Point, ScalarType::Float64, 1, 0, 0, {} },
    { "integers", Association::Point, ScalarType::Int64, 1, 0, 0, {} },
    { "cells", Association::Cell, ScalarType::Float32, 1, 0, 0, {} },
    { "ids", Association::Cell, ScalarType::Int64, 1, 12, 0, {} },
    { "twin", Association::Point, ScalarType::Float32, 1, 0, 0, {} } };
}

constexpr int RoundedSteps = 3;

std::shared_ptr<const FileReader> Write(const TestMesh& mesh, const std::vector<ArrayError>& errors,
  bool isWild, bool boundary = false, std::uint32_t chunkSize = 200)
{
  const auto path = GetPath("rounded.gtn");
  WriterOptions options;
  options.ChunkSize = chunkSize;
  options.Keep = KeepAll;
  options.Errors = errors;
  options.Boundary = boundary;
  FileWriter writer(path, mesh.GetInput(), Describe(), options);
  for (int step = 0; step < RoundedSteps; ++step)
  {
    writer.WriteStep(Arrays(mesh, step, isWild).Get(), {}, true, step);
  }
  writer.Finish();
  return std::make_shared<const FileReader>(path);
}

Arrays Read(PieceDecoder& decoder, const FileReader& file, const TestMesh& mesh, std::size_t step,
  std::vector<float>& twin)
{
  Arrays back(mesh, 99, false);
  twin = back.Float;
  auto request = AskForAll(file);
  request.Arrays = { 0, 1, 2, 3, 4, 5 };
  request.Step = step;
  request.RestoreOrder = true;
  decoder.SetRequest(request);
  PieceTarget target;
  target.Arrays = { back.Float.data(), back.Double.data(), back.Integers.data(), back.Cells.data(),
    back.Ids.data(), twin.data() };
  decoder.Fill(target);
  return back;
}

/** The range that relative bounds are of. */
template <typename T>
long double GetRange(const std::vector<T>& values)
{
  long double low = std::numeric_limits<long double>::infinity(), high = -low;
  for (const auto value : values)
  {
    if (std::isfinite(value))
    {
      low = std::min<long double>(low, value);
      high = std::max<long double>(high, value);
    }
  }
  return high - low;
}

template <typename T>
void ExpectWithin(const std::vector<T>& found, const std::vector<T>& expected,
  const ErrorBound& bound, const std::string& what)
{
  const auto range = GetRange(expected);
  std::size_t different = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const auto x = expected[i], y = found[i];
    if (std::memcmp(&x, &y, sizeof x) == 0)
    {
      continue;
    }
    ++different;
    ASSERT_TRUE(std::isfinite(x) && std::isfinite(y)) << what << " " << x << " " << y;
    ASSERT_FALSE(bound.KeepZeros && x == 0) << what << " " << y;
    const auto error = std::abs(static_cast<long double>(x) - static_cast<long double>(y));
    const auto size = std::abs(static_cast<long double>(x));
    const auto allowed = bound.Kind == ErrorKind::Relative ? bound.Bound * range
      : bound.Kind == ErrorKind::Pointwise                 ? bound.Bound * size
      : bound.Kind == ErrorKind::Bits
      ? std::ldexp(1.0L, std::ilogb(size) - static_cast<int>(bound.Bound))
      : static_cast<long double>(bound.Bound);
    ASSERT_LE(error, allowed) << what << " " << x << " " << y;
  }
  EXPECT_GT(different, expected.size() / 4) << what; // there is anything to test
}

TEST(RoundedArrays, AreWithinTheirBounds)
{
  const auto mesh = MakeCubes(8, 0.2);
  for (const bool isWild : { false, true })
  {
    for (const bool onLattice : { false, true })
    {
      for (const ErrorBound bound :
        { ErrorBound{ ErrorKind::Absolute, 0.01, false }, { ErrorKind::Absolute, 0.3, true },
          { ErrorKind::Absolute, 1e-7, false }, { ErrorKind::Relative, 1e-3, true },
          { ErrorKind::Pointwise, 1e-2, false }, { ErrorKind::Bits, 9, true } })
      {
        const auto what = ToString(bound) + (isWild ? " wild" : "") + (onLattice ? " lattice" : "");
        // The range of wild values is that of their type.
        const bool isTested = !(isWild && bound.Kind == ErrorKind::Relative) && bound.Bound != 1e-7;
        std::vector<ArrayError> errors{ { "*", bound } };
        if (bound.Kind == ErrorKind::Absolute)
        {
          errors.push_back({ "integers", { ErrorKind::Absolute, 5, bound.KeepZeros } });
        }
        const auto file = Write(mesh, errors, isWild, onLattice);
        ASSERT_GT(file->GetChunks().size(), 5u);
        EXPECT_TRUE(VerifyFile(*file)) << what;
        PieceDecoder decoder(file);
        for (const int step : { 2, 0, 1 })
        {
          const Arrays expected(mesh, step, isWild);
          std::vector<float> twin;
          const auto found = Read(decoder, *file, mesh, static_cast<std::size_t>(step), twin);
          EXPECT_EQ(found.Ids, expected.Ids) << what;
          EXPECT_EQ(std::memcmp(twin.data(), found.Float.data(), 4 * twin.size()), 0) << what;
          if (errors.size() > 1)
          {
            ExpectWithin(found.Integers, expected.Integers, errors[1].Bound, what + " integers");
          }
          else
          {
            EXPECT_EQ(found.Integers, expected.Integers) << what;
          }
          if (isTested)
          {
            ExpectWithin(found.Float, expected.Float, bound, what + " float");
            ExpectWithin(found.Double, expected.Double, bound, what + " double");
            ExpectWithin(found.Cells, expected.Cells, bound, what + " cells");
          }
        }
      }
    }
  }
}

TEST(RoundedArrays, TakeFewerBytes)
{
  const auto mesh = MakeCubes(12, 0.2);
  // One chunk: a stream has a few bytes besides its values.
  const auto sizeOf = [&](const std::vector<ArrayError>& errors)
  { return Write(mesh, errors, false, false, 20000)->GetStatistics().ArrayBytes[1]; };
  const auto exact = sizeOf({});
  const auto fine = sizeOf({ { "*", { ErrorKind::Relative, 1e-4, false } } });
  EXPECT_LT(fine, exact / 3);
  EXPECT_LT(sizeOf({ { "*", { ErrorKind::Relative, 1e-2, false } } }), fine - fine / 3);
}

TEST(RoundedArrays, IdsStayExactAndOtherRolesDoNot)
{
  // The numbers of roles are those of vtkDataSetAttributes: tensors, global ids, pedigree ids.
  constexpr std::uint32_t tensors = 1u << 4, globalIds = 1u << 5, pedigreeIds = 1u << 6;
  const auto make = [](std::uint32_t roles) {
    return ArrayDescription{ "a", Association::Point, ScalarType::Float64, 9, 0, roles, {} };
  };
  const ErrorBound bound{ ErrorKind::Relative, 1e-3, false };
  for (const auto roles : { 0u, 1u, 2u, 4u, 8u, tensors, 1u << 7 })
  {
    EXPECT_EQ(FindBound({ { "*", bound } }, make(roles)), bound) << roles;
    EXPECT_NO_THROW(CheckErrors({ make(roles) }, { { "a", bound } })) << roles;
  }
  for (const auto roles : { globalIds, pedigreeIds, pedigreeIds | 1u })
  {
    EXPECT_EQ(FindBound({ { "*", bound } }, make(roles)), ErrorBound()) << roles;
    EXPECT_THROW(CheckErrors({ make(roles) }, { { "a", bound } }), Error) << roles;
  }
}

TEST(RoundedArrays, NoValuesMayHaveNoAddress)
{
  // With UndefinedBehaviorSanitizer, arithmetic with null pointers fails.
  for (const std::uint32_t component : { 0u, 2u })
  {
    for (const auto kind : { ErrorKind::None, ErrorKind::Absolute, ErrorKind::Relative })
    {
      const RoundingRequest request{ { kind, 0.5, false }, false };
      const auto domain = FindDomain(
        ScalarType::Float32, nullptr, 0, 3, component, PaletteUse::Array, nullptr, request);
      EXPECT_EQ(static_cast<bool>(domain.GetQuantizer()), kind == ErrorKind::Absolute);
    }
  }
}

TEST(RoundedArrays, RefuseImpossibleBounds)
{
  const auto mesh = MakeCubes(2, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expectRefused = [&](const std::string& name, ErrorKind kind, double bound)
  {
    EXPECT_THROW(Write(mesh, { { name, { kind, bound, false } } }, false), Error)
      << name << " " << bound;
  };
  for (const double bound : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    for (const auto kind :
      { ErrorKind::Absolute, ErrorKind::Relative, ErrorKind::Pointwise, ErrorKind::Bits })
    {
      expectRefused("*", kind, bound);
    }
  }
  expectRefused("missing", ErrorKind::Absolute, 1);
  expectRefused("ids", ErrorKind::Absolute, 1);
  expectRefused("float", ErrorKind::Absolute, 1e39);
  expectRefused("float", ErrorKind::Relative, 1.5);
  expectRefused("float", ErrorKind::Pointwise, 1);
  expectRefused("float", ErrorKind::Bits, 2.5);
  expectRefused("float", static_cast<ErrorKind>(9), 1);
  expectRefused("integers", ErrorKind::Bits, 8);
  for (const char* text : { "", "float", "float=abs", "float=abs:", "float=abs:x", "float=far:1",
         "float=abs:1 ", "float=abs:1e999", "float=abs:1,one", "float=,zeros", "abs:1" })
  {
    EXPECT_THROW(ParseError(text), Error) << text;
  }
  const auto parsed = ParseError("a=b=rel:1e-3,zeros");
  EXPECT_EQ(parsed.Array, "a=b");
  EXPECT_EQ(parsed.Bound, (ErrorBound{ ErrorKind::Relative, 1e-3, true }));
  for (const char* text : { "abs:0.5", "rel:0.001,zeros", "pw:0.25", "bits:12,zeros" })
  {
    EXPECT_EQ(ToString(ParseBound(text).value()), text);
  }
}
}
