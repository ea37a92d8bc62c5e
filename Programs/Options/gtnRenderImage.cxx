// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRenderImage.h"

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
void CheckImage(const ImageOptions& options)
{
  if (!IsImage(options.Out))
  {
    throw UsageError(options.Out + ": the name must end in " + ImageFormats);
  }
  CheckWritable(options.Out, options.Overwrite);
}

//------------------------------------------------------------------------------
RenderedImage RenderImage(
  const ImageOptions& options, const Settings& settings, const Renderer& renderer)
{
  const double aspect = static_cast<double>(options.Width) / options.Height;
  RenderedImage image{ MakeCamera(options.Camera, { renderer.Bounds, renderer.Defaults, aspect }),
    {} };
  CheckMessages(renderer.Content.File, settings.Quiet);
  Progress progress("rendering", settings.ShowProgress);
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
  image.PeakMemory = GetPeakMemory();
  WriteImage(pixels, options.Background,
    MakeRemarks(renderer.Content, settings.CommandLine, image.Camera), options.Out);
  return image;
}

//------------------------------------------------------------------------------
void PrintImage(const ImageOptions& options, const Settings& settings,
  const RenderedImage& rendered, const std::string& what, Json::Value json)
{
  if (options.Json)
  {
    json["file"] = options.Out;
    json["width"] = options.Width;
    json["height"] = options.Height;
    json["camera"] = DescribeCamera(rendered.Camera);
    json["statistics"] = JsonOf(rendered.Taken);
    json["peakMemory"] = rendered.PeakMemory;
    fmt::print("{}", WriteJson(json));
    return;
  }
  if (settings.Quiet && !options.Statistics)
  {
    return;
  }
  fmt::print("{}: {} x {}, {}, {:.2f} s\n", options.Out, options.Width, options.Height, what,
    rendered.Taken.front().Value);
  if (options.Statistics)
  {
    PrintTable(rendered.Taken);
    PrintTable({ { "", "peak memory of the program", Statistic::Bytes, rendered.PeakMemory } });
  }
}
}
