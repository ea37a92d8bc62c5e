// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A mesh with arrays, steps and field data, written and read: what comes back must be what went in.

#if defined(__GNUC__) && !defined(__clang__)
// GCC 12 sees the comparison of two vectors of bytes read more bytes than there are.
#pragma GCC diagnostic ignored "-Wstringop-overread"
#endif

#include "fuzzFiles.h"
#include "fuzzMeshes.h"
#include "gatunExactBound.h"
#include "gatunFileReader.h"
#include "gatunFileWriter.h"
#include "gatunPieceDecoder.h"
#include "gatunVerifyFile.h"
#include "gatunWithType.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include <unistd.h>

namespace
{
using namespace gatun;

void Require(bool right)
{
  if (!right)
  {
    std::abort();
  }
}

struct Values
{
  ArrayDescription Description;
  ErrorBound Bound;
  std::vector<Bytes> Steps;
};

struct Content
{
  MeshInput Mesh;
  Bytes Coordinates;
  std::vector<std::int64_t> Ids;
  std::vector<Values> Arrays;
  std::vector<FieldData> Field; // one a step
  WriterOptions Options;
};

/** Values of a type; often the same, or in a row, or the same as the step before. */
Bytes TakeValues(fuzz::Input& in, ScalarType type, std::size_t count, const Bytes* before)
{
  const auto size = SizeOf(type);
  Bytes values(count * size);
  const Domain domain(type);
  const auto how = in.TakeUpTo(3);
  if (how == 3 && before)
  {
    values = *before;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (how == 3 && in.GetRemaining() > 0 && in.TakeUpTo(7) != 0)
    {
      continue;
    }
    const Key key = how == 0 ? domain.FromNumber(7)
      : how == 1             ? domain.FromNumber(static_cast<double>(i % 11))
                             : fuzz::TakeKey(in, domain);
    domain.Write(key, values.data() + i * size);
  }
  return values;
}

/** Bounds of errors of arrays that have a name of their own. */
void TakeErrors(fuzz::Input& in, Content& content)
{
  constexpr std::array bounds{ 1.0, 0.5, 0.1, 1e-3, 1e-9, 1e-300 };
  for (auto& array : content.Arrays)
  {
    const auto how = in.Take<std::uint8_t>();
    const auto& name = array.Description.Name;
    const auto same = std::count_if(content.Arrays.begin(), content.Arrays.end(),
      [&](const Values& other) { return other.Description.Name == name; });
    if (how < 128 || same > 1)
    {
      continue;
    }
    const bool isFloating = IsFloating(array.Description.Type);
    auto& bound = array.Bound;
    bound.Kind = static_cast<ErrorKind>(1 + how % (isFloating ? 4u : 2u));
    bound.KeepZeros = (how & 64) != 0;
    bound.Bound = bounds[in.Take<std::uint8_t>() % bounds.size()];
    bound.Bound = bound.Kind == ErrorKind::Bits ? 1 + how % 23
      : bound.Kind == ErrorKind::Pointwise      ? 0.5 * bound.Bound
      : isFloating || bound.Bound < 1           ? bound.Bound
                                                : 1 + how % 32;
    if (bound.Kind == ErrorKind::Relative)
    {
      bound.Bound = std::min(1.0, bound.Bound);
    }
    content.Options.Errors.push_back({ name, bound });
  }
}

Content TakeContent(fuzz::Input& in)
{
  Content content;
  content.Options.ChunkSize = 64;
  content.Options.Keep = static_cast<std::uint8_t>(in.TakeUpTo(15)) & KeepAll;
  content.Options.Keep |= in.TakeBool() ? KeepAll : KeepNone;
  content.Options.KeyStepInterval = 1 + in.TakeUpTo(2);
  const auto arrays = in.TakeUpTo(3);
  const auto steps = in.TakeUpTo(3);
  content.Arrays.resize(arrays);
  for (auto& array : content.Arrays)
  {
    array.Description.Name = std::string(in.TakeUpTo(3), 'a');
    array.Description.Type = static_cast<ScalarType>(1 + in.TakeUpTo(9));
    array.Description.Where = in.TakeBool() ? Association::Point : Association::Cell;
    array.Description.Components = 1 + in.TakeUpTo(3);
  }
  std::uint32_t points = 0;
  for (const auto& tet : fuzz::TakeTets(in, 400, points))
  {
    content.Ids.insert(content.Ids.end(), tet.begin(), tet.end());
  }
  points += in.TakeUpTo(3); // of no tetrahedron
  content.Mesh.Points = points;
  content.Mesh.CoordinateType = in.TakeBool() ? ScalarType::Float32 : ScalarType::Float64;
  content.Mesh.Cells = content.Ids.size() / 4;
  content.Coordinates =
    TakeValues(in, content.Mesh.CoordinateType, std::size_t{ 3 } * points, nullptr);
  for (std::uint32_t step = 0; step < steps; ++step)
  {
    for (auto& array : content.Arrays)
    {
      const auto tuples = static_cast<std::size_t>(
        array.Description.Where == Association::Point ? points : content.Mesh.Cells);
      array.Steps.push_back(TakeValues(in, array.Description.Type,
        tuples * array.Description.Components, step > 0 ? &array.Steps.back() : nullptr));
    }
    FieldData field(in.TakeUpTo(2));
    for (auto& array : field)
    {
      array.Name = std::string(in.TakeUpTo(3), 'f');
      array.IsText = in.TakeBool();
      if (array.IsText)
      {
        const auto text = in.TakeBytes(in.TakeUpTo(9));
        array.Texts.assign(1 + in.TakeUpTo(2), { text.begin(), text.end() });
      }
      else
      {
        array.Values = TakeValues(in, array.Type, in.TakeUpTo(9), nullptr);
      }
    }
    content.Field.push_back(field);
  }
  TakeErrors(in, content);
  content.Mesh.Coordinates = content.Coordinates.data();
  content.Mesh.Connectivity = content.Ids.data();
  return content;
}

void Write(const std::string& path, const Content& content)
{
  std::vector<ArrayDescription> arrays;
  for (const auto& array : content.Arrays)
  {
    arrays.push_back(array.Description);
  }
  FileWriter writer(path, content.Mesh, arrays, content.Options);
  const auto steps = content.Field.size();
  for (std::size_t step = 0; step < steps; ++step)
  {
    std::vector<const void*> values;
    for (const auto& array : content.Arrays)
    {
      values.push_back(array.Steps[step].data());
    }
    writer.WriteStep(values, content.Field[step], steps > 1, static_cast<double>(step));
  }
  writer.Finish();
}

/** Tuples in the order of their bytes, for files that do not keep the original one. */
std::vector<Bytes> Sort(const Bytes& values, std::size_t size)
{
  std::vector<Bytes> tuples;
  for (std::size_t i = 0; i < values.size(); i += size)
  {
    const auto* tuple = values.data() + i;
    tuples.emplace_back(tuple, tuple + size);
  }
  std::sort(tuples.begin(), tuples.end());
  return tuples;
}

void RequireSame(const Bytes& decoded, const Bytes& right, std::size_t size, bool inOrder)
{
  Require(inOrder ? decoded == right : Sort(decoded, size) == Sort(right, size));
}

/** Each value is within its bound. */
void RequireWithin(const Bytes& decoded, const Bytes& right, const Values& array)
{
  WithType(array.Description.Type, static_cast<const void*>(right.data()),
    [&](const auto* typed)
    {
      const auto* const found = reinterpret_cast<decltype(typed)>(decoded.data());
      const std::size_t components = array.Description.Components;
      const std::size_t count = right.size() / sizeof(*typed);
      for (std::size_t c = 0; count > 0 && c < components; ++c)
      {
        const test::ExactBound exact(array.Bound, typed + c, count / components, components);
        for (std::size_t i = c; i < count; i += components)
        {
          Require(exact.IsWithin(typed[i], found[i]));
        }
      }
    });
}

void CheckStep(
  PieceDecoder& decoder, const Content& content, PieceRequest& request, std::size_t step)
{
  const auto points = static_cast<std::size_t>(content.Mesh.Points);
  const auto tets = static_cast<std::size_t>(content.Mesh.Cells);
  request.Step = step;
  decoder.SetRequest(request);
  Require(decoder.GetNumberOfPoints() == points && decoder.GetNumberOfCells() == tets);
  Bytes coordinates(content.Coordinates.size());
  std::vector<std::int64_t> ids(4 * tets);
  std::vector<Bytes> values;
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = ids.data();
  for (const auto a : request.Arrays)
  {
    values.emplace_back(content.Arrays[a].Steps[step].size());
    target.Arrays.push_back(values.back().data());
  }
  decoder.Fill(target);
  const auto keep = content.Options.Keep;
  RequireSame(
    coordinates, content.Coordinates, 3 * SizeOf(content.Mesh.CoordinateType), keep & KeepPoints);
  Require(keep != KeepAll || ids == content.Ids);
  for (const auto a : request.Arrays)
  {
    const auto& array = content.Arrays[a].Description;
    const bool inOrder = keep & (array.Where == Association::Point ? KeepPoints : KeepCells);
    if (content.Arrays[a].Bound)
    {
      if (inOrder)
      {
        RequireWithin(values[a], content.Arrays[a].Steps[step], content.Arrays[a]);
      }
      continue;
    }
    RequireSame(
      values[a], content.Arrays[a].Steps[step], array.Components * SizeOf(array.Type), inOrder);
  }
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::UseOneThread();
  static const std::string path =
    (std::filesystem::is_directory("/dev/shm") ? std::filesystem::path("/dev/shm")
                                               : std::filesystem::temp_directory_path()) /
    ("gatun-" + std::to_string(::getpid()) + ".gtn");
  fuzz::Input in(data, size);
  const auto content = TakeContent(in);
  Write(path, content);
  const auto file = std::make_shared<FileReader>(path);
  std::filesystem::remove(path);
  Require(VerifyFile(*file));
  PieceRequest request;
  request.Chunks.resize(file->GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.WithUnusedPoints = true;
  const auto steps = content.Field.size();
  Require(file->GetNumberOfSteps() == steps);
  if (steps > 0)
  {
    request.Arrays.resize(content.Arrays.size());
    std::iota(request.Arrays.begin(), request.Arrays.end(), 0u);
  }
  PieceDecoder decoder(file);
  for (std::size_t i = std::max<std::size_t>(steps, 1); i-- > 0;)
  {
    Require(steps == 0 || file->GetFieldData(i) == content.Field[i]);
    CheckStep(decoder, content, request, i);
  }
  return 0;
}
