// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// detail: how far pictures of meshes that are simplified everywhere alike, and of those that are
// simplified for a view, are from the picture of the whole mesh, on the way into it.

#include "benchCases.h"
#include "benchScene.h"

#include "gatunDetailView.h"
#include "gatunFileLevelsOfDetail.h"
#include "gatunFileReader.h"
#include "gatunParallel.h"
#include "gatunRayCaster.h"

#include "vtkCamera.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace bench
{
namespace
{
struct DetailOptions
{
  std::string File;
  std::string Array = "Density";
  int Size = 512;
  int Memory = 1024;
  std::vector<double> Places{ 0, 0.25, 0.5, 0.75, 1 };
};

/** A picture and what it took. */
struct Picture
{
  std::vector<float> Colors;
  gatun::RayStatistics Statistics;
  double Seconds = 0;
};

class Approach
{
public:
  explicit Approach(const DetailOptions& options)
    : Settings(options)
    , File(std::make_shared<const gatun::FileReader>(options.File))
    , Of(MakeScene(*this->File, options.Array))
    , Levels(this->File, gatun::RayValues{ FindPointArray(*this->File, options.Array), 0, 0 })
  {
  }

  void Measure(Json::Value& json)
  {
    json["threads"] = gatun::GetNumberOfThreads();
    json["tets"] = Json::UInt64{ this->File->GetNumberOfTets() };
    json["points"] = Json::UInt64{ this->File->GetNumberOfPoints() };
    json["size"] = this->Settings.Size;
    json["places"] = Json::arrayValue;
    for (const double part : this->Settings.Places)
    {
      this->MeasureAt(json["places"].append(Json::objectValue), part);
    }
  }

private:
  void MeasureAt(Json::Value& json, double part)
  {
    vtkNew<vtkCamera> camera;
    this->Of.Approach(camera, part);
    const auto all = this->Levels.GetNumberOfPoints();
    json["part"] = part;
    json["distance"] = camera->GetDistance();
    const Picture whole = this->Draw(*this->Levels.MakeSource(all, this->GetBudget()), camera);
    json["tets"] = Json::UInt64{ whole.Statistics.Tets };
    json["seconds"] = whole.Seconds;
    json["uniform"] = json["view"] = Json::arrayValue;
    constexpr std::uint64_t fewest = 500;
    const auto least = std::max(fewest, this->Levels.GetFewestPoints());
    for (auto points = all / 2; points >= least; points /= 2)
    {
      this->MeasureLevel(json["uniform"], { points, nullptr }, whole, camera);
      if (points <= all / 8)
      {
        this->MeasureLevel(json["view"], { points, this->GetView(camera) }, whole, camera);
      }
    }
    this->MeasureUpdates(json["updates"], part);
  }

  void MeasureLevel(
    Json::Value& json, const gatun::DetailRequest& request, const Picture& whole, vtkCamera* camera)
  {
    gatun::DetailLevel level;
    Json::Value& entry = json.append(Json::objectValue);
    entry["made"] =
      SecondsOf([&] { level = this->Levels.MakeLevel(request, this->GetBudget(), {}); });
    const Picture picture = this->Draw(*level.Source, camera);
    entry["wanted"] = Json::UInt64{ request.Points };
    entry["points"] = Json::UInt64{ level.Points };
    entry["tets"] = Json::UInt64{ picture.Statistics.Tets };
    entry["seen"] = Json::UInt64{ picture.Statistics.SeenTets };
    entry["seconds"] = picture.Seconds;
    double sum = 0;
    for (std::size_t i = 0; i < whole.Colors.size(); ++i)
    {
      const double difference = 255.0 * (whole.Colors[i] - picture.Colors[i]);
      sum += difference * difference;
    }
    entry["rms"] = std::sqrt(sum / static_cast<double>(whole.Colors.size()));
  }

  /** Times of levels for views that are near each other, each from the one before. */
  void MeasureUpdates(Json::Value& json, double part)
  {
    const auto points = std::max<std::uint64_t>(this->Levels.GetNumberOfPoints() / 64, 20000);
    std::vector<double> cut;
    std::vector<double> blocks;
    std::vector<double> again; // part of the blocks that were made
    gatun::DetailLevel last;
    std::vector<std::shared_ptr<const gatun::RayBlock>> before;
    for (int i = 0; i <= 10; ++i)
    {
      vtkNew<vtkCamera> camera;
      this->Of.Approach(camera, part + 0.01 * i);
      gatun::DetailLevel level;
      const double toCut = SecondsOf(
        [&] {
          level = this->Levels.MakeLevel({ points, this->GetView(camera) }, this->GetBudget(), {});
        });
      std::vector<std::size_t> all(level.Source->GetNumberOfBlocks());
      for (std::size_t block = 0; block < all.size(); ++block)
      {
        all[block] = block;
      }
      gatun::RaySource::Blocks now;
      const double toMake = SecondsOf([&] { now = level.Source->GetBlocks(all, {}); });
      if (i > 0)
      {
        const auto isNew = [&](const auto& block)
        { return std::find(before.begin(), before.end(), block) == before.end(); };
        cut.push_back(toCut);
        blocks.push_back(toMake);
        again.push_back(static_cast<double>(std::count_if(now.begin(), now.end(), isNew)) /
          static_cast<double>(now.size()));
      }
      before = std::move(now);
      last = std::move(level);
    }
    json["points"] = Json::UInt64{ last.Points };
    AddList(json, "cut", cut);
    AddList(json, "blocks", blocks);
    AddList(json, "again", again);
  }

  Picture Draw(gatun::RaySource& source, vtkCamera* camera)
  {
    const gatun::RayView view = this->Of.MakeView(this->Settings.Size, camera);
    Picture picture;
    picture.Seconds = SecondsOf(
      [&]
      {
        gatun::RayCaster caster(view, this->Of.MakeTable(view, gatun::RayMode::Composite));
        caster.Draw(source);
        picture.Colors.resize(4 * static_cast<std::size_t>(view.Width) * view.Height);
        caster.Finish(picture.Colors.data());
        picture.Statistics = caster.GetStatistics();
      });
    return picture;
  }

  std::shared_ptr<const gatun::DetailView> GetView(vtkCamera* camera) const
  {
    const gatun::RayView view = this->Of.MakeView(this->Settings.Size, camera);
    return std::make_shared<const gatun::DetailView>(gatun::DetailView{ view, 0,
      std::make_shared<const gatun::RayTable>(
        this->Of.MakeTable(view, gatun::RayMode::Composite)) });
  }

  std::uint64_t GetBudget() const
  {
    return static_cast<std::uint64_t>(this->Settings.Memory) << 20;
  }

  const DetailOptions& Settings;
  std::shared_ptr<const gatun::FileReader> File;
  Scene Of;
  gatun::FileLevelsOfDetail Levels;
};
}

//------------------------------------------------------------------------------
void AddDetail(CLI::App& app)
{
  auto options = std::make_shared<DetailOptions>();
  CLI::App* command = app.add_subcommand("detail",
    "Tetrahedra and errors of pictures on the way into a mesh, simplified everywhere alike and for "
    "the view");
  command->add_option("FILE", options->File, "A .gtn file with a hierarchy")->required();
  command->add_option("--array", options->Array, "The point array to show");
  command->add_option("--size", options->Size, "Width and height in pixels")
    ->check(CLI::Range(16, 8192));
  command->add_option("--memory", options->Memory, "The memory budget, in MiB")
    ->check(CLI::Range(0, 1048576));
  command->add_option("--places", options->Places, "Parts of the way, 0 to 1")->delimiter(',');
  command->callback(
    [options] { PrintJson([&](Json::Value& json) { Approach(*options).Measure(json); }); });
}
}
