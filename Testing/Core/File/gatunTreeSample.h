// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTreeSample_h
#define gatunTreeSample_h

// Small files with a merge tree and base meshes. FileWriter makes no base meshes of small meshes,
// so they are added to the file afterwards.

#include "gatunFileImage.h"
#include "gatunFileWriter.h"
#include "gatunMergeBuilder.h"
#include "gatunPartition.h"
#include "gatunTestMeshes.h"
#include "gatunTreeTable.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gatun::test
{
/** A mesh with arrays at some steps and a merge tree. */
struct TreeSample
{
  ScalarType CoordinateType = ScalarType::Float64;
  std::vector<double> Coordinates;
  std::vector<float> Singles; // in place of those, if of that type
  std::vector<std::int64_t> Ids;
  std::vector<std::uint8_t> Types;   // of the cells of a surface; otherwise
  std::vector<std::int64_t> Offsets; // all are tetrahedra
  std::vector<ArrayDescription> Arrays;
  std::vector<std::vector<Bytes>> Steps; // values of each array
  bool HasTime = false;
  FieldData Field;
  MergeTree Tree;

  TreeSample() = default;

  explicit TreeSample(const TestMesh& mesh)
    : Coordinates(mesh.Coordinates)
    , Singles(mesh.Coordinates.begin(), mesh.Coordinates.end())
    , Ids(mesh.Ids)
  {
  }

  std::size_t GetPoints() const { return this->Coordinates.size() / 3; }
  bool IsSurface() const { return !this->Types.empty(); }
  std::size_t GetTets() const
  {
    return this->IsSurface() ? this->Types.size() : this->Ids.size() / 4;
  }

  MeshInput GetInput() const
  {
    MeshInput input;
    input.Points = this->GetPoints();
    input.CoordinateType = this->CoordinateType;
    input.Coordinates = this->CoordinateType == ScalarType::Float32
      ? static_cast<const void*>(this->Singles.data())
      : this->Coordinates.data();
    input.Cells = this->GetTets();
    input.Connectivity = this->Ids.data();
    if (this->IsSurface())
    {
      input.Types = this->Types.data();
      input.Offsets = this->Offsets.data();
    }
    return input;
  }

  /** Adds an array; valueOf gives component c of tuple i at a step. */
  template <typename T, typename ValueOf>
  void AddArray(const std::string& name, Association where, ScalarType type,
    std::uint32_t components, std::size_t steps, ValueOf&& valueOf)
  {
    auto& array = this->Arrays.emplace_back();
    array.Name = name;
    array.Where = where;
    array.Type = type;
    array.Components = components;
    constexpr std::int32_t typesOfVTK[] = { 0, 15, 3, 4, 5, 6, 7, 16, 17, 10, 11 };
    array.VTKType = typesOfVTK[static_cast<std::size_t>(type)];
    const auto tuples = where == Association::Point ? this->GetPoints() : this->GetTets();
    this->Steps.resize(steps);
    for (std::size_t step = 0; step < steps; ++step)
    {
      std::vector<T> values;
      for (std::size_t i = 0; i < tuples; ++i)
      {
        for (std::uint32_t c = 0; c < components; ++c)
        {
          values.push_back(static_cast<T>(valueOf(i, c, step)));
        }
      }
      Bytes bytes(values.size() * sizeof(T));
      if (!bytes.empty())
      {
        std::memcpy(bytes.data(), values.data(), bytes.size());
      }
      this->Steps[step].push_back(std::move(bytes));
    }
  }

  /** The usual tree, by a value at each point. */
  void BuildTree(const std::vector<double>& field)
  {
    std::vector<std::array<double, 3>> points(this->GetPoints());
    std::vector<MergeTree::Tet> tets(this->GetTets());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      std::copy_n(&this->Coordinates[3 * i], 3, points[i].begin());
    }
    for (std::size_t i = 0; i < tets.size(); ++i)
    {
      std::copy_n(&this->Ids[4 * i], 4, tets[i].begin());
    }
    this->Tree = BuildMergeTree({ points, tets, { { field, 1 } } });
  }
};

inline Bytes ReadFile(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
}

/** The sections of a file except its directory, with their payloads. */
inline std::vector<FileImage::Section> ReadSections(const std::string& path)
{
  const InputFile file(path);
  std::vector<FileImage::Section> sections;
  for (const auto& section : file.GetSections())
  {
    sections.push_back(
      { section.Name, file.Read(section.Payload, "a section"), section.Version, section.Flags });
  }
  return sections;
}

inline const Bytes& FindPayload(const std::vector<FileImage::Section>& sections, FourCC name)
{
  return std::find_if(
    sections.begin(), sections.end(), [=](const auto& s) { return s.Name == name; })
    ->Payload;
}

/** TREE of a file that has one. */
inline TreeTable ReadTreeTable(const std::vector<FileImage::Section>& sections)
{
  const auto meta = MetaTable::Read(FindPayload(sections, SectionMeta));
  const auto mesh = MeshIndex::Read(FindPayload(sections, SectionTable), meta);
  const bool isSurface = std::any_of(sections.begin(), sections.end(),
    [](const auto& section) { return section.Name == SectionSurface; });
  return TreeTable::Read(FindPayload(sections, SectionTree), meta, mesh.Chunks, isSurface);
}

/** Writes a sample with its tree, and with base meshes after these numbers of merges. */
inline void WriteTreeSample(const std::string& path, const TreeSample& sample,
  WriterOptions options, const std::vector<std::uint32_t>& levels = {})
{
  options.Tree = &sample.Tree;
  options.IsSurface = sample.IsSurface();
  options.LevelMerges = levels;
  FileWriter writer(path, sample.GetInput(), sample.Arrays, options);
  for (std::size_t step = 0; step < sample.Steps.size(); ++step)
  {
    std::vector<const void*> values;
    for (const Bytes& array : sample.Steps[step])
    {
      values.push_back(array.data());
    }
    writer.WriteStep(
      values, sample.Field, sample.HasTime, sample.HasTime ? 0.5 * static_cast<double>(step) : 0);
  }
  writer.Finish();
}

/** Writes a sample with a base mesh after a number of merges. Returns the bytes of that. */
inline Bytes MakeLevel(
  const std::string& path, const TreeSample& sample, WriterOptions options, std::uint32_t merges)
{
  const auto temporary = path + ".level";
  WriteTreeSample(temporary, sample, options, { merges });
  auto bytes = FindPayload(ReadSections(temporary), SectionLevel);
  std::filesystem::remove(temporary);
  return bytes;
}

/** Cubes with a point array of two components and a cell array, and unused points on both ends. */
inline TreeSample MakeTreeSample(std::int64_t n, std::size_t steps)
{
  auto mesh = MakeCubes(n, 0.2);
  mesh.Coordinates.insert(mesh.Coordinates.begin(), { 50, 51, 52 });
  mesh.Coordinates.insert(mesh.Coordinates.end(), { 60, 61, 62 });
  for (auto& id : mesh.Ids)
  {
    ++id;
  }
  TreeSample sample(mesh);
  const auto wave = [&](std::size_t i, std::size_t c, std::size_t step)
  { return sample.Coordinates[3 * i + c] * sample.Coordinates[3 * i] + 0.25 * double(step); };
  std::vector<double> field(sample.GetPoints());
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    field[i] = wave(i, 0, 0);
  }
  sample.BuildTree(field);
  sample.AddArray<float>("wave", Association::Point, ScalarType::Float32, 2, steps, wave);
  sample.AddArray<std::int16_t>("material", Association::Cell, ScalarType::Int16, 1, steps,
    [](std::size_t i, std::size_t, std::size_t step) { return i / 7 + step; });
  sample.HasTime = steps > 1;
  return sample;
}
}

#endif
