// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFormMaker.h"

#include <algorithm>

namespace gatun
{
namespace
{
constexpr std::uint8_t Unknown = 255;
}

//------------------------------------------------------------------------------
bool IsClosedSurface(SurfaceView faces, unsigned corners)
{
  std::vector<char> edges(std::size_t{ corners } * corners, 0);
  std::vector<std::uint8_t> group(corners); // corners that are connected
  std::vector<char> used(corners, 0);
  for (unsigned i = 0; i < corners; ++i)
  {
    group[i] = static_cast<std::uint8_t>(i);
  }
  const auto find = [&](std::uint8_t corner)
  {
    while (group[corner] != corner)
    {
      corner = group[corner];
    }
    return corner;
  };
  std::size_t count = 0;
  for (std::size_t at = 0; at < faces.size(); at += 1u + faces[at], ++count)
  {
    const auto face = faces.subspan(at + 1, faces[at]);
    if (face.size() < 3)
    {
      return false;
    }
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const auto a = face[i];
      const auto b = face[(i + 1) % face.size()];
      if (a == b || std::count(face.begin(), face.end(), a) != 1 ||
        edges[std::size_t{ a } * corners + b]++ != 0)
      {
        return false;
      }
      used[a] = 1;
      group[find(a)] = find(b);
    }
  }
  for (unsigned a = 0; a < corners; ++a)
  {
    if (!used[a] || find(static_cast<std::uint8_t>(a)) != find(0))
    {
      return false;
    }
    for (unsigned b = 0; b < corners; ++b)
    {
      if (edges[std::size_t{ a } * corners + b] != edges[std::size_t{ b } * corners + a])
      {
        return false;
      }
    }
  }
  return count > 0 && count <= MaxSurfaceFaces;
}

void FormMaker::Make(
  SurfaceView faces, unsigned corners, unsigned gate, unsigned start, bool mirrored)
{
  this->FaceStarts.clear();
  this->FaceOf.resize(std::size_t{ corners } * corners);
  for (std::size_t at = 0; at < faces.size(); at += 1u + faces[at])
  {
    const auto face = faces.subspan(at + 1, faces[at]);
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const auto next = (i + 1) % face.size();
      const auto from = mirrored ? face[next] : face[i];
      const auto to = mirrored ? face[i] : face[next];
      this->FaceOf[std::size_t{ from } * corners + to] = { static_cast<std::uint8_t>(
                                                             this->FaceStarts.size()),
        static_cast<std::uint8_t>(mirrored ? next : i) };
    }
    this->FaceStarts.push_back(static_cast<std::uint16_t>(at + 1));
  }
  const auto getFace = [&](unsigned face)
  { return faces.subspan(this->FaceStarts[face], faces[this->FaceStarts[face] - 1u]); };
  // The corners of a face in the form's direction.
  const auto getCorner = [&](SurfaceView face, std::size_t first, std::size_t step, bool forward)
  { return face[(forward ? first + step : first + face.size() - step) % face.size()]; };

  this->Numbers.assign(corners, Unknown);
  this->Met.assign(this->FaceStarts.size(), 0);
  this->Order.clear();
  this->Code.clear();
  this->Queue.clear();
  this->Places.clear();
  const auto front = getFace(gate);
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    const auto corner = getCorner(front, start, i, mirrored);
    this->Numbers[corner] = static_cast<std::uint8_t>(i);
    this->Order.push_back(corner);
    this->Queue.push_back({ corner, getCorner(front, start, i + 1, mirrored) });
  }
  this->Met[gate] = 1;
  this->Code.push_back(static_cast<std::uint8_t>(front.size()));
  this->Places.push_back({ static_cast<std::uint8_t>(gate), static_cast<std::uint8_t>(start) });

  for (std::size_t head = 0; head < this->Queue.size(); ++head)
  {
    const auto edge = this->Queue[head];
    const auto place = this->FaceOf[std::size_t{ edge[0] } * corners + edge[1]];
    if (this->Met[place.Face])
    {
      continue;
    }
    this->Met[place.Face] = 1;
    this->Places.push_back(place);
    const auto face = getFace(place.Face);
    this->Code.push_back(static_cast<std::uint8_t>(face.size()));
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const auto corner = getCorner(face, place.Start, i, !mirrored);
      auto& number = this->Numbers[corner];
      if (number == Unknown)
      {
        number = static_cast<std::uint8_t>(this->Order.size());
        this->Order.push_back(corner);
      }
      if (i >= 2)
      {
        this->Code.push_back(number);
      }
      this->Queue.push_back({ getCorner(face, place.Start, i + 1, !mirrored), corner });
    }
  }
}
}
