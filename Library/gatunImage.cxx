// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunOpenFile.h"

#include "gatunCoarseRaySource.h"
#include "gatunDefaultOpacity.h"
#include "gatunFileRaySource.h"
#include "gatunFraming.h"
#include "gatunRayCaster.h"
#include "gatunValueSurvey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace gatun
{
namespace
{
using Vector = std::array<double, 3>;

constexpr double DefaultViewAngle = 30; // degrees
constexpr double SamplesPerUnit = 4;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vector Normalized(const Vector& a)
{
  const double length = std::sqrt(Dot(a, a));
  Need(length > 0 && std::isfinite(length), "the camera has no direction");
  return { a[0] / length, a[1] / length, a[2] / length };
}

/** Rows of value and numbers by ascending value, linear in between and constant outside. */
template <std::size_t Size>
std::array<double, Size> Interpolate(
  const std::vector<std::array<double, Size + 1>>& rows, double value)
{
  std::array<double, Size> result{};
  const auto above = std::upper_bound(
    rows.begin(), rows.end(), value, [](double v, const auto& row) { return v < row[0]; });
  const auto& high = above == rows.end() ? rows.back() : *above;
  const auto& low = above == rows.begin() ? rows.front() : *(above - 1);
  const double width = high[0] - low[0];
  const double part = width > 0 ? (value - low[0]) / width : 0;
  for (std::size_t i = 0; i < Size; ++i)
  {
    result[i] = low[i + 1] + part * (high[i + 1] - low[i + 1]);
  }
  return result;
}

template <std::size_t Size>
std::vector<std::array<double, Size>> TakeRows(const double* from, std::size_t count)
{
  std::vector<std::array<double, Size>> rows(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::copy_n(from + Size * i, Size, rows[i].begin());
    Need(i == 0 || rows[i][0] >= rows[i - 1][0], "values of a transfer function do not ascend");
  }
  return rows;
}

/** The eye, and the directions of the image. */
struct Camera
{
  Camera(const gatun_image& image, const FileReader& file, std::size_t step)
  {
    std::copy_n(image.position, 3, this->Eye.begin());
    std::copy_n(image.focal_point, 3, this->View.Back.begin());
    const bool isGiven = this->Eye != this->View.Back;
    const bool hasDirection =
      std::any_of(image.direction, image.direction + 3, [](double number) { return number != 0; });
    Vector back{ 1, 1, 1 };
    for (std::size_t axis = 0; (isGiven || hasDirection) && axis < 3; ++axis)
    {
      back[axis] =
        isGiven ? image.position[axis] - image.focal_point[axis] : -image.direction[axis];
    }
    this->View.Back = Normalized(back);
    Vector up{ image.view_up[0], image.view_up[1], image.view_up[2] };
    if (Dot(up, up) == 0)
    {
      const bool isAlongY = std::abs(this->View.Back[1]) > 0.999;
      up = { 0, isAlongY ? 0. : 1., isAlongY ? 1. : 0. };
    }
    this->View.Right = Normalized(Cross(up, this->View.Back));
    this->View.Up = Cross(this->View.Back, this->View.Right);
    this->View.IsParallel = image.parallel_scale > 0;
    this->View.TangentOfHalfAngle = std::tan(
      (image.view_angle > 0 ? image.view_angle : DefaultViewAngle) * std::numbers::pi / 360);
    this->View.Aspect = static_cast<double>(image.width) / image.height;
    this->Scale = image.parallel_scale;
    if (!isGiven)
    {
      this->Frame(file, step);
    }
    Need(image.zoom >= 0 && std::isfinite(image.zoom), "the zoom is not above 0");
    this->Zoom = image.zoom > 0 ? image.zoom : 1;
  }

  std::array<std::array<double, 4>, 3> GetToEye() const
  {
    const auto row = [&](const Vector& direction)
    {
      return std::array<double, 4>{ direction[0], direction[1], direction[2],
        -Dot(direction, this->Eye) };
    };
    return { row(this->View.Right), row(this->View.Up), row(this->View.Back) };
  }

  /** Of a light at the camera. */
  RayShading GetShading() const
  {
    const auto& back = this->View.Back;
    const std::array<double, 4> backward{ back[0], back[1], back[2], 0 };
    RayShading shading;
    shading.Lights.push_back({ backward });
    shading.Eye = this->View.IsParallel
      ? backward
      : std::array<double, 4>{ this->Eye[0], this->Eye[1], this->Eye[2], 1 };
    return shading;
  }

  RayFrustum GetFrustum() const
  {
    RayFrustum frustum;
    frustum.Parallel = this->View.IsParallel;
    // As vtkCamera::Zoom does it.
    frustum.Top = frustum.Parallel
      ? this->Scale / this->Zoom
      : std::tan(std::atan(this->View.TangentOfHalfAngle) / this->Zoom);
    frustum.Bottom = -frustum.Top;
    frustum.Right = frustum.Top * this->View.Aspect;
    frustum.Left = -frustum.Right;
    return frustum;
  }

private:
  void Frame(const FileReader& file, std::size_t step)
  {
    std::vector<Bounds> boxes;
    for (std::size_t chunk = 0; chunk < file.GetChunks().size(); ++chunk)
    {
      boxes.push_back(file.GetChunkBounds(chunk, 0, step));
    }
    const auto framing = FrameObject(PointBlocks(std::move(boxes)), this->View);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Eye[axis] = framing.FocalPoint[axis] + framing.Distance * this->View.Back[axis];
    }
    this->Scale = this->View.IsParallel ? framing.ParallelScale : this->Scale;
  }

  Vector Eye{};
  FramingView View;
  double Scale = 1;
  double Zoom = 1;
};

/** Colors and opacities of an image: those of the caller, or defaults. */
class Transfer
{
public:
  Transfer(const gatun_image& image, double unitDistance, RaySource& source, const Range& range)
  {
    Need(image.colors || image.color_count == 0, "the colors are missing");
    Need(image.opacities || image.opacity_count == 0, "the opacities are missing");
    this->Colors = TakeRows<4>(image.colors, image.color_count);
    this->Opacities = TakeRows<2>(image.opacities, image.opacity_count);
    Need(image.range[0] <= image.range[1], "the range is empty");
    const bool hasRange = image.range[0] < image.range[1];
    Range over{ image.range[0], image.range[1] };
    std::optional<DefaultTransfer> defaults;
    const bool needsRange = this->Colors.empty() || image.spread_colors;
    const bool needsOpacities = this->Opacities.empty() && image.blend == GATUN_COMPOSITE;
    if (needsOpacities || (needsRange && !hasRange))
    {
      const auto given = hasRange ? std::optional(over) : std::nullopt;
      defaults = MakeDefaultTransfer(SurveyValues(source, given), unitDistance, given);
      over = defaults->Colors;
    }
    if (this->Colors.empty())
    {
      for (const auto& color : GetDefaultColors())
      {
        this->Colors.push_back({ color.Value, color.RGB[0], color.RGB[1], color.RGB[2] });
      }
    }
    for (auto& color : this->Colors)
    {
      color[0] = needsRange ? over.Min + color[0] * (over.Max - over.Min) : color[0];
    }
    if (this->Opacities.empty())
    {
      const double scale = image.opacity_scale != 0 ? image.opacity_scale : 1;
      Need(scale > 0 && std::isfinite(scale), "the scale of opacities is not above 0");
      if (image.blend == GATUN_COMPOSITE)
      {
        for (const auto& node : defaults->Opacities)
        {
          this->Opacities.push_back({ node.Value, std::min(scale * node.Opacity, 1.) });
        }
      }
      else
      {
        const Range& values = hasRange ? over : range;
        for (const auto& node : GetDefaultRamp())
        {
          this->Opacities.push_back({ values.Min + node.Value * (values.Max - values.Min),
            std::min(scale * node.Opacity, 1.) });
        }
      }
    }
    this->Values = range;
    if (this->Values.IsEmpty())
    {
      this->Values = { 0, 1 };
    }
  }

  RayTable MakeTable(RayMode mode, double sampleDistance, double unitDistance) const
  {
    return RayTable(
      mode,
      [this](double value)
      {
        const auto color = Interpolate<3>(this->Colors, value);
        const auto opacity = Interpolate<1>(this->Opacities, value);
        return std::array<double, 4>{ color[0], color[1], color[2], opacity[0] };
      },
      this->Values, sampleDistance, unitDistance);
  }

private:
  std::vector<std::array<double, 4>> Colors;
  std::vector<std::array<double, 2>> Opacities;
  Range Values;
};

std::unique_ptr<RaySource> MakeSource(
  SharedFile& mesh, const SharedFile::Place& place, const RayValues& values)
{
  auto cache = mesh.MakeView(place.File, true);
  if (place.Merges == 0)
  {
    return std::make_unique<FileRaySource>(std::move(cache), values);
  }
  return std::make_unique<CoarseRaySource>(
    std::move(cache), *place.Tree, MergeCut(*place.Tree, place.Merges), values);
}

RayMode TakeMode(gatun_blend blend)
{
  switch (blend)
  {
    case GATUN_COMPOSITE:
      return RayMode::Composite;
    case GATUN_MAXIMUM:
      return RayMode::Maximum;
    case GATUN_X_RAY:
      return RayMode::XRay;
  }
  ThrowInvalid("there is no such blend mode");
}

void Render(gatun_file& file, const gatun_image& image, float* rgba,
  const std::function<bool(double)>& progress)
{
  const auto place = file.Find(image.step);
  const auto source = gatun_file::Simplify(*place.Mesh, image.level, image.ratio);
  const auto& mesh = *source.File;
  Need(!mesh.IsSurface(), "a surface has no volume to draw");
  const RayValues values{ image.array, image.component, place.Step };
  const auto blocks = MakeSource(*place.Mesh, source, values);
  Range range = Range::MakeEmpty();
  for (std::size_t block = 0; block < blocks->GetNumberOfBlocks(); ++block)
  {
    range.Include(blocks->GetRange(block));
  }
  const double unit = image.unit_distance > 0 ? image.unit_distance
                                              : GetDefaultUnitDistance(mesh.GetBounds(place.Step));
  const Camera camera(image, mesh, place.Step);
  const double sample = unit / SamplesPerUnit;
  const RayView view(camera.GetToEye(), camera.GetFrustum(), static_cast<int>(image.width),
    static_cast<int>(image.height), sample);
  const Transfer transfer(image, unit, *blocks, range);
  RaySettings settings;
  if (image.shade)
  {
    settings.Shading = camera.GetShading();
  }
  RayCaster caster(view, transfer.MakeTable(TakeMode(image.blend), sample, unit), {}, settings);
  caster.Draw(*blocks, progress);
  caster.Finish(rgba);
}
}
}

//------------------------------------------------------------------------------
gatun_status gatun_render(gatun_file* file, const gatun_image* image, const gatun_buffer* rgba,
  gatun_progress progress, void* user)
{
  using namespace gatun;
  return Guard(
    [&]
    {
      NeedPointers(file, image, rgba);
      const auto own = Take(image);
      constexpr std::uint32_t most = 1u << 15;
      Need(own.width > 0 && own.height > 0 && own.width <= most && own.height <= most,
        "the image has no size, or more than 32768 pixels along a side");
      auto* const to = TakeBuffer<float>(
        *rgba, Product(Product(own.width, own.height), 4 * sizeof(float)), "the image");
      Need(to != nullptr, "there is no buffer for the image");
      Render(*file, own, to, WrapProgress(progress, user));
    });
}
