// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnCamera.h"

#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnText.h"

#include "vtkGatunDefaults.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gtn
{
namespace
{

using Vector = std::array<double, 3>;

// The values in a file, any of which may be missing.
struct CameraFile
{
  std::optional<Vector> Position;
  std::optional<Vector> FocalPoint;
  std::optional<Vector> ViewUp;
  std::optional<double> ViewAngle;
  std::optional<double> ParallelScale;
};

std::optional<Vector> ReadVector(
  const Json::Value& root, const std::string& file, const std::string& name)
{
  if (!root.isMember(name))
  {
    return {};
  }
  const std::vector<double> numbers = NumbersOf(root[name], file, name);
  if (numbers.size() != 3)
  {
    throw Failure(file, fmt::format("{} has {} numbers, not three", name, numbers.size()));
  }
  return Vector{ numbers[0], numbers[1], numbers[2] };
}

// A number above zero and below a limit.
std::optional<double> ReadPositive(
  const Json::Value& root, const std::string& file, const std::string& name, double limit)
{
  if (!root.isMember(name))
  {
    return {};
  }
  const Json::Value& value = root[name];
  if (!value.isNumeric() || !(value.asDouble() > 0 && value.asDouble() < limit))
  {
    throw Failure(file,
      limit < 1e300
        ? fmt::format("{} is not a number above 0 and below {}", name, DescribeNumber(limit))
        : name + " is not a number above 0");
  }
  return value.asDouble();
}

CameraFile ReadCameraFile(const std::string& file)
{
  const Json::Value root = ReadJson(file);
  if (!root.isObject())
  {
    throw Failure(file, "is not a camera: it holds no object");
  }
  const std::array<std::string, 5> known{ "position", "focalPoint", "viewUp", "viewAngle",
    "parallelScale" };
  for (const std::string& name : root.getMemberNames())
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      throw Failure(file,
        fmt::format("'{}' is nothing that a camera has; there are {}", MakePrintableLine(name),
          Join({ known.begin(), known.end() })));
    }
  }
  CameraFile camera;
  camera.Position = ReadVector(root, file, known[0]);
  camera.FocalPoint = ReadVector(root, file, known[1]);
  camera.ViewUp = ReadVector(root, file, known[2]);
  camera.ViewAngle = ReadPositive(root, file, known[3], 180);
  camera.ParallelScale = ReadPositive(root, file, known[4], 1e300);
  return camera;
}

/** Looks along z at the middle of a box, from so far that all of it is seen. */
void LookAt(vtkCamera* camera, const gatun::Bounds& box, double aspect)
{
  Vector center{};
  double radius = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    center[i] = box[i].Min / 2 + box[i].Max / 2;
    radius = std::hypot(radius, box[i].Max / 2 - box[i].Min / 2);
  }
  radius = radius > 0 ? radius : 0.5; // a lone point
  const double narrow = std::min(1., aspect);
  const double tangent = narrow * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2);
  camera->SetFocalPoint(center.data());
  camera->SetPosition(center[0], center[1], center[2] + radius / std::sin(std::atan(tangent)));
  camera->SetParallelScale(radius / narrow);
}

void Apply(const CameraFile& wanted, vtkCamera* camera)
{
  if (wanted.FocalPoint)
  {
    // Without a position of its own the camera comes along.
    Vector position{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      position[i] = camera->GetPosition()[i] - camera->GetFocalPoint()[i] + (*wanted.FocalPoint)[i];
    }
    camera->SetFocalPoint(wanted.FocalPoint->data());
    camera->SetPosition(position.data());
  }
  if (wanted.Position)
  {
    camera->SetPosition(wanted.Position->data());
  }
  if (wanted.ParallelScale)
  {
    camera->SetParallelScale(*wanted.ParallelScale);
  }
}

// Where there is no direction, or up is along it, vtkCamera makes up something else.
void RequireView(vtkCamera* camera, const CameraFile& wanted, const std::string& file)
{
  Vector direction{};
  vtkMath::Subtract(camera->GetFocalPoint(), camera->GetPosition(), direction.data());
  if (!(vtkMath::Normalize(direction.data()) > 0))
  {
    throw Failure(file, "position and focalPoint are the same");
  }
  Vector up{};
  camera->GetViewUp(up.data());
  up = wanted.ViewUp.value_or(up);
  Vector across{};
  const double length = vtkMath::Normalize(up.data());
  vtkMath::Cross(direction.data(), up.data(), across.data());
  if (!(length > 0) || !(vtkMath::Norm(across.data()) > 1e-6))
  {
    throw Failure(file, "viewUp has no direction across the view");
  }
}

// As vtkCamera::Elevation, but up goes along, so that one can look from straight above.
void Elevate(vtkCamera* camera, double degrees)
{
  camera->OrthogonalizeViewUp();
  vtkMatrix4x4* const toEye = camera->GetViewTransformMatrix();
  const std::array<double, 4> rotation{ vtkMath::RadiansFromDegrees(degrees),
    -toEye->GetElement(0, 0), -toEye->GetElement(0, 1), -toEye->GetElement(0, 2) };
  Vector arm{};
  vtkMath::Subtract(camera->GetPosition(), camera->GetFocalPoint(), arm.data());
  Vector raised{};
  vtkMath::RotateVectorByWXYZ(arm.data(), rotation.data(), raised.data());
  Vector up{};
  vtkMath::RotateVectorByWXYZ(camera->GetViewUp(), rotation.data(), up.data());
  const double* const center = camera->GetFocalPoint();
  camera->SetPosition(center[0] + raised[0], center[1] + raised[1], center[2] + raised[2]);
  camera->SetViewUp(up.data());
}

// Turns the camera the other way, which is the same to see.
void Turn(vtkCamera* camera, const Vector& turns)
{
  const auto toScene = [&turns](Vector vector)
  {
    for (std::size_t axis = 3; axis-- > 0;)
    {
      std::array<double, 4> rotation{ -vtkMath::Pi() * turns[axis], 0, 0, 0 };
      rotation[axis + 1] = 1;
      Vector turned{};
      vtkMath::RotateVectorByWXYZ(vector.data(), rotation.data(), turned.data());
      vector = turned;
    }
    return vector;
  };
  const Vector forward = toScene({ 0, 0, 1 });
  const Vector up = toScene({ 0, -1, 0 });
  const double distance = camera->GetDistance();
  const double* const center = camera->GetFocalPoint();
  camera->SetPosition(center[0] - distance * forward[0], center[1] - distance * forward[1],
    center[2] - distance * forward[2]);
  camera->SetViewUp(up.data());
}

/** If z is up, looks along y instead of z, unless the file tells from where to look. */
void LookAcross(vtkCamera* camera, const CameraFile& wanted)
{
  const Vector& up = *wanted.ViewUp;
  if (!wanted.Position && up[0] == 0 && up[1] == 0)
  {
    const double distance = camera->GetDistance();
    const double* const focus = camera->GetFocalPoint();
    camera->SetPosition(focus[0], focus[1] - distance, focus[2]);
  }
}

/** Moves the camera to where the object fills the image, unless the file tells its place. */
void Fit(vtkCamera* camera, const CameraFile& wanted, const CameraSubject& subject)
{
  if (!wanted.Position)
  {
    if (wanted.FocalPoint)
    {
      const Vector& focus = *wanted.FocalPoint;
      subject.Defaults->FitCameraAt(camera, subject.Aspect, focus[0], focus[1], focus[2]);
    }
    else
    {
      subject.Defaults->FitCamera(camera, subject.Aspect);
    }
  }
  if (wanted.ParallelScale)
  {
    camera->SetParallelScale(*wanted.ParallelScale);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCamera> MakeCamera(const CameraOptions& options, const CameraSubject& subject)
{
  const CameraFile wanted = options.File.empty() ? CameraFile() : ReadCameraFile(options.File);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetParallelProjection(options.Parallel ? 1 : 0);
  camera->SetViewAngle(wanted.ViewAngle.value_or(30));
  LookAt(camera, subject.Box, subject.Aspect);
  Apply(wanted, camera);
  if (wanted.ViewUp)
  {
    camera->SetViewUp(wanted.ViewUp->data());
    LookAcross(camera, wanted);
  }
  if (!options.File.empty())
  {
    RequireView(camera, wanted, options.File);
  }
  if (options.Turns)
  {
    Turn(camera, *options.Turns);
  }
  // A given position is kept.
  const bool isPlaced = wanted.Position || options.Turns;
  camera->Azimuth(options.Azimuth.value_or(isPlaced ? 0 : 30));
  Elevate(camera, options.Elevation.value_or(isPlaced ? 0 : 20));
  camera->Roll(options.Roll);
  Fit(camera, wanted, subject);
  camera->Zoom(options.Zoom);
  return camera;
}

//------------------------------------------------------------------------------
Json::Value DescribeCamera(vtkCamera* camera)
{
  const auto vector = [](const double* numbers) { return MakeJsonArray(std::span(numbers, 3)); };
  Json::Value json;
  json["position"] = vector(camera->GetPosition());
  json["focalPoint"] = vector(camera->GetFocalPoint());
  json["viewUp"] = vector(camera->GetViewUp());
  json["viewAngle"] = camera->GetViewAngle();
  json["parallelScale"] = camera->GetParallelScale();
  return json;
}
}
