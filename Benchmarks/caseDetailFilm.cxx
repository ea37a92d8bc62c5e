// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// detail-film: pictures on the way into a mesh with few points, simplified everywhere alike and for
// the view, as they look and with the sizes of the tetrahedra as colors.

#include "benchCases.h"
#include "benchPixels.h"
#include "benchScene.h"

#include "gatunFileLevelsOfDetail.h"
#include "gatunFileReader.h"
#include "gatunRayCaster.h"

#include "vtkCamera.h"
#include "vtkNew.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace bench
{
namespace
{
struct DetailFilmOptions
{
  std::string File;
  std::string Folder;
  std::string Array = "Density";
  int Size = 192;
  int Frames = 24;
  std::uint64_t Points = 10000;
};

/** The length of the edges of a regular tetrahedron of the same volume. */
double GetEdge(const gatun::RayBlock& block, const gatun::RayBlock::Tet& tet)
{
  std::array<std::array<double, 3>, 3> u{};
  const gatun::RayPoint& o = block.Points[tet[0]];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const gatun::RayPoint& p = block.Points[tet[i + 1]];
    u[i] = { p.X - o.X, p.Y - o.Y, p.Z - o.Z };
  }
  const double volume = std::abs(u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) +
                          u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
                          u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0])) /
    6;
  return std::cbrt(6 * std::sqrt(2.0) * volume);
}

/** The blocks of another source, with the logarithms of the sizes of tetrahedra as values. */
class Sizes final : public gatun::RaySource
{
public:
  Sizes(std::shared_ptr<gatun::RaySource> source, const gatun::Range& range)
    : Source(std::move(source))
    , All(range)
  {
  }

  std::size_t GetNumberOfBlocks() const override { return this->Source->GetNumberOfBlocks(); }
  const gatun::Bounds& GetBounds(std::size_t block) const override
  {
    return this->Source->GetBounds(block);
  }
  gatun::Range GetRange(std::size_t) const override { return this->All; }

  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override
  {
    auto result = this->Source->GetBlocks(blocks, progress);
    for (auto& block : result)
    {
      auto tinted = std::make_shared<gatun::RayBlock>(*block);
      tinted->SetValues(gatun::Association::Cell,
        [&](std::size_t tet)
        {
          const double edge = std::log2(GetEdge(*tinted, tinted->Tets[tet]));
          return std::clamp(edge, this->All.Min, this->All.Max);
        });
      block = std::move(tinted);
    }
    return result;
  }

private:
  std::shared_ptr<gatun::RaySource> Source;
  gatun::Range All;
};

Pixels Cast(gatun::RaySource& source, const gatun::RayView& view, const gatun::RayTable& table)
{
  gatun::RayCaster caster(view, table);
  caster.Draw(source);
  Pixels pixels(4 * static_cast<std::size_t>(view.Width) * view.Height);
  caster.Finish(pixels.data());
  return pixels;
}

void Film(const DetailFilmOptions& options)
{
  const auto file = std::make_shared<const gatun::FileReader>(options.File);
  const Scene scene = MakeScene(*file, options.Array);
  gatun::FileLevelsOfDetail levels(
    file, gatun::RayValues{ FindPointArray(*file, options.Array), 0, 0 });
  constexpr double farthest = 0.6; // beyond it there is little to be seen but one color
  constexpr std::uint64_t budget = std::uint64_t{ 1 } << 30;
  const double diagonal = std::hypot(
    scene.Box[1] - scene.Box[0], scene.Box[3] - scene.Box[2], scene.Box[5] - scene.Box[4]);
  // From a two-hundredth of the size of the mesh to a twentieth, dense enough to show what is near.
  Scene sizes = scene;
  sizes.Values = { std::log2(diagonal / 200), std::log2(diagonal / 20) };
  sizes.Opacities = { 0.5, 0.5 };
  for (int i = 0; i < options.Frames; ++i)
  {
    vtkNew<vtkCamera> camera;
    scene.Approach(camera, farthest * i / options.Frames);
    const gatun::RayView view = scene.MakeView(options.Size, camera);
    const auto table = scene.MakeTable(view, gatun::RayMode::Composite);
    const auto detail = std::make_shared<const gatun::DetailView>(
      gatun::DetailView{ view, 0, std::make_shared<const gatun::RayTable>(table) });
    for (const bool follows : { false, true })
    {
      const auto level =
        levels.MakeLevel({ options.Points, follows ? detail : nullptr }, budget, {});
      const char* const name = follows ? "view" : "uniform";
      WritePicture(Cast(*level.Source, view, table), options.Size,
        fmt::format("{}/{}-{:03}.png", options.Folder, name, i));
      Sizes tinted(level.Source, { sizes.Values[0], sizes.Values[1] });
      WritePicture(Cast(tinted, view, sizes.MakeTable(view, gatun::RayMode::Composite)),
        options.Size, fmt::format("{}/{}-sizes-{:03}.png", options.Folder, name, i));
    }
  }
}
}

//------------------------------------------------------------------------------
void AddDetailFilm(CLI::App& app)
{
  auto options = std::make_shared<DetailFilmOptions>();
  CLI::App* command = app.add_subcommand("detail-film",
    "Writes pictures on the way into a mesh, simplified everywhere alike and for the view, to a "
    "folder, also with the sizes of tetrahedra as colors; prints nothing");
  command->add_option("FILE", options->File, "A .gtn file with a hierarchy")->required();
  command->add_option("FOLDER", options->Folder, "The folder for the pictures")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_option("--frames", options->Frames, "Pictures on the way")
    ->check(CLI::Range(1, 100000));
  command->add_option("--points", options->Points, "Points of the simplified meshes");
  command->callback([options] { Film(*options); });
}
}
