// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn render: renders a mesh as a volume, or a surface, into an image.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnProgress.h"
#include "gtnReaders.h"
#include "gtnRenderImage.h"
#include "gtnRenderInput.h"
#include "gtnRenderOptions.h"
#include "gtnRenderStatistics.h"
#include "gtnSurfaceRender.h"
#include "gtnText.h"

#include "vtkGatunDefaults.h"
#include "vtkGatunDetailPolicy.h"
#include "vtkGatunRayCaster.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVolumeProperty.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace gtn
{
namespace
{

Statistics StatisticsOf(vtkGatunRayCaster* caster)
{
  vtkTable* const table = caster->GetStatistics();
  const auto get = [table](const char* name) { return table->GetValueByName(0, name).ToDouble(); };
  return {
    { "fetchSeconds", "  decoding, all threads", Statistic::Seconds, get("FetchSeconds") },
    { "simplifySeconds", "    of these, merging points", Statistic::Seconds,
      get("SimplifySeconds") },
    { "orderSeconds", "  projecting and ordering", Statistic::Seconds, get("OrderSeconds") },
    { "setUpSeconds", "  planes of faces", Statistic::Seconds, get("SetUpSeconds") },
    { "drawSeconds", "  rays", Statistic::Seconds, get("DrawSeconds") },
    { "finishSeconds", "  fragments into pixels", Statistic::Seconds, get("FinishSeconds") },
    { "tets", "tetrahedra of drawn chunks", Statistic::Count, get("DrawnTetrahedra") },
    { "points", "points of the simplified mesh", Statistic::Count, get("DrawnPoints") },
    { "seenTets", "  seen", Statistic::Count, get("SeenTetrahedra") },
    { "chunks", "chunks drawn", Statistic::Count, get("DrawnChunks") },
    { "skippedChunks", "chunks skipped", Statistic::Count, get("SkippedChunks") },
    { "mostWaiting", "most tetrahedra waiting", Statistic::Count, get("MostWaitingTetrahedra") },
    { "mostFragments", "most fragments", Statistic::Count, get("MostFragments") },
    { "mostBytes", "most for image and chunks", Statistic::Bytes, get("MostBytes") },
  };
}

/** Where and how far the mesh is simplified. */
void SetDetail(const RenderOptions& options, vtkGatunDetailPolicy* policy)
{
  policy->SetSimplificationRatio(options.Ratio);
  policy->SetJustInTime(options.TimeBudget > 0);
  policy->SetTimeBudget(options.TimeBudget);
  policy->SetViewDependent(!options.Uniform);
  policy->SetPixelError(options.PixelError);
}

void Render(const RenderOptions& options, const Settings& settings)
{
  CheckImage(options);
  std::unique_ptr<const RenderInput> input;
  {
    Progress progress("reading", settings.ShowProgress);
    input = std::make_unique<const RenderInput>(options.Input, progress);
  }
  const ImageContent content{ options.Input.File, input->GetArray(), input->GetRange() };
  // There is no next image for which decoded chunks could be kept.
  constexpr int memory = 0;
  vtkNew<vtkGatunDefaults> defaults;
  input->Connect(defaults, memory);
  // The largest value along a ray has no length.
  const auto kind = options.BlendMode == vtkGatunRayCaster::MAXIMUM_INTENSITY_BLEND
    ? OpacityKind::Ramp
    : OpacityKind::Structure;
  const vtkSmartPointer<vtkVolumeProperty> property =
    MakeImageProperty(options, content, defaults, input->GetBounds(), kind);
  property->SetShade(options.Shade);

  vtkNew<vtkGatunRayCaster> caster;
  caster->SetSize(options.Width, options.Height);
  caster->SetBlendMode(options.BlendMode);
  caster->SetMemoryBudget(memory);
  SetDetail(options, caster->GetDetailPolicy());
  caster->SetProperty(property);
  input->Connect(caster, memory);
  const auto render = [&](vtkCamera* camera, Progress& progress)
  {
    caster->SetCamera(camera);
    progress.Watch(caster);
    input->Draw(caster);
    return caster->GetOutput();
  };
  const RenderedImage rendered = RenderImage(options, settings,
    { content, input->GetBounds(), defaults, render, [&] { return StatisticsOf(caster); } });

  Json::Value json;
  json["input"] = options.Input.File;
  json["tets"] = Json::UInt64{ input->GetNumberOfTets() };
  json["array"] = input->GetArray();
  json["component"] = input->GetComponent();
  json["mode"] = NameOfMode(options.BlendMode);
  json["unitDistance"] = property->GetScalarOpacityUnitDistance();
  json["shaded"] = property->GetShade() != 0;
  PrintImage(options, settings, rendered,
    fmt::format("'{}' of {} tetrahedra", MakePrintableLine(input->GetArray()),
      GroupDigits(input->GetNumberOfTets())),
    json);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddRender(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = AddRenderOptions(app, settings, *options);
  command->callback(
    [options, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      if (IsSurfaceFile(options->Input.File))
      {
        RenderSurface(*options, settings);
      }
      else
      {
        Render(*options, settings);
      }
    });
}
}
