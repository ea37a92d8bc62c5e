// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnTurntable.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnText.h"
#include "gtnWriteImage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <fmt/core.h>

#include <chrono>

namespace gtn
{
//------------------------------------------------------------------------------
void CheckImages(const ImageOptions& options)
{
  if (!IsImage(options.Out))
  {
    throw UsageError(options.Out + ": the name must end in " + ImageFormats);
  }
  for (const std::string& file : NameImages(options))
  {
    CheckWritable(file, options.Overwrite);
  }
  if (!options.SaveTransfer.empty())
  {
    CheckWritable(options.SaveTransfer, options.Overwrite);
  }
}

//------------------------------------------------------------------------------
RenderedImages RenderImages(
  const ImageOptions& options, const Settings& settings, const Renderer& renderer)
{
  const std::vector<std::string> files = NameImages(options);
  const double aspect = static_cast<double>(options.Width) / options.Height;
  const auto cameras = MakeCameras(
    options.Camera, { renderer.Bounds, renderer.Defaults, aspect, static_cast<int>(files.size()) });
  CheckMessages(renderer.Content.File, settings.Quiet);
  RenderedImages rendered;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    RenderedImage image{ files[i], cameras[i], {} };
    Progress progress(
      files.size() > 1 ? fmt::format("rendering {} of {}", i + 1, files.size()) : "rendering",
      settings.ShowProgress);
    const double bytesBefore = CountBytesRead();
    const auto start = std::chrono::steady_clock::now();
    vtkImageData* const pixels = renderer.Render(image.Camera, progress);
    CheckInterrupt();
    CheckMessages(renderer.Content.File, settings.Quiet);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    image.Taken = { { "seconds", "time", Statistic::Seconds, time.count() },
      { "bytesRead", "bytes read", Statistic::Bytes, CountBytesRead() - bytesBefore } };
    const Statistics more = renderer.GetStatistics();
    image.Taken.insert(image.Taken.end(), more.begin(), more.end());
    // Libraries that are loaded to write an image do not count.
    rendered.PeakMemory = GetPeakMemory();
    WriteImage(pixels, options.Background,
      MakeRemarks(renderer.Content, settings.CommandLine, image.Camera), image.File);
    rendered.Images.push_back(std::move(image));
  }
  return rendered;
}

//------------------------------------------------------------------------------
void PrintImages(const ImageOptions& options, const Settings& settings,
  const RenderedImages& rendered, const std::string& what, Json::Value json)
{
  const std::vector<RenderedImage>& images = rendered.Images;
  std::vector<Statistics> all;
  Json::Value list(Json::arrayValue);
  for (const RenderedImage& image : images)
  {
    all.push_back(image.Taken);
    Json::Value& entry = list.append(JsonOf(image.Taken));
    entry["file"] = image.File;
    entry["camera"] = DescribeCamera(image.Camera);
  }
  const Statistics median = MedianOf(all);
  if (options.Json)
  {
    json["width"] = options.Width;
    json["height"] = options.Height;
    json["images"] = list;
    json["median"] = JsonOf(median);
    json["peakMemory"] = rendered.PeakMemory;
    fmt::print("{}", JsonText(json));
    return;
  }
  if (settings.Quiet && !options.Statistics)
  {
    return;
  }
  const bool many = images.size() > 1;
  fmt::print("{}{}: {} x {}, {}, {:.2f} s{}\n", images.front().File,
    many ? fmt::format(" to {}", FileOf(images.back().File)) : "", options.Width, options.Height,
    what, median.front().Value, many ? " each" : "");
  if (options.Statistics)
  {
    if (many)
    {
      fmt::print("  median of {} images\n", images.size());
    }
    PrintTable(median);
    PrintTable({ { "", "peak memory of the program", Statistic::Bytes, rendered.PeakMemory } });
  }
}
}
